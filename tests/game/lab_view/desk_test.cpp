// The desk shows its experiment smoothly, whatever the speed, and as it is while it stands still.

#include "game/lab_view/desk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "ribbon/box2d/convert.h"

namespace game::lab {
namespace {

using ribbon::Vec2;
using ribbon::box2d::to_double;

constexpr std::int64_t frame_ns = 1'000'000'000 / 144;

std::int64_t no_clock() { return 0; }

class DeskTest : public testing::Test {
 protected:
  DeskTest() {
    for (int k = 0; k < 20; ++k) desk.run(1'000'000'000 / 60, {});  // so that its load moves
  }

  const b2Body& load() const { return *desk.experiment().benches()[0]->bodies().back().body; }
  Vec2 shown_load() const { return desk.picture().benches[0].snapshot.bodies[number_of(load())].position; }
  void slow_down_to(int factor) {
    while (desk.state().slowed != factor) desk.press(Button::slow);
  }
  void turn(Knob knob, double value) {
    ConsoleRequest request;
    request.turn = {knob, value};
    desk.act(request);
  }
  /// Returns how far the load is shown to move in each frame, m; the button is pressed before the first of them.
  std::vector<double> ways(int frames, std::optional<Button> button = {}) {
    std::vector<double> all;
    Vec2 before = shown_load();
    if (button) desk.press(*button);
    for (int k = 0; k < frames; ++k) {
      desk.run(frame_ns, {});
      const Vec2 now = shown_load();
      all.push_back(length(now - before));
      before = now;
    }
    return all;
  }

  Desk desk{scene_named("heavy_load"), no_clock};
};

/// The load accelerates little in the half second that is shown, so every frame has nearly the same share of the way.
TEST_F(DeskTest, MotionIsEvenAtEverySpeed) {
  for (const int factor : {1, 2, 4, 10}) {
    slow_down_to(factor);
    const int ticks = desk.experiment().ticks();
    const std::vector<double> all = ways(72);
    EXPECT_NEAR(desk.experiment().ticks() - ticks, 30.0 / factor, 1.0);
    const auto [least, most] = std::minmax_element(all.begin(), all.end());
    EXPECT_GT(*least, 0.0) << factor;
    EXPECT_LT(*most, (factor == 1 ? 4.0 : 2.0) * *least) << factor;
  }
}

/// Chains and arrows of forces move as evenly as cords and bodies do.
TEST_F(DeskTest, ChainsAndForcesMoveBetweenTicksToo) {
  slow_down_to(10);
  desk.run(frame_ns, {});
  const Picture before = desk.picture();
  desk.run(frame_ns, {});
  const Picture now = desk.picture();
  EXPECT_NE(before.benches[1].chains[0].back().second, now.benches[1].chains[0].back().second);
  EXPECT_NE(before.benches[0].snapshot.cords[0].back(), now.benches[0].snapshot.cords[0].back());
  Desk columns{scene_named("buckling"), no_clock};
  for (int k = 0; k < 60; ++k) columns.run(1'000'000'000 / 60, {});
  while (columns.state().slowed != 10) columns.press(Button::slow);
  columns.run(frame_ns, {});
  const Vec2 tip = columns.picture().forces.back().tip;
  columns.run(frame_ns, {});
  EXPECT_NE(columns.picture().forces.back().tip, tip);
}

/// A pause shows the last tick: at a tenth of the speed the picture moves on to it, then stands. Nothing jumps, nor
/// when it goes on.
TEST_F(DeskTest, APauseEndsAtTheLastTickWithoutAJump) {
  slow_down_to(10);
  const std::vector<double> moving = ways(30);
  const double even = *std::max_element(moving.begin(), moving.end());
  const int ticks = desk.experiment().ticks();
  for (const double way : ways(30, Button::pause)) EXPECT_LT(way, 1.5 * even);
  EXPECT_EQ(desk.experiment().ticks(), ticks);
  EXPECT_EQ(shown_load(), to_double(load().GetPosition()));
  for (const double way : ways(30)) EXPECT_EQ(way, 0.0);
  for (const double way : ways(72, Button::pause)) EXPECT_LT(way, 1.5 * even);
  EXPECT_NEAR(desk.experiment().ticks() - ticks, 3, 1);
}

TEST_F(DeskTest, AStepAndARestartShowTheirTickAtOnce) {
  slow_down_to(10);
  ways(10);
  desk.press(Button::step);
  desk.run(frame_ns, {});
  EXPECT_EQ(shown_load(), to_double(load().GetPosition()));
  desk.press(Button::pause);
  ways(30);
  desk.press(Button::restart);
  EXPECT_EQ(shown_load(), to_double(load().GetPosition()));
  ways(30);
  turn(Knob::start_angle, 30.0);
  EXPECT_EQ(desk.experiment().ticks(), 0);
  EXPECT_EQ(shown_load(), to_double(load().GetPosition()));
}

/// A slider that is held asks for its value in every frame. That must not hold up the first tick.
TEST_F(DeskTest, ASliderThatIsHeldDoesNotStopTheTime) {
  slow_down_to(10);
  desk.press(Button::restart);
  for (int k = 0; k < 72; ++k) {
    turn(Knob::load_ratio, 500.0);
    desk.run(frame_ns, {});
  }
  EXPECT_NEAR(desk.experiment().ticks(), 3, 1);
}

}  // namespace
}  // namespace game::lab
