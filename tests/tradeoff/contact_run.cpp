#include "tests/tradeoff/contact_run.h"

#include <algorithm>
#include <memory>

#include "tests/study/figures.h"
#include "tests/support/contact_figures.h"

namespace tradeoff {

using ribbon::Accuracy;
using study::unavailable;
using test_support::CordMethod;
using test_support::CoupledWorld;

namespace {

constexpr double max_coordinate = 1e4;  // m

Accuracy preset(const std::string& name) {
  if (name == "fast") return Accuracy::fast();
  return name == "accurate" ? Accuracy::accurate() : Accuracy::balanced();
}

void count_reports(const CoupledWorld& world, ContactFigures& figures) {
  for (int c = 0; c < world.coupling.size(); ++c) {
    if (world.method().thesis) {
      const ribbon::StepReport& report = world.coupling.cord(c).thesis_report();
      figures.unconverged += report.fem_skipped > 0 ? 1 : 0;
      figures.corrected += report.motion_limited > 0 ? 1 : 0;
      continue;
    }
    const ribbon::IslandReport& report = world.coupling.cord(c).island_report();
    figures.unconverged += report.unconverged > 0 ? 1 : 0;
    figures.corrected += report.searches + report.fallbacks + report.energy_gains + report.halvings > 0 ? 1 : 0;
  }
}

bool is_in_bounds(const CoupledWorld& world) {
  for (int c = 0; c < world.cords(); ++c) {
    const std::vector<ribbon::Vec2> points = world.outline(c);
    if (!std::all_of(points.begin(), points.end(), [](ribbon::Vec2 p) { return length(p) <= max_coordinate; }))
      return false;
  }
  return true;
}

template <typename Declares>
bool any_cord(const CoupledWorld& world, Declares&& declares) {
  for (int c = 0; c < world.cords(); ++c) {
    if (declares(world.def(c))) return true;
  }
  return false;
}

}  // namespace

std::vector<NamedMethod> presets(const std::vector<std::string>& names) {
  std::vector<NamedMethod> list;
  for (const std::string& name : names) {
    CordMethod how;
    how.accuracy = preset(name);
    list.push_back({"cord", name, how});
  }
  return list;
}

std::vector<NamedMethod> chains(const std::vector<int>& substeps, bool self_contact) {
  std::vector<NamedMethod> list;
  for (const int count : substeps) {
    CordMethod how;
    how.chain = true;
    how.substeps = count;
    how.chain_self_contact = self_contact;
    list.push_back({"box2d_chain", "substeps=" + std::to_string(count), how});
  }
  return list;
}

std::vector<NamedMethod> thesis_cords(const std::vector<int>& substeps, double spring_share) {
  std::vector<NamedMethod> list;
  for (const int count : substeps) {
    CordMethod how;
    how.thesis = true;
    how.substeps = count;
    how.spring_share = spring_share;
    list.push_back({"thesis", "substeps=" + std::to_string(count) + " k=" + number(spring_share), how});
  }
  return list;
}

std::vector<NamedMethod> together(std::vector<NamedMethod> a, const std::vector<NamedMethod>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

ContactFigures run(CoupledWorld& world, int ticks, const std::function<void(CoupledWorld&)>& after_tick) {
  ContactFigures figures;
  double lowest = world.energy();
  double gain = 0.0;
  for (int tick = 0; tick < ticks; ++tick) {
    world.tick();
    if (!is_in_bounds(world)) {
      figures.blew_up = tick + 1;
      break;
    }
    if (after_tick) after_tick(world);
    count_reports(world, figures);
    for (int c = 0; c < world.cords(); ++c) {
      if (world.def(c).rows == 1) figures.max_stretch = std::max(figures.max_stretch, test_support::stretch(world, c));
    }
    const double energy = world.energy();
    gain = std::max(gain, energy - lowest);
    lowest = std::min(lowest, energy);
    figures.penetration = std::max(figures.penetration, test_support::penetration(world));
  }
  figures.energy_gain = gain / world.energy_scale();
  figures.self_crossings = test_support::self_crossings(world);
  figures.mutual_crossings = test_support::mutual_crossings(world);
  figures.inverted = test_support::inverted_cells(world);
  return figures;
}

std::vector<double> figures_of(const CoupledWorld& world, const ContactFigures& figures,
                               std::optional<double> target_us) {
  const bool chain = world.method().chain;
  const bool ropes = world.def(0).rows == 1;
  const bool self_contact = any_cord(world, [](const ribbon::CordDef& def) { return def.self_contact; });
  const bool cord_contact = any_cord(world, [](const ribbon::CordDef& def) { return def.cord_contact; });
  return {world.method().thesis || chain ? unavailable : target_us.value_or(unavailable),
          ropes ? 100.0 * figures.max_stretch : unavailable,
          world.energy_scale() > 0.0 ? 100.0 * figures.energy_gain : unavailable,
          chain ? unavailable : figures.corrected,
          chain ? unavailable : figures.unconverged,
          figures.penetration,
          self_contact ? figures.self_crossings : unavailable,
          cord_contact ? figures.mutual_crossings : unavailable,
          ropes ? unavailable : figures.inverted,
          static_cast<double>(figures.blew_up)};
}

Variant variant(const ContactVariant& how) {
  const auto world = std::make_shared<std::unique_ptr<CoupledWorld>>();
  const auto set_up = [world, how] {
    *world = std::make_unique<CoupledWorld>(how.method.how, how.gravity);
    how.set_up(**world);
  };
  set_up();
  int points = 0;
  for (int c = 0; c < (*world)->cords(); ++c) points += static_cast<int>((*world)->outline(c).size());
  world->reset();
  const bool is_cord = !how.method.how.chain && !how.method.how.thesis;
  return {how.method.method,
          how.method.setting,
          points,
          how.continues ? std::function<void()>() : set_up,
          [world] { (*world)->step_cords(); },
          [world, set_up, how] {
            set_up();
            return how.figures(**world);
          },
          [world] { (*world)->step_world(); },
          how.group,
          is_cord ? [world] { return (*world)->coupling.last_step().report().work; } : std::function<std::int64_t()>()};
}

std::vector<Column> contact_columns(const std::vector<std::string>& more) {
  std::vector<Column> columns = {us_per_tick(), p99_us(), cords_us(), cords_max_us(), world_step_us()};
  std::size_t index = 0;
  for (const char* name : {"cords_target_us", "max_stretch_pct", "energy_gain_pct", "corrected", "unconverged",
                           "penetration_m", "crossings", "mutual_crossings", "inverted", "blew_up"}) {
    columns.push_back(figure(name, index++));
  }
  for (const std::string& name : more) columns.push_back(figure(name, index++));
  return columns;
}

}  // namespace tradeoff
