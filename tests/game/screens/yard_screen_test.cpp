// Building in a sandbox by keys, mouse and gamepad.

#include "game/screens/yard_screen.h"

#include <gtest/gtest.h>

#include <string>

#include "engine/window/sdl_canvas.h"
#include "game/screens/pause_screen.h"
#include "game/screens/play_screen.h"
#include "game/view/hud.h"
#include "tests/game/program.h"
#include "tests/game/screens/text_canvas.h"

namespace game {
namespace {

using engine::Key;
using engine::MouseButton;
using engine::PadButton;
using ribbon::Vec2;

/// A sandbox in which building has begun.
class Building : public testing::TestWithParam<CanvasSize> {
 protected:
  Building() : canvas(GetParam().width, GetParam().height), scale(text_scale_of(canvas, 1.0)) {
    options.level = "sandbox";
    play.emplace(session, options, false);
    play->shown();
    update(*play);
    play->draw(canvas, scale);
    yard.emplace(session, *play);
    yard->shown();
    draw();
  }

  void draw() {
    canvas.forget();
    play->draw_below(canvas, scale);
    yard->draw(canvas, scale);
    const std::string& notice = session.notice.text();
    if (!notice.empty()) draw_notice(canvas, notice, scale);
  }
  /// One frame with the events since the last one.
  Next::What update(Screen& screen) {
    const engine::WindowInput input = events.take();
    const MenuInput menu = reader.read(input, frame_ns);
    return screen.update({input, menu, canvas, frame_ns, scale}).what;
  }
  Next::What update() { return update(*yard); }
  Next::What tap(Key key) {
    events.key_down(key);
    const Next::What what = update();
    events.key_up(key);
    update();
    return what;
  }
  Next::What tap(PadButton button) {
    events.pad_down(button);
    const Next::What what = update();
    events.pad_up(button);
    update();
    return what;
  }
  void click(Vec2 pixels) {
    events.mouse_at(pixels);
    events.button_down(MouseButton::left);
    update();
    events.button_up(MouseButton::left);
    update();
  }
  void click_at(Vec2 world) { click(canvas.to_pixels(world)); }
  /// Clicks the line of the palette with this text.
  void choose(const std::string& text) {
    draw();
    click(canvas.place_of(text).corner + Vec2{3.0, 3.0});
  }
  const std::vector<PlacedThing>& things() const { return play->simulation().level().yard.things; }
  bool shows(const std::string& text) {
    draw();
    return canvas.all().find(text) != std::string::npos;
  }

  TextCanvas canvas;
  double scale;
  Session session{"", ""};
  RunOptions options;
  engine::InputState events;
  MenuReader reader;
  std::optional<PlayScreen> play;
  std::optional<YardScreen> yard;
};

INSTANTIATE_TEST_SUITE_P(Sizes, Building,
                         testing::Values(CanvasSize{640, 360}, CanvasSize{1280, 720}, CanvasSize{2560, 1440}),
                         size_name);

TEST_P(Building, ByMousePlacesMovesAndRemoves) {
  choose(words::yard_crate);
  click_at({5.0, 8.0});
  ASSERT_EQ(things().size(), 1U);
  EXPECT_EQ(things()[0].thing, Thing::crate);
  EXPECT_NEAR(things()[0].first.x, 5.0, 0.03);
  choose(words::yard_rope);
  click_at({6.0, 10.0});
  EXPECT_EQ(things().size(), 1U) << "one end";
  click_at({9.0, 10.0});
  ASSERT_EQ(things().size(), 2U);
  EXPECT_NEAR(things()[1].second.x, 9.0, 0.03);
  choose(words::yard_move);
  click_at({7.0, 10.0});
  click_at({7.0, 8.0});
  EXPECT_NEAR(things()[1].first.y, 8.0, 0.06);
  choose(words::yard_remove);
  click_at({5.0, 8.0});
  ASSERT_EQ(things().size(), 1U);
  EXPECT_EQ(things()[0].thing, Thing::rope);
  choose(words::yard_clear);
  EXPECT_TRUE(things().empty());
}

/// A way with the button down places the second end where it goes up.
TEST_P(Building, ByDraggingFromEndToEnd) {
  choose(words::yard_trampoline);
  events.mouse_at(canvas.to_pixels({5.0, 8.0}));
  events.button_down(MouseButton::left);
  update();
  events.mouse_at(canvas.to_pixels({8.5, 8.0}));
  update();
  EXPECT_TRUE(things().empty());
  events.button_up(MouseButton::left);
  update();
  ASSERT_EQ(things().size(), 1U);
  EXPECT_NEAR(length(things()[0].second - things()[0].first), 3.5, 0.06);
}

TEST_P(Building, ByKeysAlone) {
  for (int k = 0; k < 5; ++k) tap(Key::tab);
  EXPECT_EQ(yard->tool().thing(), Thing::ball);
  const Vec2 before = yard->pointer();
  events.key_down(Key::up);
  for (int k = 0; k < 30; ++k) update();
  events.key_up(Key::up);
  update();
  EXPECT_NEAR(yard->pointer().y - before.y, 0.5 * YardScreen::pointer_speed, 0.3);
  tap(Key::enter);
  ASSERT_EQ(things().size(), 1U);
  EXPECT_EQ(tap(Key::escape), Next::What::back);
}

TEST_P(Building, ByGamepadAlone) {
  events.pad_found();
  tap(PadButton::left_shoulder);  // to the last line: done
  for (int k = 0; k < 5; ++k) tap(PadButton::right_shoulder);
  EXPECT_EQ(yard->tool().thing(), Thing::crate);
  events.stick_y(engine::PadStick::left, 1.0);
  for (int k = 0; k < 30; ++k) update();
  events.stick_y(engine::PadStick::left, 0.0);
  tap(PadButton::a);
  ASSERT_EQ(things().size(), 1U);
  for (int k = 0; k < 3; ++k) tap(PadButton::right_shoulder);
  EXPECT_EQ(yard->tool().kind(), YardTool::Kind::move);
  tap(PadButton::a);
  EXPECT_TRUE(yard->tool().begun());
  EXPECT_EQ(tap(PadButton::b), Next::What::stay) << "puts it back";
  EXPECT_FALSE(yard->tool().begun());
  tap(PadButton::right_shoulder);
  tap(PadButton::a);
  EXPECT_TRUE(things().empty());
  EXPECT_EQ(tap(PadButton::b), Next::What::back);
}

TEST_P(Building, TellsWhatIsNotPossible) {
  choose(words::yard_ball);
  for (std::size_t k = 0; k < Yard::max_things; ++k) {
    const std::size_t row = k / 8;
    click_at({4.0 + 1.1 * static_cast<double>(k % 8), 8.0 + 1.2 * static_cast<double>(row)});
  }
  ASSERT_EQ(things().size(), Yard::max_things);
  EXPECT_TRUE(shows("24 of 24 things"));
  click_at({6.0, 6.0});
  EXPECT_EQ(things().size(), Yard::max_things);
  EXPECT_TRUE(shows("24 things at most: remove one"));
  EXPECT_EQ(canvas.faults({"Everything can be dragged"}, true), "");
  choose(words::yard_clear);
  choose(words::yard_rope);
  click_at({6.0, 8.0});
  click_at({6.5, 8.0});
  EXPECT_TRUE(shows("At least 1 m from end to end"));
  choose(words::yard_ball);
  click_at({6.0, 2.0});
  EXPECT_TRUE(shows("Something is in the way"));
  choose(words::yard_rope);
  click_at({6.0, 2.0});
  EXPECT_TRUE(yard->tool().begun()) << "a rope may begin in the ground";
}

/// Of all tools and messages, with a notice and without.
TEST_P(Building, TextsAreReadable) {
  for (const bool pad : {false, true}) {
    session.uses_pad = pad;
    for (const char* notice : {"", "Screenshot: /home/a_player/Pictures/ropeswing-12.png"}) {
      session.notice.show(notice);
      for (int k = 0; k < 11; ++k) {
        draw();
        EXPECT_EQ(canvas.faults({"Everything can be dragged"}, true), "") << k << notice;
        tap(Key::tab);
      }
      session.notice.show("");
    }
  }
}

/// The run then begins with the things, from where the player was, and goes back to the level's start by a restart.
TEST_P(Building, TheRunHasTheThings) {
  const Vec2 start = play->simulation().level().player_start;
  choose(words::yard_peg);
  click_at({6.0, 8.0});
  EXPECT_EQ(play->simulation().ticks(), 0) << "it stands still";
  yard->leave();
  for (int k = 0; k < 90; ++k) {
    if (k == 0) events.key_down(Key::right);
    update(*play);
  }
  events.key_up(Key::right);
  EXPECT_GT(play->simulation().ticks(), 80);
  ASSERT_EQ(things().size(), 1U);
  const double x = play->simulation().player().position().x;
  EXPECT_GT(x, start.x + 4.0);
  play->draw(canvas, scale);
  yard->shown();
  EXPECT_EQ(play->simulation().ticks(), 0);
  EXPECT_NEAR(play->simulation().player().position().x, x, 0.01);
  yard->leave();
  play->restart();
  EXPECT_EQ(play->simulation().player().position().x, start.x);
  EXPECT_EQ(things().size(), 1U);
}

TEST(BuildingElsewhere, IsNotOffered) {
  Session session{"", ""};
  RunOptions options;
  options.level = "first_swing";
  EXPECT_FALSE(PlayScreen(session, options, false).played().can_build());
  options.level = "sandbox";
  EXPECT_TRUE(PlayScreen(session, options, false).played().can_build());
  options.ticks = 100;
  EXPECT_FALSE(PlayScreen(session, options, false).played().can_build());
  RunOptions replay;
  replay.replay = std::string(TEST_ASSETS "/replays/sandbox.replay");
  EXPECT_FALSE(PlayScreen(session, replay, false).played().can_build());
}

/// A gamepad has no button for the palette: it is in the menu of a pause, which then goes on with the run.
TEST(BuildingElsewhere, IsInTheMenuOfAPause) {
  Session session{"", ""};
  RunOptions options;
  options.level = "sandbox";
  PlayScreen play(session, options, false);
  play.shown();
  TextCanvas canvas(1280, 720);
  PauseScreen pause(session, play);
  const engine::WindowInput none;
  const MenuInput down{.down = 1};
  const MenuInput accept{.accept = true};
  const MenuInput nothing{};
  pause.update({none, down, canvas, frame_ns, 1.0});
  Next next = pause.update({none, accept, canvas, frame_ns, 1.0});
  ASSERT_EQ(next.what, Next::What::open);
  EXPECT_EQ(next.screens.front()->title(), words::screen_yard);
  EXPECT_EQ(pause.update({none, nothing, canvas, frame_ns, 1.0}).what, Next::What::back);
}

}  // namespace
}  // namespace game
