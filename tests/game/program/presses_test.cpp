#include <gtest/gtest.h>

#include <initializer_list>

#include "game/program/app.h"
#include "game/screens/play_screen.h"
#include "tests/game/program/journey.h"
#include "tests/support/sdl_events.h"

// Presses and clicks in the frame in which they come.

namespace game {
namespace {

using engine::MouseButton;

TEST_F(Journey, APressCountsInTheTickAfterTheEvent) {
  RunOptions options;
  options.level = "first_swing";
  open(options);
  for (int k = 0; k < 30; ++k) frame();  // the player stands
  ASSERT_TRUE(play().simulation().player().is_on_ground());
  const double before = play().simulation().player().position().y;
  test_support::push_key(Key::space, true);
  test_support::push_key(Key::space, false);
  const int ticks = play().simulation().ticks();
  frame();
  EXPECT_EQ(play().simulation().ticks(), ticks + 1);
  EXPECT_GT(play().simulation().player().position().y, before + 0.05);
}

TEST_F(Journey, TheMouseWorksMenusToo) {
  open();
  app->draw();
  const engine::Canvas& canvas = app->window().canvas();
  // A column through the title's card crosses each of its lines.
  for (double y = 0.0; y < canvas.height() && screen() == "title"; y += 8.0) {
    const ribbon::Vec2 at{200.0, y};
    test_support::push_button(MouseButton::left, true, at);
    test_support::push_button(MouseButton::left, false, at);
    ASSERT_TRUE(frame());
  }
  EXPECT_EQ(screen(), "levels");
  test_support::push_button(MouseButton::right, true, {5.0, 5.0});
  test_support::push_button(MouseButton::right, false, {5.0, 5.0});
  frame();
  EXPECT_EQ(screen(), "title");
}

TEST_F(Journey, EveryPressOfAFrameCountsInOrder) {
  open();
  const auto press = [](std::initializer_list<Key> pressed) {
    for (const Key key : pressed) {
      test_support::push_key(key, true);
      test_support::push_key(key, false);
    }
  };
  press({Key::down, Key::down, Key::enter});
  frame();
  EXPECT_EQ(screen(), "options") << "the third line of the title";
  press({Key::up, Key::enter});
  frame();
  EXPECT_EQ(screen(), "title") << "the last line of the options";
  press({Key::enter, Key::down, Key::down, Key::left});
  frame();
  EXPECT_EQ(screen(), "options");
  EXPECT_EQ(app->session().settings.speed, 90) << "two lines down on the screen that the first presses opened";
  press({Key::up, Key::up, Key::enter, Key::escape, Key::escape, Key::down, Key::enter});
  EXPECT_FALSE(frame()) << "to the keys, back to the options and title, and down to the last line";
}

TEST_F(Journey, TwoClicksInAFrameAreAtTheirOwnPlaces) {
  open();
  app->draw();
  const engine::Canvas& canvas = app->window().canvas();
  for (double y = 0.0; y < canvas.height() && screen() == "title"; y += 4.0) {
    test_support::push_button(MouseButton::left, true, {200.0, y});
    test_support::push_button(MouseButton::left, false, {200.0, y});
    test_support::push_button(MouseButton::right, true, {900.0, 5.0});
    test_support::push_button(MouseButton::right, false, {900.0, 5.0});
    test_support::push_mouse({1000.0, 500.0});
    ASSERT_TRUE(frame());
    ASSERT_EQ(screen(), "title") << "the second click goes back from what the first one opened";
    test_support::push_button(MouseButton::left, true, {200.0, y});
    test_support::push_mouse({1000.0, 500.0});
    frame();
    test_support::push_button(MouseButton::left, false, {1000.0, 500.0});
    frame();
  }
  EXPECT_EQ(screen(), "levels") << "the mouse has left the line in the same frame";
}

}  // namespace
}  // namespace game
