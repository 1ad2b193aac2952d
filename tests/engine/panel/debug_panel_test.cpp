#include "engine/panel/debug_panel.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <array>
#include <utility>

#include "engine/window/sdl_canvas.h"
#include "tests/support/pixels.h"

namespace {

using engine::DebugPanel;
using engine::HeadlessCanvas;
using engine::Key;
using engine::MouseButton;
using engine::WindowInput;

/// A window at (20, 20) with one button and a text field.
struct Shown {
  DebugPanel panel{HeadlessCanvas::default_font()};
  HeadlessCanvas canvas{320, 200};
  int clicks = 0;
  std::array<char, 32> text{};
  ribbon::Vec2 button{};  // px, its middle
  ribbon::Vec2 field{};

  void frame(const WindowInput& input, double scale = 1.0) {
    panel.begin(input, canvas.width(), canvas.height(), scale, 1.0 / 60.0);
    ImGui::SetNextWindowPos({20.0F, 20.0F});
    ImGui::SetNextWindowSize({200.0F, 120.0F});
    ImGui::Begin("panel");
    if (ImGui::Button("press")) ++clicks;
    button = middle();
    ImGui::InputText("##field", text.data(), text.size());
    field = middle();
    ImGui::End();
    panel.end();
  }

  static ribbon::Vec2 middle() {
    const ImVec2 a = ImGui::GetItemRectMin();
    const ImVec2 b = ImGui::GetItemRectMax();
    return {static_cast<double>(0.5F * (a.x + b.x)), static_cast<double>(0.5F * (a.y + b.y))};
  }

  void click(ribbon::Vec2 at) {
    WindowInput input;
    input.mouse = at;
    frame(input);
    input.buttons_held.set(0);
    input.buttons_pressed.set(0);
    frame(input);
    input.buttons_held.reset();
    input.buttons_pressed.reset();
    frame(input);
  }

  std::uint32_t pixel(int x, int y) const { return test_support::pixel(canvas.raster(), x, y); }
};

TEST(DebugPanel, DrawsOnlyItsWindow) {
  Shown shown;
  shown.canvas.clear({0, 200, 0});
  shown.panel.draw(shown.canvas);
  EXPECT_EQ(shown.pixel(100, 100), 0x00c800U) << "before the first frame";
  shown.frame({});
  shown.frame({});
  shown.panel.draw(shown.canvas);
  EXPECT_NE(shown.pixel(100, 130), 0x00c800U);
  for (const auto& [x, y] : {std::pair{5, 5}, {300, 100}, {100, 180}, {10, 100}}) {
    EXPECT_EQ(shown.pixel(x, y), 0x00c800U) << x << ", " << y;
  }
  int bright = 0;  // of letters
  for (int y = 22; y < 60; ++y) {
    for (int x = 22; x < 120; ++x) bright += (shown.pixel(x, y) & 0xffU) > 200;
  }
  EXPECT_GT(bright, 30);
}

TEST(DebugPanel, TheSameFrameIsTheSamePicture) {
  Shown a;
  Shown b;
  for (Shown* shown : {&a, &b}) {
    shown->frame({});
    shown->frame({});
    shown->panel.draw(shown->canvas);
  }
  EXPECT_EQ(a.canvas.raster().pixels(), b.canvas.raster().pixels());
}

TEST(DebugPanel, AClickPressesAButtonAndDoesNotReachTheGame) {
  Shown shown;
  shown.frame({});
  shown.click(shown.button);
  EXPECT_EQ(shown.clicks, 1);
  EXPECT_TRUE(shown.panel.wants_mouse());
  WindowInput input;
  input.buttons_held.set(0);
  input.keys_held.set(static_cast<std::size_t>(Key::a));
  const WindowInput left = without_captured(shown.panel, input);
  EXPECT_FALSE(left.held(MouseButton::left));
  EXPECT_TRUE(left.held(Key::a)) << "nothing is being typed";

  shown.click({300.0, 190.0});
  EXPECT_EQ(shown.clicks, 1);
  EXPECT_FALSE(shown.panel.wants_mouse());
  EXPECT_TRUE(without_captured(shown.panel, input).held(MouseButton::left));
}

TEST(DebugPanel, AClickBetweenTwoFramesCounts) {
  Shown shown;
  shown.frame({});
  WindowInput input;
  input.mouse = shown.button;
  shown.frame(input);
  input.buttons_pressed.set(0);  // pressed and released before the poll
  input.buttons_released.set(0);
  shown.frame(input);
  input.buttons_pressed.reset();
  shown.frame(input);
  EXPECT_EQ(shown.clicks, 1);
}

TEST(DebugPanel, TypedTextGoesToItsFieldAndNotToTheGame) {
  Shown shown;
  shown.frame({});
  shown.click(shown.field);
  WindowInput input;
  input.mouse = shown.field;
  input.text = "1.5µ";
  input.keys_held.set(static_cast<std::size_t>(Key::r));
  shown.frame(input);
  EXPECT_STREQ(shown.text.data(), "1.5µ");
  EXPECT_TRUE(shown.panel.wants_keyboard());
  EXPECT_FALSE(without_captured(shown.panel, input).held(Key::r));
  WindowInput back;
  back.mouse = shown.field;
  back.keys_held.set(static_cast<std::size_t>(Key::backspace));
  shown.frame(back);
  EXPECT_STREQ(shown.text.data(), "1.5");
}

TEST(DebugPanel, ScalesWithTheDesktopAndNeedsNoFont) {
  Shown shown;
  for (const double scale : {1.0, 2.0, 0.6, 2.0}) shown.frame({}, scale);
  shown.panel.draw(shown.canvas);
  DebugPanel without("/no/such/font.ttf");
  without.begin({}, 100, 100, 1.0, 0.01);
  without.end();
  HeadlessCanvas canvas(100, 100);
  without.draw(canvas);
}

}  // namespace
