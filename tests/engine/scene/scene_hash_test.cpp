#include "engine/scene/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "tests/engine/scene/scene_json.h"
#include "tests/support/refusal.h"

// The hash of a scene with a cord of the direct solver.

namespace engine {
namespace {

using State = ribbon::Cord::State;

std::uint64_t hash_of(Scene& scene) {
  ribbon::box2d::StateHash hash;
  scene.add_to(hash);
  return hash.combined();
}

/// A ribbon with area stiffness in its fifth tick: it has a load, is being reeled, is held by a body, and touches
/// another body.
struct SwingingRibbon {
  Scene scene{map_with(object("cord", line,
                              direct_properties + "," + whole("rows", "2") + "," + number("stretch_stiffness", "5000") +
                                  "," + number("area_stiffness", "1") + "," + number("damping", "0.01") + "," +
                                  number("friction", "0.5") + "," + yes("pin_first")) +
                       "," + R"({"id":9,"name":"a","type":"circle","x":23.5,"y":46,"rotation":0,"visible":true,)" +
                       disc + R"(,"properties":[)" + text("body", "static") + "]}," +
                       R"({"id":8,"name":"b","type":"circle","x":35,"y":35,"rotation":0,"visible":true,)" + disc +
                       "}")};

  SwingingRibbon() {
    cord().set_load(16, {2.0, 0.0});
    cord().reel(0, 8, 3.9, 0.1);
    scene.coupling().hold(0, 12, *scene.world().GetBodyList(), {-0.4F, 0.0F});
    for (int k = 0; k < 5; ++k) tick();
  }
  ribbon::Cord& cord() { return scene.coupling().cord(0).direct(); }
  void tick() { scene.tick(1.0 / 60.0); }
};

/// The hash sees everything that a later tick depends on, so that a replay reports the tick in which it diverges.
TEST(SceneHash, DependsOnEachPartOfADirectCordsState) {
  const std::vector<std::pair<const char*, std::function<void(State&)>>> changes = {
      {"positions", [](State& s) { s.positions[3].x = std::nextafter(s.positions[3].x, 9.0); }},
      {"velocities", [](State& s) { s.velocities[3].y = std::nextafter(s.velocities[3].y, 9.0); }},
      {"accelerations", [](State& s) { s.accelerations[3].x += 1e-9; }},
      {"targets", [](State& s) { s.targets[3].x += 1e-9; }},
      {"kinds", [](State& s) { s.kinds[3] = ribbon::PointKind::operated; }},
      {"masses", [](State& s) { s.masses[3] += 1e-9; }},
      {"loads", [](State& s) { s.loads[3].x += 1e-9; }},
      {"medium_forces", [](State& s) { s.medium_forces.resize(s.positions.size()); }},
      {"tensions", [](State& s) { s.tensions[3] += 1e-6; }},
      {"rest", [](State& s) { s.rest[3] += 1e-9; }},
      {"rest_targets", [](State& s) { s.rest_targets[3] += 1e-9; }},
      {"rest_speeds", [](State& s) { s.rest_speeds[3] += 1e-9; }},
      {"unlocked", [](State& s) { s.unlocked[3] = 1; }},
      {"holders.point", [](State& s) { s.holders[0].point = 5; }},
      {"holders.velocity", [](State& s) { s.holders[0].velocity.x += 1e-9; }},
      {"holders.turning", [](State& s) { s.holders[0].turning += 1e-9; }},
      {"holders.acceleration", [](State& s) { s.holders[0].acceleration.y += 1e-9; }},
      {"holders.angular_acceleration", [](State& s) { s.holders[0].angular_acceleration += 1e-9; }},
      {"holders.grip", [](State& s) { s.holders[0].grip += 1; }},
      {"holders.pull", [](State& s) { s.holders[0].pull.x += 1e-9; }},
      {"holders.slid", [](State& s) { s.holders[0].slid += 1e-9; }},
      {"holders.slips", [](State& s) { s.holders[0].slips = !s.holders[0].slips; }},
      {"holders", [](State& s) { s.holders.clear(); }},
      {"touches.other", [](State& s) { s.touches[0].other += 1; }},
      {"touches.feature", [](State& s) { s.touches[0].feature += 1; }},
      {"touches.other_feature", [](State& s) { s.touches[0].other_feature += 1; }},
      {"touches.force", [](State& s) { s.touches[0].force += 1e-9; }},
      {"touches.stuck", [](State& s) { s.touches[0].stuck += 1e-9; }},
      {"touches.impulse", [](State& s) { s.touches[0].impulse += 1e-9; }},
      {"touches.point", [](State& s) { s.touches[0].point.x += 1e-9; }},
      {"touches.normal", [](State& s) { s.touches[0].normal.y += 1e-9; }},
      {"touches", [](State& s) { s.touches.clear(); }},
      {"touch_changed", [](State& s) { s.touch_changed = !s.touch_changed; }},
      {"depenetration_share", [](State& s) { s.depenetration_share = 0.5; }},
      {"newton_pause", [](State& s) { s.newton_pause = 1; }},
      {"regainable_energy", [](State& s) { s.regainable_energy += 1e-9; }},
      {"energy_drift", [](State& s) { s.energy_drift += 1e-9; }},
      {"damping_excluded", [](State& s) { s.damping_excluded = !s.damping_excluded; }},
      {"restart", [](State& s) { s.restart = !s.restart; }},
  };
  SwingingRibbon ribbon;
  const State state = ribbon.cord().save();
  const std::uint64_t hash = hash_of(ribbon.scene);
  ASSERT_FALSE(state.touches.empty());
  for (const auto& [what, change] : changes) {
    State changed = state;
    change(changed);
    ASSERT_NE(changed, state) << what;
    ribbon.cord().restore(changed);
    EXPECT_NE(hash_of(ribbon.scene), hash) << what;
  }
  ribbon.cord().restore(state);
  EXPECT_EQ(hash_of(ribbon.scene), hash);
}

TEST(SceneHash, SameBitsOfTwoScenesWithDirectCords) {
  SwingingRibbon one;
  SwingingRibbon other;
  for (int k = 0; k < 60; ++k) {
    one.tick();
    other.tick();
    ASSERT_EQ(hash_of(one.scene), hash_of(other.scene)) << "tick " << k;
  }
}

}  // namespace
}  // namespace engine
