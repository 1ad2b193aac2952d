// What can be placed in a sandbox, and its recordings.

#include "game/simulation/yard.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "game/simulation/recorded_run.h"
#include "game/simulation/run_header.h"
#include "tests/game/program.h"
#include "tests/game/simulation/small_level.h"

namespace game {
namespace {

Level new_sandbox() { return load_level("sandbox"); }

/// All kinds of things, apart from each other and above the ground.
Yard one_of_each() {
  Yard yard;
  double x = 3.0;
  for (const Thing thing : all_things) {
    yard.things.push_back(thing_at(thing, {x, 12.5}, {x + 2.505, 13.0}));
    x += 6.0;
  }
  return yard;
}

TEST(Yard, ItsTextIsItself) {
  Yard yard = one_of_each();
  const Level level = new_sandbox();
  EXPECT_EQ(yard_of(yard_text(yard), level), yard);
  yard.start = Vec2{12.34, 3.01};
  EXPECT_EQ(yard_of(yard_text(yard), level), yard);
  EXPECT_EQ(yard_text({{thing_at(Thing::ball, {1.5, 2.0}, {9.0, 9.0})}, Vec2{1.0, 3.0}}), "start 100 300;ball 150 200");
  EXPECT_EQ(yard_text({}), "");
  EXPECT_EQ(yard_of("", level), Yard{});
}

TEST(Yard, OtherTextsAreRefused) {
  const Level level = new_sandbox();
  std::string too_many;
  for (std::size_t k = 0; k <= Yard::max_things; ++k) too_many += "ball 200 900;";
  for (const std::string& text :
       {std::string("anvil 100 200"), std::string("ball 100"), std::string("ball 100 200 300"),
        std::string("ball 1.5 200"), std::string("ball 99999 200"), std::string("rope 100 900 200"),
        std::string("rope 200 900 210 900"), std::string("rope 200 900 1500 900"), std::string("ball -100 900"),
        std::string("ball 100 900;;"), std::string("start 100 300 4"), std::string("start -100 300"), too_many}) {
    EXPECT_FALSE(yard_of(text, level)) << text;
  }
  EXPECT_TRUE(yard_of("ball 200 900", level));
  EXPECT_FALSE(yard_of("ball 200 900", load_level("first_swing"))) << "only a sandbox has a yard";
}

TEST(Yard, ChangesNothingElseOfTheLevel) {
  Level level = new_sandbox();
  const std::size_t objects = level.map.objects.size();
  const Vec2 start = level.player_start;
  Yard yard = one_of_each();
  yard.start = Vec2{20.0, 3.0};
  set_yard(level, yard);
  EXPECT_EQ(level.map.objects.size(), objects + yard.things.size());
  EXPECT_EQ(level.player_start, *yard.start);
  yard.things.pop_back();
  set_yard(level, yard);
  EXPECT_EQ(level.map.objects.size(), objects + yard.things.size());
  set_yard(level, {});
  EXPECT_EQ(level.map.objects.size(), objects);
  EXPECT_EQ(level.player_start, start);
}

/// Whatever its ends are, a thing can be built, and stays where it is.
TEST(Yard, AThingInAnyDirectionIsBuilt) {
  for (const Thing thing : all_things) {
    if (!has_two_ends(thing)) continue;
    for (const double span : {Yard::min_span + 0.01, 4.0, Yard::max_span - 0.02}) {
      for (int turn = 0; turn < 16; ++turn) {
        const double angle = turn * std::numbers::pi / 8.0;
        const Vec2 from{20.0, 12.0};
        engine::TiledMap map = small_map({}, {3.0, 2.0});
        map.size = {60.0, 40.0};
        Level level = level_of(map);
        level.sandbox = true;
        const PlacedThing placed = thing_at(thing, from, from + span * Vec2{std::cos(angle), std::sin(angle)});
        set_yard(level, {{placed}, {}});
        Simulation simulation(level);
        run(simulation, 90);
        for (const Vec2 at : simulation.current().cords.at(0)) {
          ASSERT_LT(length(at - from), 1.2 * span + 0.5) << thing_name(thing) << ' ' << span << ' ' << turn;
        }
      }
    }
  }
}

TEST(Yard, FaultsAreFound) {
  Level level = new_sandbox();
  const Simulation empty(level);
  const auto fault = [&](Thing thing, Vec2 first, Vec2 second = {}) {
    return fault_of(empty, thing_at(thing, first, second));
  };
  EXPECT_EQ(fault(Thing::ball, {8.0, 12.0}), std::nullopt);
  EXPECT_EQ(fault(Thing::ball, {0.4, 12.0}), PlacingFault::outside);
  EXPECT_EQ(fault(Thing::rope, {4.0, 12.0}, {4.0, 19.9}), PlacingFault::outside);
  EXPECT_EQ(fault(Thing::rope, {4.0, 12.0}, {4.9, 12.0}), PlacingFault::too_short);
  EXPECT_EQ(fault(Thing::rope, {4.0, 12.0}, {14.1, 12.0}), PlacingFault::too_long);
  EXPECT_EQ(fault(Thing::rope, {4.0, 12.0}, {14.0, 12.0}), std::nullopt);
  EXPECT_EQ(fault(Thing::crate, {8.0, 3.0}), PlacingFault::in_the_way) << "the ground";
  EXPECT_EQ(fault(Thing::peg, level.player_start + Vec2{0.0, 1.0}), PlacingFault::in_the_way) << "the player";
  const Vec2 body = level.player_start + Vec2{0.0, 0.8};
  EXPECT_EQ(fault(Thing::trampoline, body - Vec2{1.0, 0.0}, body + Vec2{3.0, 0.0}), PlacingFault::in_the_way);
  EXPECT_EQ(fault(Thing::trampoline, body + Vec2{1.0, 0.0}, body + Vec2{3.0, 0.0}), std::nullopt);

  Yard yard;
  for (std::size_t k = 0; k < Yard::max_things; ++k)
    yard.things.push_back(thing_at(Thing::ball, {6.0 + 1.5 * static_cast<double>(k), 12.0}, {}));
  set_yard(level, yard);
  const Simulation full(level);
  EXPECT_EQ(fault_of(full, thing_at(Thing::ball, {8.0, 15.0}, {})), PlacingFault::too_many);
  EXPECT_EQ(fault_of(full, thing_at(Thing::ball, {8.0, 15.0}, {}), 0), std::nullopt) << "it replaces one";
  EXPECT_EQ(fault_of(full, thing_at(Thing::ball, {6.2, 12.0}, {}), 0), std::nullopt) << "its own place is free";
  EXPECT_EQ(fault_of(full, thing_at(Thing::ball, {6.2, 12.0}, {}), 1), PlacingFault::in_the_way);
}

TEST(Yard, TheNearestThingIsPicked) {
  Yard yard;
  yard.things = {thing_at(Thing::rope, {2.0, 5.0}, {8.0, 5.0}), thing_at(Thing::ball, {5.0, 6.0}, {})};
  EXPECT_EQ(nearest_thing(yard, {3.0, 5.2}), 0U);
  EXPECT_EQ(nearest_thing(yard, {5.0, 5.6}), 1U);
  EXPECT_EQ(nearest_thing(yard, {5.0, 7.0}), std::nullopt);
}

/// Returns the height of a crate in the yard after four seconds, m.
double height_of_crate(const Yard& yard) {
  Level level = new_sandbox();
  set_yard(level, yard);
  Simulation simulation(level);
  run(simulation, 240);
  for (const engine::SceneBody& made : simulation.scene().bodies()) {
    if (is_placed(made.object) && made.kind == engine::BodyKind::load)
      return static_cast<double>(made.body->GetPosition().y);
  }
  return 0.0;
}

/// A rope bears a crate that was placed above it.
TEST(Yard, ItsThingsMeetEachOther) {
  const PlacedThing crate = thing_at(Thing::crate, {45.0, 9.0}, {});
  EXPECT_NEAR(height_of_crate({{crate}, {}}), 3.45, 0.1) << "on the ground";
  const double on_rope = height_of_crate({{thing_at(Thing::rope, {43.0, 8.0}, {47.0, 8.0}), crate}, {}});
  EXPECT_GT(on_rope, 6.5);
  EXPECT_LT(on_rope, 8.5);
}

/// A recording of a yard with things is verified; it has them itself.
TEST(Yard, IsRecordedAndVerified) {
  const std::string path = test_support::scratch("yard.replay");
  RunOptions options;
  options.level = "sandbox";
  {
    RecordedRun run(options);
    Level level = run.level();
    Yard yard = one_of_each();
    yard.start = Vec2{16.5, 3.0};
    set_yard(level, yard);
    run.set_level(std::move(level), false);
    run.begin(path);
    for (int k = 0; k < 120; ++k) run.tick(press(k % 50 < 30 ? button_right : button_jump | button_grab));
    run.finish();
  }
  RunOptions verify;
  verify.replay = path;
  verify.verify = true;
  RecordedRun again(verify);
  EXPECT_EQ(again.level().yard.things.size(), all_things.size());
  while (!again.is_over()) again.tick({});
  EXPECT_EQ(again.exit_status(), 0) << again.closing_line();
}

/// A recording cannot bring things into a level with a flag.
TEST(Yard, OfALevelWithAFlagIsRefused) {
  const std::string path = test_support::scratch("cheat.replay");
  const Level level = load_level("first_swing");
  engine::ReplayHeader header = replay_header(level);
  header.settings["yard"] = std::string("rope 500 900 900 900");
  engine::ReplayWriter(path, header).finish();
  RunOptions options;
  options.replay = path;
  EXPECT_TRUE(test_support::says(test_support::refusal<engine::ReplayError>([&] { const RecordedRun run(options); }),
                                 "setting \"yard\" differs"));
}

}  // namespace
}  // namespace game
