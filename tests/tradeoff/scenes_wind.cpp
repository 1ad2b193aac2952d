#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/thesis_scenes.h"
#include "tests/support/towed_line.h"
#include "tests/tradeoff/scene_lists.h"

namespace tradeoff {
namespace {

constexpr int line_settling_ticks = 3600;
constexpr int timed_ticks = 300;

/// The figures: the angle of the line, its error, that of a fall, and substeps without convergence.
std::vector<double> figures_of(const ribbon::Accuracy& accuracy, double speed) {
  test_support::TowedLine line(accuracy, speed);
  int unconverged = 0;
  for (int k = 0; k < line_settling_ticks; ++k) unconverged += line.step().unconverged;
  return {line.degrees(), 100.0 * line.error(), 100.0 * test_support::error_of_a_fall(accuracy),
          static_cast<double>(unconverged)};
}

Variant towed(const std::string& preset, const ribbon::Accuracy& accuracy, double speed) {
  const auto line = std::make_shared<std::unique_ptr<test_support::TowedLine>>();
  const auto work = std::make_shared<std::int64_t>();
  return {"cord",
          preset,
          41,
          [=] { *line = std::make_unique<test_support::TowedLine>(accuracy, speed, true); },
          [=] { *work = (*line)->step().work; },
          [=] { return figures_of(accuracy, speed); },
          {},
          "at " + number(speed) + " m/s",
          [work] { return *work; }};
}

/// The same line without a medium: what the medium costs.
Variant calm(const std::string& preset, const ribbon::Accuracy& accuracy) {
  const auto line = std::make_shared<std::unique_ptr<test_support::TowedLine>>();
  const auto work = std::make_shared<std::int64_t>();
  return {"cord",
          preset,
          41,
          [=] { *line = std::make_unique<test_support::TowedLine>(accuracy, 1.0, true); },
          [=] { *work = (*line)->cord().step(test_support::frame_dt, test_support::earth_gravity).work; },
          [] { return std::vector<double>(4, std::numeric_limits<double>::quiet_NaN()); },
          {},
          "without a medium",
          [work] { return *work; }};
}

std::vector<Variant> lines() {
  const std::vector<std::pair<std::string, ribbon::Accuracy>> presets = {{"fast", ribbon::Accuracy::fast()},
                                                                         {"balanced", ribbon::Accuracy::balanced()},
                                                                         {"accurate", ribbon::Accuracy::accurate()}};
  std::vector<Variant> list;
  for (const auto& [name, accuracy] : presets) {
    list.push_back(calm(name, accuracy));
    for (const double speed : {1.0, 2.0, 3.0}) list.push_back(towed(name, accuracy, speed));
  }
  return list;
}

}  // namespace

std::vector<Scene> wind_scenes() {
  return {
      {"wind",
       "a line of 4 m in a flow of air, as if it were towed: error of its shape at rest against the critical angle, "
       "in percent of its length, and of the speed of a level line that falls, in percent of the terminal velocity",
       timed_ticks,
       lines,
       {us_per_tick(), p99_us(), figure("degrees", 0), figure("shape_error_pct", 1), figure("fall_error_pct", 2),
        figure("unconverged", 3)}}};
}

}  // namespace tradeoff
