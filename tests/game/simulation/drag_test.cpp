// Dragging by the pointer: everything but the ground can be dragged.

#include "game/simulation/drag.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "game/simulation/buttons.h"
#include "game/simulation/simulation.h"
#include "ribbon/box2d/convert.h"

namespace game {
namespace {

using ribbon::Vec2;
using ribbon::box2d::to_double;

const Level& sandbox() {
  static const Level level = load_level("sandbox");
  return level;
}

engine::TickInput drag_at(Vec2 pointer) {
  engine::TickInput input;
  input.buttons = button_drag;
  engine::set_pointer(input, pointer);
  return input;
}

int object_id(const std::string& name) {
  const auto& objects = sandbox().map.objects;
  const auto found = std::find_if(objects.begin(), objects.end(), [&](const auto& o) { return o.name == name; });
  return found == objects.end() ? -1 : found->id;
}

b2Body& body_named(Simulation& simulation, const std::string& name) {
  for (const engine::SceneBody& made : simulation.scene().bodies()) {
    if (made.object == object_id(name)) return *made.body;
  }
  throw std::runtime_error("no body " + name);
}

/// Drags the object at `from` to `to` in `ticks` ticks.
void lead(Simulation& simulation, Vec2 from, Vec2 to, int ticks) {
  simulation.tick(drag_at(from));
  for (int k = 0; k < ticks; ++k) simulation.tick(drag_at(to));
}

class DraggedBody : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Drag, DraggedBody, testing::Values("loose ball", "ball 2", "block", "peg"),
                         [](const auto& param) {
                           std::string name = param.param;
                           std::replace(name.begin(), name.end(), ' ', '_');
                           return name;
                         });

TEST_P(DraggedBody, FollowsThePointerAndIsReleased) {
  Simulation simulation(sandbox());
  for (int k = 0; k < 60; ++k) simulation.tick({});
  b2Body& body = body_named(simulation, GetParam());
  const b2BodyType type = body.GetType();
  const Vec2 from = to_double(body.GetWorldCenter());
  const Vec2 to = from + Vec2{-0.5, 1.5};
  lead(simulation, from, to, 90);
  EXPECT_EQ(simulation.drag().body(), &body);
  EXPECT_LT(length(to_double(body.GetWorldCenter()) - to), 0.1);
  simulation.tick({});
  EXPECT_EQ(simulation.drag().body(), nullptr);
  EXPECT_EQ(body.GetType(), type);
  for (int k = 0; k < 60; ++k) simulation.tick({});
  const double after = to_double(body.GetWorldCenter()).y;
  if (type == b2_dynamicBody) {
    EXPECT_LT(after, to.y - 0.3) << "it falls";
  } else {
    EXPECT_NEAR(after, to.y, 0.1) << "it stays where it was put";
    EXPECT_EQ(body.GetLinearVelocity(), b2Vec2_zero);
  }
}

TEST(Drag, ThePlayerIsLiftedAndFallsWhenReleased) {
  Simulation simulation(sandbox());
  for (int k = 0; k < 20; ++k) simulation.tick({});
  const Vec2 from = simulation.player().position();
  lead(simulation, from, from + Vec2{1.0, 3.0}, 60);
  EXPECT_LT(length(simulation.player().position() - from - Vec2{1.0, 3.0}), 0.1);
  for (int k = 0; k < 90; ++k) simulation.tick({});
  EXPECT_NEAR(simulation.player().position().y, from.y, 0.02);
}

TEST(Drag, ABodyIsHeldAtThePointerAndRotatesAboutIt) {
  Simulation simulation(sandbox());
  b2Body& ball = body_named(simulation, "loose ball");
  const Vec2 rim = to_double(ball.GetWorldCenter()) + Vec2{0.45, 0.0};
  const b2Vec2 held = ball.GetLocalPoint(ribbon::box2d::to_float(rim));
  lead(simulation, rim, rim + Vec2{0.0, 2.0}, 60);
  EXPECT_LT(length(to_double(ball.GetWorldPoint(held)) - rim - Vec2{0.0, 2.0}), 0.15);
  EXPECT_GT(std::abs(static_cast<double>(ball.GetAngle())), 0.5) << "its weight is beside the pointer";
}

/// Dragging a cord moves the body it is fixed to, as far as its other fixed points allow.
TEST(Drag, ACordMovesTheBodyItIsFixedTo) {
  for (const int cord : {0, 1, 4}) {  // a rope, one of the thesis's with two rows, a hammock with two ends
    Simulation simulation(sandbox());
    for (int k = 0; k < 30; ++k) simulation.tick({});
    const ribbon::box2d::Coupling& coupling = simulation.scene().coupling();
    const auto x = coupling.cord(cord).positions();
    const Vec2 from = x[0];
    const Vec2 to = from + Vec2{1.0, 1.0};
    ASSERT_EQ(coupling.cord(cord).kind(0), ribbon::PointKind::constrained);
    lead(simulation, from, to, 90);
    EXPECT_EQ(coupling.cord(cord).kind(0), ribbon::PointKind::constrained);
    EXPECT_LT(length(x[0] - to), cord == 4 ? 0.6 : 0.02) << "cord " << cord;
    const Vec2 there = x[0];
    for (int k = 0; k < 60; ++k) simulation.tick({});
    EXPECT_LT(length(x[0] - there), 1e-6) << "it stays there";
    if (coupling.cord(cord).solver() == ribbon::box2d::Solver::direct) {
      EXPECT_EQ(coupling.cord(cord).island_total().unconverged, 0) << "cord " << cord;
    }
  }
}

TEST(Drag, TheGroundDoesNotMove) {
  Simulation simulation(sandbox());
  simulation.tick(drag_at({30.0, 1.0}));
  EXPECT_EQ(simulation.drag().body(), nullptr);
  EXPECT_FALSE(simulation.drag().cord_point());
}

/// Drags a load of 300 kg at the end of an inextensible cord of 1 kg.
TEST(Drag, AHeavyLoadIsDraggedNoFurtherThanItsCordIsLong) {
  Simulation simulation(sandbox());
  for (int k = 0; k < 30; ++k) simulation.tick({});
  const ribbon::box2d::Coupling& coupling = simulation.scene().coupling();
  b2Body& block = body_named(simulation, "block");
  const auto held = coupling.body(block).held_place();
  ASSERT_TRUE(held);
  const auto x = coupling.cord(held->cord).positions();
  const double cord_length = coupling.cord(held->cord).direct().def().length;
  const Vec2 from = to_double(block.GetWorldCenter());
  simulation.tick(drag_at(from));
  for (int k = 0; k < 120; ++k) {
    simulation.tick(drag_at(from + Vec2{-12.0, 0.0}));
    ASSERT_LT(length(x.back() - x.front()), 1.001 * cord_length) << "tick " << k;
  }
  EXPECT_EQ(coupling.cord(held->cord).island_total().unconverged, 0);
}

TEST(Drag, SameBitsOfTheSameInputsForAnyDraggedObject) {
  const auto run = [] {
    Simulation simulation(sandbox());
    std::vector<std::uint64_t> hashes;
    for (int k = 0; k < 600; ++k) {
      engine::TickInput input;
      // A new drag every second, at different places of the level.
      if (k % 60 > 10) input = drag_at({6.0 + 0.05 * k + 0.03 * (k % 60), 1.0 + 0.013 * k});
      if (k == 450) input.buttons = button_restart;
      simulation.tick(input);
      hashes.push_back(simulation.hash().combined());
    }
    return hashes;
  };
  EXPECT_EQ(run(), run());
}

/// A dragged point is constrained; a piece of a cut cord inherits that.
TEST(Drag, APointOfACutRopeIsDraggedOnAndFreeAfterwards) {
  Simulation simulation(sandbox());
  for (int k = 0; k < 60; ++k) simulation.tick({});
  const ribbon::box2d::Coupling& coupling = simulation.scene().coupling();
  for (const int side : {-2, 2}) {
    ribbon::box2d::CordId rope = -1;
    for (const ribbon::box2d::CordId id : coupling.cords()) {
      const auto cord = coupling.cord(id);
      const bool is_rope = cord.shape().rows == 1 && cord.solver() == ribbon::box2d::Solver::direct;
      if (is_rope && cord.shape().columns > 8) rope = id;
    }
    ASSERT_GE(rope, 0);
    const int middle = coupling.cord(rope).shape().columns / 2;
    const Vec2 from = coupling.cord(rope).positions()[static_cast<std::size_t>(middle)];
    lead(simulation, from, from, 3);
    ASSERT_TRUE(simulation.drag().cord_point());
    const ribbon::box2d::CordPoint dragged = *simulation.drag().cord_point();
    const auto cut = simulation.scene().coupling().cord(dragged.cord);
    cut.cut(cut.arc(dragged.point + side));
    simulation.tick(drag_at(from + Vec2{0.1, 0.0}));
    ASSERT_TRUE(simulation.drag().cord_point());
    const ribbon::box2d::CordPoint piece = *simulation.drag().cord_point();
    EXPECT_NE(piece.cord, dragged.cord);
    EXPECT_EQ(coupling.cord(piece.cord).kind(piece.point), ribbon::PointKind::operated);
    simulation.tick({});
    EXPECT_EQ(coupling.cord(piece.cord).kind(piece.point), ribbon::PointKind::free);
  }
}

}  // namespace
}  // namespace game
