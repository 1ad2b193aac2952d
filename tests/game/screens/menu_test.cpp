// Menus as state machines, without a window.

#include "game/screens/menu.h"

#include <gtest/gtest.h>

#include "engine/window/sdl_canvas.h"
#include "game/screens/card.h"
#include "game/screens/rebinding.h"
#include "game/screens/screen.h"
#include "tests/game/screens/text_canvas.h"

namespace game {
namespace {

using engine::InputState;
using engine::Key;
using engine::MouseButton;
using engine::PadButton;

constexpr MenuPlace rows_place{{100.0, 50.0}, 400.0, 1000.0, 20.0};  // rows of 35 px

Menu menu_of(int lines) {
  std::vector<MenuItem> items;
  for (int k = 0; k < lines; ++k) items.push_back({std::to_string(k)});
  Menu menu;
  menu.set_items(items);
  return menu;
}

TEST(Menu, TheFocusWrapsAround) {
  Menu menu = menu_of(3);
  EXPECT_EQ(menu.update({.down = -1}, rows_place), std::nullopt);
  EXPECT_EQ(menu.focus(), 2);
  menu.update({.down = 1}, rows_place);
  EXPECT_EQ(menu.focus(), 0);
  menu.update({.down = 5}, rows_place);
  EXPECT_EQ(menu.focus(), 2);
  Menu empty;
  EXPECT_EQ(empty.update({.down = 1, .accept = true}, rows_place), std::nullopt);
}

TEST(Menu, ChoosesALineAndChangesAValue) {
  Menu menu;
  menu.set_items({{"Play"}, {"Volume", "70 %", true}});
  EXPECT_EQ(menu.update({.right = 1}, rows_place), std::nullopt) << "nothing to change";
  EXPECT_EQ(menu.update({.accept = true}, rows_place), (MenuChoice{0, 0}));
  EXPECT_EQ(menu.update({.down = 1, .right = -1}, rows_place), (MenuChoice{1, -1}));
  EXPECT_EQ(menu.update({.right = 1}, rows_place), (MenuChoice{1, 1}));
  EXPECT_EQ(menu.update({.accept = true}, rows_place), (MenuChoice{1, 1}));
}

TEST(Menu, TheMouseFocusesWhereItMovesAndClicksWhereItIs) {
  Menu menu;
  menu.set_items({{"Play"}, {"Volume", "70 %", true}, {"Back"}});
  menu.update({.mouse_moved = true, .mouse = {110.0, 50.0 + 2.5 * 35.0}}, rows_place);
  EXPECT_EQ(menu.focus(), 2);
  menu.update({.down = -1, .mouse = {110.0, 50.0 + 2.5 * 35.0}}, rows_place);
  EXPECT_EQ(menu.focus(), 1) << "a mouse at rest does not hold the focus";
  EXPECT_EQ(menu.update({.clicked = true, .mouse = {110.0, 51.0}}, rows_place), (MenuChoice{0, 0}));
  EXPECT_EQ(menu.update({.clicked = true, .mouse = {490.0, 90.0}}, rows_place), (MenuChoice{1, 1}));
  EXPECT_EQ(menu.update({.clicked = true, .mouse = {330.0, 90.0}}, rows_place), (MenuChoice{1, -1}))
      << "the left arrow";
  EXPECT_EQ(menu.update({.clicked = true, .mouse = {90.0, 51.0}}, rows_place), std::nullopt) << "beside it";
  EXPECT_EQ(menu.update({.clicked = true, .mouse = {110.0, 50.0 + 3.1 * 35.0}}, rows_place), std::nullopt) << "below";
}

TEST(Menu, ALongMenuScrollsToItsFocus) {
  constexpr MenuPlace low{{0.0, 0.0}, 400.0, 4.5 * 35.0, 20.0};
  Menu menu = menu_of(10);
  for (int k = 0; k < 6; ++k) menu.update({.down = 1}, low);
  EXPECT_EQ(menu.update({.clicked = true, .mouse = {10.0, 10.0}}, low), (MenuChoice{3, 0})) << "6 is the last of four";
  menu.update({.down = -4}, low);
  EXPECT_EQ(menu.focus(), 9);
  EXPECT_EQ(menu.update({.clicked = true, .mouse = {10.0, 10.0}}, low), (MenuChoice{6, 0}));
}

TEST(Menu, ShorterListsKeepTheFocusInside) {
  Menu menu = menu_of(5);
  menu.set_focus(4);
  menu.set_items({{"one"}, {"two"}});
  EXPECT_EQ(menu.focus(), 1);
  menu.set_items({});
  EXPECT_EQ(menu.focus(), 0);
}

TEST(MenuReader, KeyboardAndGamepadDoTheSame) {
  const auto read = [](auto press) {
    InputState events;
    press(events);
    return MenuReader().read(events.take(), frame_ns);
  };
  EXPECT_EQ(read([](InputState& events) { events.key_down(Key::down); }).down, 1);
  EXPECT_EQ(read([](InputState& events) { events.pad_down(PadButton::dpad_up); }).down, -1);
  EXPECT_EQ(read([](InputState& events) { events.stick_x(engine::PadStick::left, 1.0); }).right, 1);
  EXPECT_EQ(read([](InputState& events) { events.wheel({0.0, -1.0}); }).down, 1);
  EXPECT_TRUE(read([](InputState& events) { events.pad_down(PadButton::a); }).accept);
  EXPECT_TRUE(read([](InputState& events) { events.key_down(Key::enter); }).accept);
  EXPECT_TRUE(read([](InputState& events) { events.pad_down(PadButton::b); }).back);
  EXPECT_TRUE(read([](InputState& events) { events.key_down(Key::escape); }).back);
  EXPECT_TRUE(read([](InputState& events) { events.button_down(MouseButton::left); }).clicked);
}

TEST(MenuReader, AHeldDirectionIsRepeatedAfterAWhile) {
  InputState events;
  MenuReader reader;
  events.key_down(Key::down);
  EXPECT_EQ(reader.read(events.take(), frame_ns).down, 1);
  int steps = 0;
  for (int k = 0; k < 23; ++k) steps += reader.read(events.take(), frame_ns).down;
  EXPECT_EQ(steps, 0) << "not within 0.38 s";
  for (int k = 0; k < 30; ++k) steps += reader.read(events.take(), frame_ns).down;
  EXPECT_EQ(steps, 5);
  events.key_up(Key::down);
  for (int k = 0; k < 30; ++k) EXPECT_EQ(reader.read(events.take(), frame_ns).down, 0);
}

bool press(Rebinding& rebinding, Bindings& bindings, const auto& code) {
  engine::WindowInput input;
  if constexpr (std::is_same_v<std::decay_t<decltype(code)>, Key>)
    input.keys_pressed.set(static_cast<std::size_t>(code));
  else
    input.pad_pressed.set(static_cast<std::size_t>(code));
  return rebinding.take(input, bindings);
}

TEST(Rebinding, AFreeKeyIsBoundAtOnce) {
  Bindings bindings = Bindings::defaults();
  Rebinding rebinding(Action::jump);
  EXPECT_FALSE(rebinding.take({}, bindings)) << "it waits";
  EXPECT_TRUE(press(rebinding, bindings, Key::j));
  EXPECT_EQ(bindings.action_of(Key::j), Action::jump);
}

TEST(Rebinding, AKeyOfAnotherActionMustBePressedTwice) {
  Bindings bindings = Bindings::defaults();
  Rebinding rebinding(Action::jump);
  EXPECT_FALSE(press(rebinding, bindings, Key::q));
  EXPECT_EQ(bindings.action_of(Key::q), Action::reel_in);
  EXPECT_NE(rebinding.prompt(bindings).find("Reel in"), std::string::npos) << rebinding.prompt(bindings);
  EXPECT_FALSE(press(rebinding, bindings, Key::z)) << "another one: it must be confirmed again";
  EXPECT_TRUE(press(rebinding, bindings, Key::z));
  EXPECT_EQ(bindings.action_of(Key::z), Action::jump);
  EXPECT_EQ(bindings.action_of(Key::q), Action::reel_in);
}

TEST(Rebinding, ItsOwnKeyIsRemovedAndEscapeChangesNothing) {
  Bindings bindings = Bindings::defaults();
  Rebinding away(Action::jump);
  EXPECT_TRUE(press(away, bindings, PadButton::a));
  EXPECT_EQ(bindings.action_of(PadButton::a), std::nullopt);
  const Bindings before = bindings;
  Rebinding none(Action::jump);
  EXPECT_TRUE(press(none, bindings, Key::escape));
  EXPECT_TRUE(bindings == before);
}

/// A screen that records its events and returns a given request.
struct FakeScreen : Screen {
  FakeScreen(std::string& said, char called, bool is_over = false) : log(&said), name(called), over(is_over) {}
  void shown() override { (*log += name) += "+ "; }
  Next update(const Frame&) override { return std::move(next); }
  void draw(engine::Canvas&, double) override { (*log += name) += "d "; }
  void draw_below(engine::Canvas&, double) override { (*log += name) += "b "; }
  bool is_overlay() const override { return over; }
  void leave() override { (*log += name) += "- "; }
  std::string title() const override { return {name}; }
  std::string* log;
  char name;
  bool over;
  Next next = Next::stay();
};

TEST(ScreenStack, OpensClosesAndReplacesScreens) {
  std::string log;
  engine::HeadlessCanvas canvas(64, 64);
  const engine::WindowInput input;
  const Frame frame{input, {}, canvas, frame_ns, 1.0};
  ScreenStack stack;
  auto first = std::make_unique<FakeScreen>(log, 'a');
  FakeScreen& a = *first;
  stack.open(std::move(first));
  auto second = std::make_unique<FakeScreen>(log, 'b', true);
  FakeScreen& b = *second;
  a.next = Next::open(std::move(second));
  EXPECT_TRUE(stack.update(frame));
  stack.draw(canvas, 1.0);
  EXPECT_EQ(log, "a+ b+ ab bd ");
  EXPECT_EQ(stack.top().title(), "b");
  b.next = Next::open(std::make_unique<FakeScreen>(log, 'c', true));
  log.clear();
  EXPECT_TRUE(stack.update(frame));
  stack.draw(canvas, 1.0);
  EXPECT_EQ(log, "c+ ab cd ") << "of overlays only the top one is drawn";
  std::vector<std::unique_ptr<Screen>> others;
  others.push_back(std::make_unique<FakeScreen>(log, 'd'));
  others.push_back(std::make_unique<FakeScreen>(log, 'e'));
  ScreenStack other;
  auto last = std::make_unique<FakeScreen>(log, 'f');
  FakeScreen& f = *last;
  other.open(std::move(last));
  f.next = Next::replace_all(std::move(others));
  log.clear();
  EXPECT_TRUE(other.update(frame));
  EXPECT_EQ(log, "f- e+ ");
  other.leave();
  EXPECT_EQ(log, "f- e+ e- d- ");
}

TEST(ScreenStack, LeavingTheLastScreenEndsTheGame) {
  std::string log;
  engine::HeadlessCanvas canvas(64, 64);
  const engine::WindowInput input;
  ScreenStack stack;
  auto only = std::make_unique<FakeScreen>(log, 'a');
  only->next = Next::back();
  stack.open(std::move(only));
  EXPECT_FALSE(stack.update({input, {}, canvas, frame_ns, 1.0}));
  EXPECT_EQ(log, "a+ a- ");
}

TEST(Card, ItsMenuIsInsideThePictureAtAnySize) {
  for (const auto& [width, height, scale] : {std::tuple{1280, 720, 1.0}, std::tuple{800, 450, 0.625},
                                             std::tuple{2560, 1440, 1.5}, std::tuple{640, 360, 0.5}}) {
    const engine::HeadlessCanvas canvas(width, height);
    for (const int rows : {1, 5, 13, 40}) {
      const Card card{.headline = "Options", .lines = {"a line"}, .width = 660.0};
      const MenuPlace menu = menu_place(canvas, scale, card, rows);
      EXPECT_GE(menu.rows(), std::min(rows, 5));
      EXPECT_LE(menu.rows(), rows);
      EXPECT_GE(menu.top_left.y, 0.0);
      EXPECT_LE(menu.top_left.y + menu.rows() * menu.row_height(), height) << rows;
      EXPECT_GE(menu.top_left.x, 0.0);
      EXPECT_LE(menu.top_left.x + menu.width, width);
    }
  }
}

}  // namespace
}  // namespace game
