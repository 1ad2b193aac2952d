#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "tests/study/level_study.h"
#include "tests/tradeoff/measure.h"

namespace study {

WorkFigures figures_of(std::span<const std::int64_t> tick_work) {
  if (tick_work.empty()) return {};
  const std::vector<double> ticks(tick_work.begin(), tick_work.end());
  double sum = 0.0;
  for (const double work : ticks) sum += work;
  return {sum / static_cast<double>(ticks.size()), tradeoff::quantile(ticks, 0.99), tradeoff::quantile(ticks, 1.0)};
}

WorkFigures largest_work(const Measured& measured) {
  const WorkFigures& own = measured.tick_work;
  const WorkFigures& others = measured.others.work;  // NaN without other players
  const auto larger = [](double a, double b) { return b > a ? b : a; };
  return {larger(own.mean, others.mean), larger(own.p99, others.p99), larger(own.most, others.most)};
}

bool spends_budget(const Measured& measured) {
  return measured.work.posed > 0 || measured.windows.spends_budget || measured.others.spends_budget;
}

std::optional<ribbon::Accuracy> window_accuracy_of(const Setting& setting) {
  return is_present(setting) ? std::nullopt : std::optional(accuracy_of(setting));
}

Point Measured::point() const {
  Point point{setting.solver, name_of(setting), cost_us, p99_us};
  point.error_m = std::max(error.greatest_length(), resolution_m);
  point.failure = failure;
  point.not_compared = mesh_of(setting) != Mesh{};
  return point;
}

std::vector<Point> Study::points() const {
  std::vector<Point> all;
  for (const Measured& measured : settings) all.push_back(measured.point());
  return all;
}

std::vector<Point> applicable(const Study& study) {
  std::vector<Point> points = study.points();
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Measured& m = study.settings[k];
    points[k].not_compared = points[k].not_compared || m.setting.solver != "direct";
    points[k].error_m = std::max({points[k].error_m, m.windows.greatest(), m.windows_resolution_m});
    if (m.others.error_m > points[k].error_m) points[k].error_m = m.others.error_m;
    if (points[k].failure.empty() && !m.others.failure.empty())
      points[k].failure = "with another player: " + m.others.failure;
  }
  return points;
}

}  // namespace study
