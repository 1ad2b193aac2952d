#include "tests/peers/table.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "tests/study/frontier.h"
#include "tests/study/text.h"

namespace peers {
namespace {

std::string number(double value) { return std::isfinite(value) ? study::significant(value, 3) : ""; }

const Scene& scene_of(const std::string& name) {
  return *std::find_if(scenes().begin(), scenes().end(), [&](const Scene& s) { return s.name == name; });
}

/// Formats a length with a suitable unit.
std::string metres(double value) {
  if (!std::isfinite(value)) return "—";
  if (value >= 1.0) return study::significant(value, 3) + " m";
  if (value >= 0.01) return study::significant(100.0 * value, 2) + " cm";
  if (value >= 1e-5) return study::significant(1000.0 * value, 2) + " mm";
  if (value < 1e-9) return value == 0.0 ? "0" : "below 1 nm";
  return study::significant(1e6 * value, 2) + " µm";
}

/// Formats a ratio with two digits: ×0.56, ×3.8, ×230.
std::string times(double ratio) {
  return "×" + (ratio < 99.5 ? study::significant(ratio, 2) : study::fixed(10.0 * std::round(ratio / 10.0), 0));
}

study::Point plotted_point_of(const Result& result) {
  return {result.engine,  result.setting, result.cost_us, result.p99_us,
          result.error_m, result.failure, false,          result.group};
}

double compared_cost(const std::vector<Result>& results, const std::string& group) {
  for (const Result& result : results) {
    if (result.engine == our_name && result.setting == compared_setting && result.group == group) return result.cost_us;
  }
  return Figures::none;
}

std::vector<Result> of_engine(const std::vector<Result>& results, const std::string& engine, const std::string& group) {
  std::vector<Result> some;
  std::copy_if(results.begin(), results.end(), std::back_inserter(some),
               [&](const Result& r) { return r.engine == engine && r.group == group; });
  return some;
}

std::vector<study::Point> points_of(const std::vector<Result>& results) {
  std::vector<study::Point> points;
  std::transform(results.begin(), results.end(), std::back_inserter(points), plotted_point_of);
  return points;
}

std::string cell_of(const std::vector<Result>& results, const std::string& engine, const std::string& group) {
  const std::vector<Result> some = of_engine(results, engine, group);
  if (some.empty()) return "—";
  const std::vector<std::size_t> best = study::front(points_of(some));
  if (best.empty()) return "fails";
  const double compared = compared_cost(results, group);
  const auto words = [&](const Result& r) { return metres(r.error_m) + " " + times(r.cost_us / compared); };
  const std::string cheapest = words(some[best.front()]);
  return best.size() == 1 ? cheapest : cheapest + " … " + words(some[best.back()]);
}

void add_table(std::ostringstream& out, const std::vector<Engine>& engines, const std::vector<std::string>& names,
               const Results& results, bool has_contacts) {
  std::vector<std::pair<std::string, std::string>> columns;
  for (const std::string& name : names) {
    if (scene_of(name).has_contacts != has_contacts) continue;
    for (const std::string& group : study::groups_of(points_of(results.at(name)))) columns.emplace_back(name, group);
  }
  if (columns.empty()) return;
  out << "\n| |";
  for (const auto& [name, group] : columns) out << ' ' << name << (group.empty() ? "" : ", " + group) << " |";
  out << "\n|---|";
  for (std::size_t k = 0; k < columns.size(); ++k) out << "---|";
  out << '\n';
  for (const Engine& engine : engines) {
    out << "| " << engine.name << " |";
    for (const auto& [name, group] : columns) out << ' ' << cell_of(results.at(name), engine.name, group) << " |";
    out << '\n';
  }
}

}  // namespace

std::string csv_of(const std::vector<std::string>& names, const Results& results) {
  std::ostringstream out;
  out << "scene,group,engine,setting,us_per_tick,p99_us,error_m,stretch_pct,penetration_m,drift_m,jitter_m,crossings,"
         "failure\n";
  for (const std::string& name : names) {
    for (const Result& r : results.at(name)) {
      out << name << ',' << r.group << ',' << r.engine << ',' << r.setting << ',' << number(r.cost_us) << ','
          << number(r.p99_us) << ',' << number(r.error_m) << ',' << number(100.0 * r.figures.stretch) << ','
          << number(r.figures.penetration) << ',' << number(r.figures.drift) << ',' << number(r.figures.jitter) << ','
          << r.figures.crossings << ',' << r.failure << '\n';
    }
  }
  return out.str();
}

std::string table_of(const std::vector<Engine>& engines, const std::vector<std::string>& names,
                     const Results& results) {
  std::ostringstream out;
  out << "| engine | version | as |\n|---|---|---|\n";
  for (const Engine& engine : engines) {
    out << "| " << engine.name << " | " << engine.version << " | " << engine.kind << " |\n";
  }
  for (const bool has_contacts : {false, true}) add_table(out, engines, names, results, has_contacts);
  return out.str();
}

study::Report report_of(const std::string& name, const std::vector<Engine>& engines,
                        const std::vector<Result>& results) {
  study::Report report;
  report.title = name;
  report.notes.push_back(scene_of(name).description + ".");
  std::string versions;
  for (const Engine& engine : engines) {
    versions += (versions.empty() ? "" : ", ") + engine.name + " " + engine.version + " (" + engine.kind + ")";
  }
  report.notes.push_back(versions + ".");
  report.axis = scene_of(name).error_name;
  report.columns = {"stretch_pct", "penetration_m", "drift_m", "jitter_m", "crossings"};
  for (const Result& r : results) {
    report.points.push_back(plotted_point_of(r));
    report.cells.push_back({number(100.0 * r.figures.stretch), number(r.figures.penetration), number(r.figures.drift),
                            number(r.figures.jitter), std::to_string(r.figures.crossings)});
  }
  return report;
}

}  // namespace peers
