#include "engine/scene/scene_tuning.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "engine/scene/scene.h"
#include "engine/scene/tiled_edit.h"
#include "tests/support/constants.h"
#include "tests/support/mixed_level.h"

namespace {

using engine::Properties;
using engine::Scene;
using engine::TiledMap;

using constants::dt;
const std::vector<std::string> others = {"player", "goal"};

/// The first cord of each solver in a level with both.
struct Tuned {
  std::string text = test_support::mixed_swing_map();
  TiledMap map = engine::parse_tiled_map(text, "mixed.tmj");
  Scene scene{map, others, {}, {"title", "hint", "number", "gold", "silver", "bronze"}};

  ribbon::box2d::CordId first(ribbon::box2d::Solver solver) const {
    for (int c = 0; c < scene.coupling().size(); ++c) {
      if (scene.coupling().cord(c).solver() == solver) return c;
    }
    return -1;
  }
  void run(int ticks) {
    for (int k = 0; k < ticks; ++k) scene.tick(dt);
  }
  /// Lifts the middle of a cord by a height [m], and lets it go.
  void lift(ribbon::box2d::CordId cord, double height) {
    const auto middle = static_cast<int>(scene.coupling().cord(cord).positions().size() / 2);
    const ribbon::Vec2 from = scene.coupling().cord(cord).positions()[static_cast<std::size_t>(middle)];
    for (int k = 1; k <= 20; ++k) {
      scene.coupling().cord(cord).drag(middle, from + ribbon::Vec2{0.0, 0.05 * k * height});
      run(1);
    }
    scene.coupling().cord(cord).free(middle);
  }
  void set(ribbon::box2d::CordId cord, const std::string& property, const Properties::Value& value) {
    const int object = scene.cord_object(cord);
    text = engine::with_property(text, object, property, value);
    map = engine::parse_tiled_map(text, "mixed.tmj");
    retune(scene.coupling(), cord, *map.find(object));
  }
};

TEST(SceneTuning, ATunedCordKeepsItsPositionAndMovesDifferently) {
  for (const ribbon::box2d::Solver solver : {ribbon::box2d::Solver::direct, ribbon::box2d::Solver::thesis}) {
    Tuned tuned;
    Tuned plain;
    const ribbon::box2d::CordId cord = tuned.first(solver);
    ASSERT_GE(cord, 0);
    for (Tuned* scene : {&tuned, &plain}) {
      scene->lift(cord, 0.5);
      scene->run(60);
    }
    tuned.set(cord, "drag", 8.0);
    const auto now = tuned.scene.coupling().cord(cord).positions();
    const auto then = plain.scene.coupling().cord(cord).positions();
    for (std::size_t p = 0; p < now.size(); ++p) ASSERT_EQ(now[p], then[p]);
    tuned.run(60);
    plain.run(60);
    double apart = 0.0;
    for (std::size_t p = 0; p < now.size(); ++p) {
      apart = std::max(apart, length(tuned.scene.coupling().cord(cord).positions()[p] -
                                     plain.scene.coupling().cord(cord).positions()[p]));
    }
    EXPECT_GT(apart, 1e-3);
    EXPECT_LT(apart, 5.0);
  }
}

TEST(SceneTuning, SettingTheSameValueChangesNothing) {
  Tuned tuned;
  Tuned plain;
  const ribbon::box2d::CordId cord = tuned.first(ribbon::box2d::Solver::direct);
  tuned.run(90);
  plain.run(90);
  tuned.set(cord, "friction", 0.25);
  tuned.set(cord, "friction", plain.scene.coupling().cord(cord).direct().def().friction);
  tuned.run(30);
  plain.run(30);
  const auto now = tuned.scene.coupling().cord(cord).positions();
  const auto then = plain.scene.coupling().cord(cord).positions();
  for (std::size_t p = 0; p < now.size(); ++p) EXPECT_LT(length(now[p] - then[p]), 2e-3);
}

TEST(SceneTuning, AttachedMassesAndHoldersStayWhenTheMassChanges) {
  Tuned tuned;
  const ribbon::box2d::CordId cord = tuned.first(ribbon::box2d::Solver::direct);
  ribbon::Cord& before = tuned.scene.coupling().cord(cord).direct();
  const int last = before.size() - 1;
  before.attach_mass(last, 12.0);
  const double own = before.mass(last) - 12.0;
  b2BodyDef def;
  def.type = b2_dynamicBody;
  const ribbon::Vec2 at = before.positions()[static_cast<std::size_t>(last)];
  def.position = {static_cast<float>(at.x), static_cast<float>(at.y)};
  b2Body* body = tuned.scene.world().CreateBody(&def);
  b2CircleShape shape;
  shape.m_radius = 0.2F;
  body->CreateFixture(&shape, 100.0F);
  tuned.scene.coupling().hold(cord, last, *body, {0.0F, 0.0F});
  tuned.run(5);
  const double mass = before.def().mass_per_length * before.def().length;
  tuned.set(cord, "mass", 3.0 * mass);
  EXPECT_NEAR(tuned.scene.coupling().cord(cord).direct().mass(last), 12.0 + 3.0 * own, 1e-9);
  tuned.run(30);
  const auto held = tuned.scene.coupling().body(*body).held_place();
  ASSERT_TRUE(held);
  EXPECT_LT(held->distance, 0.2);
}

TEST(SceneTuning, ASettingThatNeedsANewSceneIsRefusedAndChangesNothing) {
  Tuned tuned;
  const ribbon::box2d::CordId cord = tuned.first(ribbon::box2d::Solver::direct);
  tuned.run(10);
  const auto before = tuned.scene.coupling().cord(cord).direct().save();
  EXPECT_THROW(tuned.set(cord, "columns", std::int64_t{7}), engine::MapError);
  EXPECT_THROW(tuned.set(cord, "friction", -1.0), engine::MapError);
  EXPECT_TRUE(tuned.scene.coupling().cord(cord).direct().save() == before);
}

}  // namespace
