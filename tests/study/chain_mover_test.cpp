#include "tests/study/chain_mover.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "game/simulation/buttons.h"
#include "tests/study/errors.h"
#include "tests/study/level_file.h"
#include "tests/study/level_study.h"
#include "tests/study/trace.h"
#include "tests/support/mixed_level.h"

namespace study {
namespace {

using engine::TickInput;
using ribbon::Vec2;

constexpr const char* level_path = TEST_ASSETS "/levels/first_swing.tmj";

Setting chain(int substeps, const char* solver = "box2d_chain") { return {solver, "", substeps, 0.0, 1.0, 8}; }

game::Level converged() { return LevelFile(level_path).with(Setting{"direct", "tr_bdf2", 16, 1e-7}); }

Trace run_chain(const game::Level& level, const std::vector<TickInput>& inputs, const Setting& setting) {
  return run(level, inputs, chain_method(setting));
}

std::vector<TickInput> pressed(std::size_t ticks, int buttons) {
  TickInput input;
  input.buttons = static_cast<std::uint16_t>(buttons);
  return std::vector<TickInput>(ticks, input);
}

/// Returns a level with one cord from its pin along `way` [m], and the player's hand at three quarters of it.
game::Level one_cord(Vec2 way) {
  game::Level level = converged();
  std::erase_if(level.map.objects, [](const engine::MapObject& o) { return o.kind == "cord" && o.name != "cord 1"; });
  for (engine::MapObject& object : level.map.objects) {
    if (object.kind == "cord") object.points.back() = object.points.front() + way;
  }
  const Vec2 point = level.make_scene()->coupling().cord(0).positions()[30];
  const game::PlayerTuning tuning;
  level.player_start = point - Vec2{0.0, tuning.hand_height + 0.5 * tuning.height};
  return level;
}

constexpr Vec2 slanted{4.8, -3.6};
constexpr Vec2 hanging{0.0, -6.0};

TEST(ChainMover, AFreeChainMovesAsTheCord) {
  const game::Level level = converged();
  const std::vector<TickInput> nothing(20);
  const Trace cords = run(level, nothing);
  const double one = difference(run_chain(level, nothing, chain(1)), cords, 20).position_m;
  const double sixteen = difference(run_chain(level, nothing, chain(16)), cords, 20).position_m;
  EXPECT_LT(sixteen, 2e-3);  // at the hammock's corner, because the springs of joints differ where they bend far
  EXPECT_GT(one, 20.0 * sixteen);
}

TEST(ChainMover, AStraightChainWithBendingAndDragConvergesToTheCord) {
  const game::Level level = one_cord(slanted);
  const std::vector<TickInput> nothing(20);
  const Trace cords = run(level, nothing);
  const double eight = difference(run_chain(level, nothing, chain(8)), cords, 20).position_m;
  const double thirty_two = difference(run_chain(level, nothing, chain(32)), cords, 20).position_m;
  EXPECT_LT(thirty_two, 1e-2);
  EXPECT_GT(eight, 2.0 * thirty_two);
}

TEST(ChainMover, APlayerSwingsOnAChainAsOnACord) {
  const game::Level level = one_cord(slanted);
  const std::vector<TickInput> inputs = pressed(60, game::button_grab);
  const Trace cords = run(level, inputs);
  ASSERT_LT(cords.player.back().x, cords.player.front().x - 2.5);  // the player swings
  const Errors few = difference(run_chain(level, inputs, chain(4)), cords, 60);
  const Errors many = difference(run_chain(level, inputs, chain(64)), cords, 60);
  EXPECT_LT(many.player_m, 5e-3);
  EXPECT_LT(many.position_m, 5e-3);
  EXPECT_GT(few.player_m, 50.0 * many.player_m);
}

TEST(ChainMover, ACaughtPointComesToTheHand) {
  game::Level level = one_cord(slanted);
  level.player_start = level.player_start + Vec2{-0.2, -0.5};
  const std::vector<TickInput> inputs = pressed(30, game::button_grab);
  for (const char* solver : {"box2d_chain", "box2d_max_distance"}) {
    LevelRun run(level, inputs, chain_method(chain(16, solver)));
    run.reset();
    double first = 0.0;
    double last = 0.0;
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      run.tick();
      run.show();
      const auto held = run.simulation().scene().coupling().body(run.simulation().player().body()).held_place();
      ASSERT_TRUE(held);
      const auto x = run.simulation().scene().coupling().cord(held->cord).positions();
      last = length(x[static_cast<std::size_t>(held->point)] - run.simulation().player().hand());
      if (k == 0) first = last;
    }
    EXPECT_GT(first, 0.4);
    EXPECT_LT(last, 0.01);
  }
}

TEST(ChainMover, AMaxDistanceJointLimitsTheHandToTheLengthOfTheCord) {
  const game::Level level = one_cord(slanted);
  const std::vector<TickInput> inputs = pressed(40, game::button_grab);
  const Trace cords = run(level, inputs);
  const auto error = [&](const char* solver) {
    return difference(run_chain(level, inputs, chain(4, solver)), cords, 40).player_m;
  };
  EXPECT_GT(error("box2d_chain"), 0.2);
  EXPECT_LT(error("box2d_max_distance"), 0.01);
}

TEST(ChainMover, ReleasingRemovesTheJointsOfTheGrip) {
  const game::Level level = one_cord(hanging);
  std::vector<TickInput> inputs = pressed(20, game::button_grab);
  inputs.resize(40);
  LevelRun run(level, inputs, chain_method(chain(4, "box2d_max_distance")));
  run.reset();
  const int joints = run.simulation().scene().world().GetJointCount();
  const auto tick = [&](int count) {
    for (int k = 0; k < count; ++k) {
      run.tick();
      run.show();
    }
  };
  tick(20);
  EXPECT_EQ(run.simulation().scene().world().GetJointCount(), joints + 2);
  const Vec2 before = run.simulation().player().position();
  tick(20);
  EXPECT_EQ(run.simulation().scene().world().GetJointCount(), joints);
  EXPECT_LT(run.simulation().player().position().y, before.y - 0.3);  // the player falls
}

/// The player runs, and jumps one tick after its feet have left the ground, which the game allows.
TEST(ChainMover, APlayerWithoutACordMovesAsWithCords) {
  std::vector<TickInput> inputs = pressed(30, game::button_right);
  for (const int buttons : {game::button_right | game::button_jump, 0 | game::button_right}) {
    for (int k = 0; k < 2; ++k) inputs.push_back(pressed(1, buttons).front());
  }
  for (const TickInput& input : pressed(26, game::button_right)) inputs.push_back(input);
  inputs[32] = inputs[31];
  inputs[31] = inputs[33];
  for (std::size_t k = 32; k < inputs.size(); ++k) inputs[k].buttons |= game::button_jump;  // for a high jump
  const game::Level level = converged();
  const Trace cords = run(level, inputs);
  ASSERT_GT(cords.player[45].y, cords.player[29].y + 1.0);
  const Trace chains = run_chain(level, inputs, chain(4));
  // Box2D moves the player upright within the tick in which it lands, and not in four ticks.
  EXPECT_LT(difference(cords, chains, 60).player_m, 1e-3);
  EXPECT_NEAR(length(cords.player.back() - chains.player.back()), 0.0, 1e-3);
}

TEST(ChainMover, ARestartResetsTheChains) {
  const game::Level level = one_cord(hanging);
  std::vector<TickInput> inputs = pressed(20, game::button_grab);
  for (const TickInput& input : pressed(10, game::button_restart)) inputs.push_back(input);
  const Trace restarted = run_chain(level, inputs, chain(2));
  const Trace fresh = run_chain(level, pressed(10, 0), chain(2));
  EXPECT_EQ(restarted.places.back(), fresh.places.back());
  EXPECT_EQ(restarted.player.back(), fresh.player.back());
}

std::string reason_of(const game::Level& level, const std::vector<TickInput>& inputs) {
  return chains_unsupported_reason(level, inputs, run(level, pressed(1, 0)));
}

TEST(ChainMover, RibbonsAndDragsHaveNoChains) {
  EXPECT_EQ(reason_of(converged(), pressed(3, game::button_grab)), "");
  EXPECT_NE(reason_of(test_support::mixed_swing(), {}).find("cord 0 of the level is a ribbon"), std::string::npos);
  EXPECT_NE(reason_of(converged(), pressed(3, game::button_drag)).find("drags cords"), std::string::npos);
  game::Level windy = converged();
  windy.map.properties.insert("wind_x", 3.0);
  EXPECT_NE(reason_of(windy, {}).find("wind"), std::string::npos);
  const auto own = [](const char* name) {
    return reason_of(LevelFile(TEST_ASSETS "/levels/" + std::string(name)).level(), {});
  };
  EXPECT_NE(own("heavy_load.tmj").find("is held by a cord"), std::string::npos);
  EXPECT_NE(own("swing_me_across.tmj").find("for two"), std::string::npos);
  Trace cut = run(converged(), pressed(2, 0));
  cut.cords.back().pop_back();
  EXPECT_NE(chains_unsupported_reason(converged(), {}, cut).find("come and go"), std::string::npos);
}

TEST(ChainMover, AStudyHasChainsWhereTheyAreApplicable) {
  StudyOptions options;
  options.quick = true;
  options.repeats = 1;
  const auto chains_in = [&](int buttons) {
    const Study study = measure(LevelFile(level_path), pressed(3, buttons), options);
    EXPECT_TRUE(study.complete);
    for (const Measured& m : study.settings) EXPECT_EQ(m.failure, "") << m.setting.solver;
    for (const Point& p : applicable(study))
      EXPECT_EQ(p.not_compared, p.method != "direct" || p.setting.find('x') != std::string::npos);
    EXPECT_EQ(study.no_chains_reason.empty(), (buttons & game::button_drag) == 0);
    return std::count_if(study.settings.begin(), study.settings.end(),
                         [](const Measured& m) { return is_box2d(m.setting); });
  };
  EXPECT_EQ(chains_in(game::button_right), 2);
  EXPECT_EQ(chains_in(game::button_drag), 0);
}

}  // namespace
}  // namespace study
