// The cords of a level start at rest: the player finds them as they hang, not in the middle of a fall.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "game/simulation/level.h"
#include "game/simulation/simulation.h"

namespace game {
namespace {

class CordsOfEveryLevel : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(AtRest, CordsOfEveryLevel, testing::ValuesIn(level_names()),
                         [](const auto& level) { return level.param; });

/// Whether something in the level moves the cords all the time.
bool has_wind_motors_or_riders(const Level& level) {
  return level.map.properties.has("wind_x") || level.map.properties.has("wind_y") ||
         std::any_of(level.map.objects.begin(), level.map.objects.end(), [](const engine::MapObject& object) {
           return object.properties.has("motor_torque") || (object.kind == "circle" && object.properties.has("path"));
         });
}

TEST_P(CordsOfEveryLevel, MoveNoMoreThanACentimetreInTheFirstSecond) {
  const Level level = load_level(GetParam());
  if (has_wind_motors_or_riders(level)) GTEST_SKIP() << "wind, a motor or a body on a path moves its cords";
  constexpr double most = 0.01;  // m
  Simulation simulation(level);
  const Snapshot start = simulation.current();
  for (int k = 0; k < ticks_per_second; ++k) {
    simulation.tick({});
    for (std::size_t c = 0; c < start.cords.size(); ++c) {
      // A cord of the thesis's solver does not come to rest.
      if (simulation.scene().coupling().cord(static_cast<int>(c)).solver() == ribbon::box2d::Solver::thesis) continue;
      const auto& now = simulation.current().cords[c];
      ASSERT_EQ(now.size(), start.cords[c].size()) << "cord " << c << " broke in tick " << k;
      for (std::size_t p = 0; p < now.size(); ++p) {
        ASSERT_LE(length(now[p] - start.cords[c][p]), most) << "cord " << c << ", point " << p << ", tick " << k;
      }
    }
  }
}

}  // namespace
}  // namespace game
