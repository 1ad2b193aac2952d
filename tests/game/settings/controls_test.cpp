// From key and pad events to the input of a tick.

#include "game/settings/controls.h"

#include <gtest/gtest.h>

#include "game/simulation/buttons.h"

namespace game {
namespace {

using engine::InputState;
using engine::Key;
using engine::MouseButton;
using engine::PadButton;
using engine::PadStick;

constexpr ribbon::Vec2 hand{10.0, 5.0};

/// Events of an InputState, and the resulting ticks.
struct Hands {
  InputState events;
  Settings settings{};
  Controls controls{};
  bool dragging = false;

  void frame(ribbon::Vec2 mouse = {}) { controls.take(events.take(), settings, mouse, dragging); }
  int tick() { return controls.next(hand).buttons; }
};

TEST(Controls, ATapBetweenTwoFramesCountsInTheNextTickOnly) {
  Hands hands;
  hands.events.key_down(Key::space);
  hands.events.key_up(Key::space);
  hands.frame();
  EXPECT_EQ(hands.tick(), button_jump);
  EXPECT_EQ(hands.tick(), 0);
}

TEST(Controls, TheKnifeCutsOnceAPress) {
  Hands hands;
  hands.events.key_down(Key::c);
  hands.frame();
  EXPECT_EQ(hands.tick(), button_cut);
  hands.events.key_up(Key::c);
  hands.frame();
  EXPECT_EQ(hands.tick(), 0);
  hands.events.pad_down(PadButton::left_stick);
  hands.frame();
  EXPECT_EQ(hands.tick(), button_cut);
  hands.controls.discard();
  hands.frame();
  EXPECT_EQ(hands.tick(), 0) << "a button that is down from a menu does not cut";
}

TEST(Controls, ATapInAFrameWithoutATickCountsInTheNextFrames) {
  Hands hands;
  hands.events.pad_down(PadButton::a);
  hands.frame();
  hands.events.pad_up(PadButton::a);
  hands.frame();
  EXPECT_EQ(hands.tick(), button_jump);
  EXPECT_EQ(hands.tick(), 0);
}

TEST(Controls, AHeldButtonCountsInEveryTick) {
  Hands hands;
  hands.events.key_down(Key::d);
  hands.events.trigger(PadButton::right_trigger, 0.9);
  hands.frame();
  for (int k = 0; k < 3; ++k) EXPECT_EQ(hands.tick(), button_right | button_grab);
  hands.events.pad_lost();
  hands.frame();
  EXPECT_EQ(hands.tick(), button_right) << "an unplugged gamepad holds nothing";
}

/// Until it is pressed again.
TEST(Controls, AKeyHeldBeforeAFallIsIgnored) {
  Hands hands;
  hands.events.key_down(Key::d);
  hands.frame();
  EXPECT_EQ(hands.tick(), button_right);
  hands.controls.ignore_held();
  EXPECT_EQ(hands.tick(), 0);
  hands.events.key_down(Key::space);
  hands.frame();
  EXPECT_EQ(hands.tick(), button_jump);
  hands.events.key_up(Key::d);
  hands.frame();
  hands.events.key_down(Key::d);
  hands.frame();
  EXPECT_EQ(hands.tick() & button_right, button_right);
}

TEST(Controls, ASingleNotchOfTheWheelReelsForAWhile) {
  Hands hands;
  hands.events.wheel({0.0, -1.0});
  hands.frame();
  for (int k = 0; k < Controls::wheel_ticks; ++k) EXPECT_EQ(hands.tick(), button_reel_out) << k;
  EXPECT_EQ(hands.tick(), 0);
}

TEST(Controls, IfPressesToggleTheNextPressOrAJumpReleases) {
  Hands hands;
  hands.settings.toggle_grab = true;
  const auto tap = [&hands](Key key) {
    hands.events.key_down(key);
    hands.events.key_up(key);
    hands.frame();
    return hands.tick();
  };
  EXPECT_EQ(tap(Key::e), button_grab);
  hands.frame();
  EXPECT_EQ(hands.tick(), button_grab) << "it holds on";
  EXPECT_EQ(tap(Key::e), 0);
  EXPECT_EQ(tap(Key::e), button_grab);
  EXPECT_EQ(tap(Key::space), button_jump);
  EXPECT_EQ(hands.tick(), 0);
}

TEST(Controls, TheLeftMouseButtonThrowsAndInTheDebugViewDrags) {
  Hands hands;
  hands.events.button_down(MouseButton::left);
  hands.frame();
  EXPECT_EQ(hands.tick(), button_throw);
  hands.dragging = true;
  hands.frame();
  EXPECT_EQ(hands.tick(), button_drag);
  hands.events.button_down(MouseButton::right);
  hands.frame();
  EXPECT_EQ(hands.tick(), button_drag | button_throw_second);
}

TEST(Controls, TheMouseAimsUntilAStickDoes) {
  Hands hands;
  hands.events.mouse_at({3.0, 4.0});
  hands.frame({7.25, -3.5});
  EXPECT_EQ(engine::pointer(hands.controls.next(hand)), (ribbon::Vec2{7.25, -3.5}));
  hands.events.stick_x(PadStick::right, -1.0);
  hands.frame({7.25, -3.5});
  EXPECT_EQ(engine::pointer(hands.controls.next(hand)), (hand + ribbon::Vec2{-Controls::pad_aim, 0.0}));
  hands.events.stick_x(PadStick::right, 0.0);
  hands.frame({7.25, -3.5});
  EXPECT_EQ(engine::pointer(hands.controls.next(hand)), (hand + ribbon::Vec2{-Controls::pad_aim, 0.0}))
      << "a stick let go points where it did";
  hands.events.mouse_at({30.0, 4.0});
  hands.frame({8.0, 1.0});
  EXPECT_EQ(engine::pointer(hands.controls.next(hand)), (ribbon::Vec2{8.0, 1.0}));
}

TEST(Controls, PressesBeforeAPauseAreDiscarded) {
  Hands hands;
  hands.events.key_down(Key::space);
  hands.events.key_up(Key::space);
  hands.events.wheel({0.0, 1.0});
  hands.frame();
  hands.controls.discard();
  EXPECT_EQ(hands.tick(), 0);
}

TEST(InputState, ASticksDirectionsAndTriggersAreButtonsWithSomeSlack) {
  InputState state;
  state.stick_x(PadStick::left, 0.45);
  EXPECT_FALSE(state.take().pressed(PadButton::left_stick_right));
  state.stick_x(PadStick::left, 0.55);
  EXPECT_TRUE(state.take().pressed(PadButton::left_stick_right));
  state.stick_x(PadStick::left, 0.45);
  EXPECT_TRUE(state.take().held(PadButton::left_stick_right)) << "it does not flutter";
  state.stick_x(PadStick::left, -1.0);
  const engine::WindowInput turned = state.take();
  EXPECT_TRUE(turned.released(PadButton::left_stick_right) && turned.pressed(PadButton::left_stick_left));
  EXPECT_EQ(turned.left_stick, (ribbon::Vec2{-1.0, 0.0}));
  state.stick_x(PadStick::left, 0.15);
  EXPECT_EQ(state.take().left_stick, ribbon::Vec2{}) << "a stick at rest is not quite in the middle";
}

TEST(InputState, AnUnpluggedGamepadReleasesEverythingAndTheKeyboardDoesNot) {
  InputState state;
  state.pad_found();
  state.pad_down(PadButton::a);
  state.stick_y(PadStick::right, 1.0);
  state.key_down(Key::d);
  EXPECT_EQ(state.take().pads, 1);
  state.pad_lost();
  const engine::WindowInput lost = state.take();
  EXPECT_TRUE(lost.pad_lost && lost.pad_held.none() && lost.released(PadButton::a));
  EXPECT_EQ(lost.right_stick, ribbon::Vec2{});
  EXPECT_EQ(lost.pads, 0);
  EXPECT_TRUE(lost.held(Key::d));
  EXPECT_FALSE(state.take().pad_lost);
}

TEST(InputState, WheelAndTextLastForOnePoll) {
  InputState state;
  state.wheel({0.0, 1.0});
  state.wheel({0.0, 0.5});
  state.text("a");
  state.text("ä");
  const engine::WindowInput input = state.take();
  EXPECT_EQ(input.wheel, (ribbon::Vec2{0.0, 1.5}));
  EXPECT_TRUE(input.pressed(engine::WheelTurn::up));
  EXPECT_EQ(input.text, "aä");
  const engine::WindowInput next = state.take();
  EXPECT_TRUE(next.text.empty() && next.wheel == ribbon::Vec2{} && next.wheel_turned.none());
}

TEST(Controls, AButtonStillDownFromAMenuIsIgnoredUntilItWasUp) {
  Hands hands;
  hands.events.key_down(Key::space);
  hands.events.key_down(Key::e);
  hands.events.take();  // the events of the menu
  hands.controls.discard();
  hands.frame();
  EXPECT_EQ(hands.tick(), button_grab) << "a player that hangs continues to hold";
  hands.frame();
  EXPECT_EQ(hands.tick(), button_grab);
  hands.events.key_up(Key::space);
  hands.frame();
  hands.events.key_down(Key::space);
  hands.frame();
  EXPECT_EQ(hands.tick(), button_grab | button_jump);
}

}  // namespace
}  // namespace game
