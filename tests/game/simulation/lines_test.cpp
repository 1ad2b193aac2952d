// Lines that stick to surfaces and bodies, two of them, and knots.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "game/simulation/buttons.h"
#include "game/simulation/simulation.h"
#include "ribbon/box2d/convert.h"
#include "tests/game/simulation/press.h"
#include "tests/game/simulation/small_level.h"

namespace game {
namespace {

using ribbon::box2d::to_double;

/// Returns a level whose ground is up to y = 1 m. `lines`: how many the player can hold.
Level level_with(Vec2 feet, std::vector<MapObject> objects, std::int64_t lines = 1) {
  engine::TiledMap map = small_map(std::move(objects), feet, 1.0);
  if (lines != 1) map.properties.insert("lines", lines);
  return level_of(std::move(map));
}

MapObject hook(Vec2 place) { return point_of(0, "hook", place); }

/// Throws a line and waits until it holds.
void throw_line(Simulation& simulation, int button, Vec2 pointer) {
  tick(simulation, button, 1, pointer);
  tick(simulation, 0, 20, pointer);
}

const Line& line(const Simulation& simulation, std::size_t hand) { return simulation.player().lines().all()[hand]; }

b2Body& body_of(const Simulation& simulation, engine::BodyKind kind) {
  const auto bodies = simulation.scene().bodies();
  return *std::find_if(bodies.begin(), bodies.end(), [kind](const auto& made) { return made.kind == kind; })->body;
}

MapObject bare_ceiling() { return ground({0.0, 8.0}, {40.0, 9.0}); }
MapObject ceiling() { return sticky(bare_ceiling()); }

TEST(Aim, MeetsTheStickySurfaceInTheDirectionOfThePointer) {
  const Level level = level_with({10.0, 1.0}, {ceiling()});
  Simulation simulation(level);
  tick(simulation, 0, 1, {14.0, 6.7});
  ASSERT_TRUE(simulation.target());
  const Vec2 hand = simulation.player().hand();
  const Vec2 way = simulation.target()->place() - hand;
  EXPECT_NEAR(simulation.target()->place().y, 8.0 - simulation.player().line().tuning().radius, 1e-5);
  EXPECT_NEAR(way.x / way.y, (14.0 - hand.x) / (6.7 - hand.y), 0.01);
}

TEST(Aim, SeesNoSurfaceThatIsNotStickyHiddenOrTooFar) {
  const auto has_target = [](std::vector<MapObject> objects, Vec2 feet) {
    const Level level = level_with(feet, std::move(objects));
    Simulation simulation(level);
    tick(simulation, 0, 1, feet + Vec2{0.0, 10.0});
    return simulation.target().has_value();
  };
  EXPECT_TRUE(has_target({ceiling()}, {10.0, 1.0}));
  EXPECT_FALSE(has_target({bare_ceiling()}, {10.0, 1.0}));
  EXPECT_FALSE(has_target({ceiling(), ground({0.0, 5.0}, {40.0, 5.5})}, {10.0, 1.0}));
  EXPECT_FALSE(has_target({sticky(ground({0.0, 14.0}, {40.0, 15.0}))}, {10.0, 1.0}));
}

TEST(Aim, LooksAheadWithoutAPointer) {
  const Level level = level_with({10.0, 1.0}, {ceiling()});
  Simulation simulation(level);
  tick(simulation, button_left, 2);  // the pointer is on the ground, which is not sticky
  ASSERT_TRUE(simulation.target());
  EXPECT_LT(simulation.target()->place().x, 8.0);
  tick(simulation, button_right, 2);
  EXPECT_GT(simulation.target()->place().x, 12.0);
}

TEST(Line, SticksToASurfaceAndCarriesThePlayer) {
  const Level level = level_with({10.0, 1.0}, {ceiling()});
  Simulation simulation(level);
  throw_line(simulation, button_throw, {10.0, 8.0});
  ASSERT_TRUE(line(simulation, 0).is_held());
  tick(simulation, button_reel_in, 60);
  EXPECT_FALSE(simulation.player().is_on_ground());
  EXPECT_GT(simulation.player().position().y, 2.5);
}

/// What the line meets on its way becomes the place from which it hangs.
TEST(Line, WrapsAroundAPeg) {
  MapObject peg = disc_of(0, "circle", {13.0, 4.5}, 0.3);
  peg.properties.insert("body", std::string("static"));
  const Level level = level_with({10.0, 1.0}, {ceiling(), peg});
  Simulation simulation(level);
  throw_line(simulation, button_throw, {13.2, 7.9});
  ASSERT_TRUE(line(simulation, 0).is_held());
  tick(simulation, button_reel_in, 50);
  const auto cord = [&] { return simulation.scene().coupling().cord(*line(simulation, 0).cord()); };
  double nearest = 1e9;
  bool touched = false;
  for (int k = 0; k < 120; ++k) {
    tick(simulation, button_right);
    for (const Vec2 point : cord().positions()) nearest = std::min(nearest, length(point - Vec2{13.0, 4.5}));
    touched = touched || !cord().touching().empty();
  }
  EXPECT_TRUE(touched);
  EXPECT_GT(nearest, 0.3);
}

/// The player stands, and the crate comes.
TEST(Line, PullsALooseBody) {
  const Level level = level_with({10.0, 1.0}, {sticky(crate({17.0, 1.0}, {1.0, 1.0}, 30.0))});
  Simulation simulation(level);
  const b2Body& load = body_of(simulation, engine::BodyKind::load);
  throw_line(simulation, button_throw, {17.0, 1.5});
  ASSERT_TRUE(line(simulation, 0).is_held());
  EXPECT_EQ(simulation.target()->body, &load);
  const float before = load.GetPosition().x;
  tick(simulation, button_reel_in, 120);
  EXPECT_LT(load.GetPosition().x, before - 3.0F);
  EXPECT_NEAR(simulation.player().position().x, 10.0, 0.5);
  EXPECT_LT(length(simulation.scene().coupling().cord(*line(simulation, 0).cord()).positions().front() -
                   line(simulation, 0).end()),
            0.01);
  tick(simulation, button_throw);
  EXPECT_FALSE(line(simulation, 0).is_held());
  tick(simulation, 0, 60);  // the line stays on the crate
  EXPECT_LT(length(simulation.scene().coupling().cord(*line(simulation, 0).cord()).positions().front() -
                   line(simulation, 0).end()),
            0.01);
}

/// Standing against the pull of the line stores energy, which a jump sets free.
TEST(Line, ThrowsAPlayerThatHasChargedIt) {
  const auto speed = [](int ticks_of_reeling) {
    const Level level = level_with({6.0, 1.0}, {hook({15.5, 3.0})});
    Simulation simulation(level);
    throw_line(simulation, button_throw, {15.5, 3.0});
    tick(simulation, button_reel_in, ticks_of_reeling);
    EXPECT_NEAR(simulation.player().position().x, 6.0, 0.3);
    tick(simulation, button_jump, 15);
    return to_double(simulation.player().body().GetLinearVelocity()).x;
  };
  EXPECT_LT(speed(0), 1.0);
  EXPECT_GT(speed(60), 5.0);
}

TEST(TwoLines, AreThrownHeldAndReleasedByHand) {
  const Level level = level_with({10.0, 1.0}, {ceiling()}, 2);
  Simulation simulation(level);
  throw_line(simulation, button_throw, {8.0, 7.0});
  throw_line(simulation, button_throw_second, {12.0, 7.0});
  ASSERT_TRUE(line(simulation, 0).is_held() && line(simulation, 1).is_held());
  EXPECT_LT(line(simulation, 0).end().x, line(simulation, 1).end().x);
  tick(simulation, button_reel_in, 90);
  EXPECT_FALSE(simulation.player().is_on_ground());
  tick(simulation, button_throw);
  EXPECT_FALSE(line(simulation, 0).is_held());
  EXPECT_EQ(simulation.player().lines().held(), &line(simulation, 1));
  tick(simulation, button_jump);
  EXPECT_EQ(simulation.player().lines().held(), nullptr);
}

/// From line to line, without the ground.
TEST(TwoLines, CarryThePlayerFromOneToTheOther) {
  const Level level = level_with({6.0, 1.0}, {ceiling()}, 2);
  Simulation simulation(level);
  throw_line(simulation, button_throw, {6.0, 8.0});
  tick(simulation, button_reel_in, 60);
  int hand = 1;
  for (int k = 0; k < 4; ++k, hand = 1 - hand) {
    const Vec2 ahead = simulation.player().hand() + Vec2{3.5, 4.0};
    throw_line(simulation, hand == 0 ? button_throw : button_throw_second, ahead);
    tick(simulation, hand == 0 ? button_throw_second : button_throw);  // lets go of the one before
    tick(simulation, 0);
    for (int t = 0; t < 55; ++t) {
      tick(simulation, button_reel_in | button_right);
      ASSERT_FALSE(simulation.player().is_on_ground()) << k << " " << t;
    }
  }
  EXPECT_GT(simulation.player().position().x, 12.0);
}

TEST(TwoLines, AreOneWhereTheLevelDoesNotSay) {
  const Level level = level_with({10.0, 1.0}, {ceiling()});
  Simulation simulation(level);
  throw_line(simulation, button_throw_second, {8.0, 7.0});
  EXPECT_EQ(simulation.player().lines().all().size(), 1U);
  EXPECT_TRUE(line(simulation, 0).is_held());
  tick(simulation, button_throw);
  EXPECT_FALSE(line(simulation, 0).is_held());
}

TEST(TwoLines, AreRefusedInOtherNumbers) {
  for (const std::int64_t lines : {0, 3}) {
    EXPECT_EQ(
        test_support::refusal<engine::MapError>([lines] {
          level_with({10.0, 1.0}, {}, lines);
        }),
        "test.tmj: map: property \"lines\" is " + std::to_string(lines) + ", accepted is a whole number from 1 to 2");
  }
}

/// The crate is pushed off its shelf, and hangs.
TEST(Line, HasTheAccuracyOfItsMap) {
  const auto accuracy_with = [](const std::function<void(engine::Properties&)>& set) {
    engine::TiledMap map = small_map({ceiling()}, {10.0, 1.0}, 1.0);
    set(map.properties);
    const Level level = level_of(std::move(map));
    Simulation simulation(level);
    throw_line(simulation, button_throw, {10.0, 8.0});
    return simulation.scene().coupling().cord(line(simulation, 0).cord().value()).direct().def().accuracy;
  };
  ribbon::Accuracy expected = LineTuning{}.accuracy;
  EXPECT_EQ(accuracy_with([](engine::Properties&) {}), expected);
  expected.substeps = 8;
  EXPECT_EQ(accuracy_with([](engine::Properties& p) { p.insert("line_substeps", std::int64_t{8}); }), expected);
  expected = LineTuning{}.accuracy;
  expected.tolerance = 1e-5;
  EXPECT_EQ(accuracy_with([](engine::Properties& p) { p.insert("line_tolerance", 1e-5); }), expected);
  EXPECT_THROW(accuracy_with([](engine::Properties& p) { p.insert("line_substeps", std::int64_t{257}); }),
               engine::MapError);
}

TEST(Knot, HangsACrateFromTheCeiling) {
  const auto height = [](bool ties) {
    const Level level = level_with(
        {10.0, 5.0}, {ceiling(), ground({8.0, 4.0}, {14.0, 5.0}), sticky(crate({13.0, 5.0}, {0.8, 0.8}, 20.0))}, 2);
    Simulation simulation(level);
    throw_line(simulation, button_throw, {13.0, 5.4});
    throw_line(simulation, button_throw_second, {12.0, 7.9});
    EXPECT_TRUE(line(simulation, 0).is_held() && line(simulation, 1).is_held());
    if (ties) tick(simulation, button_tie);
    EXPECT_EQ(simulation.player().lines().held() == nullptr, ties);
    if (!ties) tick(simulation, button_throw | button_throw_second);
    b2Body& load = body_of(simulation, engine::BodyKind::load);
    load.SetLinearVelocity({6.0F, 0.0F});
    tick(simulation, 0, 600);
    return static_cast<double>(load.GetPosition().y);
  };
  EXPECT_GT(height(true), 1.8);
  EXPECT_LT(height(false), 1.5);
}

TEST(Knot, FixesALineToWhatIsAtHand) {
  const Level level = level_with({10.0, 1.0}, {hook({10.5, 3.2}), sticky(crate({15.0, 1.0}, {0.8, 0.8}, 20.0))});
  Simulation simulation(level);
  throw_line(simulation, button_throw, {15.0, 1.4});
  ASSERT_TRUE(line(simulation, 0).is_held());
  const ribbon::box2d::CordId cord = *line(simulation, 0).cord();
  tick(simulation, button_tie);
  tick(simulation, 0, 60);
  EXPECT_EQ(simulation.player().lines().held(), nullptr);
  const auto left = simulation.scene().coupling().cord(cord);
  ASSERT_TRUE(left.is_valid());
  EXPECT_LT(length(left.positions().back() - Vec2{10.5, 3.2}), 1e-6);
  EXPECT_EQ(left.kind(static_cast<int>(left.positions().size()) - 1), ribbon::PointKind::constrained);
  throw_line(simulation, button_throw, {15.0, 1.4});
  EXPECT_NE(*line(simulation, 0).cord(), cord) << "a new line";
}

TEST(Knot, NeedsALineAndAPlace) {
  const Level level = level_with({10.0, 1.0}, {ceiling()}, 2);
  Simulation simulation(level);
  tick(simulation, button_tie);
  EXPECT_EQ(simulation.scene().coupling().size(), 0);
  throw_line(simulation, button_throw, {8.0, 7.0});
  tick(simulation, button_tie);
  EXPECT_TRUE(line(simulation, 0).is_held()) << "the ceiling is out of reach";
}

TEST(Knot, TakesTheFirstLineAwayWhenThereAreTooMany) {
  const Level level = level_with({10.0, 1.0}, {ceiling()}, 2);
  Simulation simulation(level);
  for (int k = 0; k < 6; ++k) {
    throw_line(simulation, button_throw, {8.0, 7.0});
    throw_line(simulation, button_throw_second, {12.0, 7.0});
    tick(simulation, button_tie);
  }
  EXPECT_EQ(simulation.scene().coupling().size(), static_cast<int>(Lines::most_knots));
  tick(simulation, button_retry);
  EXPECT_EQ(simulation.scene().coupling().size(), 0) << "after a fall all is as at the start";
}

/// In flight, held, and knotted, by a moving body too.
TEST(Lines, GoBack) {
  const Level level = level_with({10.0, 1.0}, {ceiling(), sticky(crate({15.0, 1.0}, {0.8, 0.8}, 20.0))}, 2);
  Simulation simulation(level);
  throw_line(simulation, button_throw, {15.0, 1.4});
  const auto play_on = [&simulation] {
    tick(simulation, button_throw_second | button_reel_in, 30, {12.0, 7.9});
    tick(simulation, button_tie);
    tick(simulation, button_throw | button_right, 30, {12.0, 7.9});
    return simulation.hash();
  };
  SavedTick saved;
  simulation.save(saved);
  const ribbon::box2d::StateHash first = play_on();
  ASSERT_TRUE(simulation.restore(saved, nullptr));
  EXPECT_TRUE(line(simulation, 0).is_held());
  EXPECT_EQ(play_on(), first);
}

}  // namespace
}  // namespace game
