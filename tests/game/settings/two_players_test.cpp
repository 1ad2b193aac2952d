// Two halves of a keyboard and two gamepads.

#include "game/settings/two_players.h"

#include <gtest/gtest.h>

#include "game/screens/help.h"
#include "game/settings/controls.h"
#include "game/settings/settings_file.h"
#include "game/simulation/buttons.h"

namespace game {
namespace {

using engine::InputState;
using engine::Key;
using engine::MouseButton;
using engine::PadButton;

/// Returns the buttons of a player in the next tick.
int buttons_of(int player, const engine::WindowInput& input, const Settings& settings = {}) {
  Controls controls;
  controls.take(input_of(player, input), bindings_of(player, settings), settings.toggle_grab, {}, false);
  return controls.next({}).buttons;
}

struct KeyCase {
  Key key;
  int first, second;
};

TEST(TwoHalves, EachKeyBelongsToOnePlayer) {
  for (const KeyCase& key : {KeyCase{Key::a, button_left, 0},
                             KeyCase{Key::d, button_right, 0},
                             KeyCase{Key::w, button_up, 0},
                             KeyCase{Key::s, button_down, 0},
                             KeyCase{Key::space, button_jump, 0},
                             KeyCase{Key::e, button_grab, 0},
                             KeyCase{Key::f, button_throw, 0},
                             KeyCase{Key::q, button_reel_in, 0},
                             KeyCase{Key::z, button_reel_out, 0},
                             KeyCase{Key::t, button_retry, 0},
                             KeyCase{Key::left_shift, button_grab, 0},
                             KeyCase{Key::left, 0, button_left},
                             KeyCase{Key::right, 0, button_right},
                             KeyCase{Key::up, 0, button_up},
                             KeyCase{Key::down, 0, button_down},
                             KeyCase{Key::enter, 0, button_jump},
                             KeyCase{Key::right_ctrl, 0, button_jump},
                             KeyCase{Key::right_shift, 0, button_grab},
                             KeyCase{Key::page_up, 0, button_reel_in},
                             KeyCase{Key::page_down, 0, button_reel_out},
                             KeyCase{Key::comma, 0, button_reel_in},
                             KeyCase{Key::period, 0, button_reel_out},
                             KeyCase{Key::slash, 0, button_throw},
                             KeyCase{Key::remove, 0, button_throw}}) {
    InputState events;
    events.key_down(key.key);
    const engine::WindowInput input = events.take();
    EXPECT_EQ(buttons_of(0, input), key.first) << static_cast<int>(key.key);
    EXPECT_EQ(buttons_of(1, input), key.second) << static_cast<int>(key.key);
  }
}

TEST(TwoHalves, BothPlayOnOneKeyboardAtOnce) {
  InputState events;
  for (const Key key : {Key::a, Key::space, Key::right, Key::right_shift}) events.key_down(key);
  const engine::WindowInput input = events.take();
  EXPECT_EQ(buttons_of(0, input), button_left | button_jump);
  EXPECT_EQ(buttons_of(1, input), button_right | button_grab);
}

TEST(TwoHalves, OnlyTheFirstPlayerHasTheMouse) {
  InputState events;
  events.button_down(MouseButton::left);
  const engine::WindowInput input = events.take();
  EXPECT_EQ(buttons_of(0, input), button_throw);
  EXPECT_EQ(buttons_of(1, input), 0);
}

TEST(TwoHalves, EachPlayerHasAGamepadOfItsOwn) {
  InputState events;
  events.pad_found();
  events.pad_found();
  events.stick_x(engine::PadStick::left, -1.0, 0);
  events.pad_down(PadButton::a, 1);
  events.pad_down(PadButton::x, 2);
  const engine::WindowInput input = events.take();
  EXPECT_EQ(buttons_of(0, input), button_left);
  EXPECT_EQ(buttons_of(1, input), button_jump);
  EXPECT_TRUE(input.held(PadButton::x)) << "in menus all gamepads count";
  EXPECT_TRUE(input.held(PadButton::a));
}

/// Each player's stick, and no mouse of the other one, moves its own aim.
TEST(TwoHalves, EachStickAimsForItsPlayer) {
  const Settings settings;
  Controls first;
  Controls second;
  engine::InputState events;
  events.pad_found();
  events.pad_found();
  const auto take = [&] {
    const engine::WindowInput input = events.take();
    first.take(input_of(0, input), bindings_of(0, settings), false, ribbon::Vec2{30.0, 3.0}, false);
    second.take(input_of(1, input), bindings_of(1, settings), false, std::nullopt, false);
  };
  const ribbon::Vec2 hand{5.0, 6.0};
  take();
  EXPECT_EQ(first.pointer(hand), (ribbon::Vec2{30.0, 3.0}));
  EXPECT_FALSE(second.pointer(hand));
  events.stick_x(engine::PadStick::right, -1.0, 1);
  take();
  EXPECT_EQ(first.pointer(hand), (ribbon::Vec2{30.0, 3.0}));
  ASSERT_TRUE(second.pointer(hand));
  EXPECT_NEAR(second.pointer(hand)->x, hand.x - Controls::pad_aim, 1e-6);
  events.mouse_at({100.0, 100.0});
  events.button_down(engine::MouseButton::left);
  take();
  EXPECT_TRUE(second.pointer(hand)) << "the mouse is the first player's";
  events.stick_y(engine::PadStick::right, 1.0, 0);
  take();
  EXPECT_GT(first.pointer(hand)->y, hand.y + 5.0);
  EXPECT_LT(second.pointer(hand)->x, hand.x - 5.0);
}

TEST(TwoHalves, AKeyThatTheSecondPlayerGetsIsTakenFromTheFirst) {
  Settings settings;
  settings.second_bindings.bind(Action::jump, Key::e);
  InputState events;
  events.key_down(Key::e);
  const engine::WindowInput input = events.take();
  EXPECT_EQ(buttons_of(0, input, settings), 0);
  EXPECT_EQ(buttons_of(1, input, settings), button_jump);
}

TEST(TwoHalves, AreStoredWithTheSettings) {
  Settings settings;
  settings.second_bindings.bind(Action::jump, Key::k);
  EXPECT_TRUE(parse_settings(settings_text(settings), "file") == settings);
  EXPECT_TRUE(parse_settings(R"({"bindings": {}})", "file").second_bindings == Bindings::second_defaults());
}

TEST(TwoHalves, HintsAndHelpNameTheKeysOfBoth) {
  EXPECT_EQ(hint_in_words("{left} {jump}, {left_2} {jump_2} {grab_2}", {}, false), "A Space, ← Enter Right Shift");
  EXPECT_EQ(hint_in_words("{left} {jump}", {}, false), "← Space") << "as ever in a level for one";
  EXPECT_EQ(hint_in_words("{jump} {jump_2}", {}, true), "A A");
  std::string help;
  for (const std::string& line : help_lines_for_two({}, false)) help += line + "\n";
  EXPECT_NE(help.find("A | ←: Run or swing left"), std::string::npos) << help;
  EXPECT_NE(help.find("Space | Enter: Jump, let go"), std::string::npos) << help;
}

}  // namespace
}  // namespace game
