#include "engine/window/sdl_window.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/window/window_input.h"
#include "tests/support/environment.h"
#include "tests/support/files.h"
#include "tests/support/pixels.h"
#include "tests/support/refusal.h"

using engine::Align;
using engine::Color;
using engine::fitting_size;
using engine::HeadlessCanvas;
using engine::InputState;
using engine::Key;
using engine::MouseButton;
using engine::PadButton;
using engine::single_presses;
using engine::WheelTurn;
using engine::Window;
using engine::WindowInput;
using engine::WindowSize;
using ribbon::Vec2;
using test_support::bytes_of;
using test_support::Environment;
using test_support::pixel;
using test_support::refusal;
using test_support::says;
using test_support::starts_with;

namespace {

namespace fs = std::filesystem;

/// A directory that is removed after the test.
struct TemporaryDirectory {
  fs::path path = fs::temp_directory_path() / ("canvas_test_" + std::to_string(engine::now_ns()));
  TemporaryDirectory() { fs::create_directory(path); }
  ~TemporaryDirectory() { fs::remove_all(path); }
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;
};

void draw_scene(engine::Canvas& canvas) {
  canvas.clear({10, 20, 40}, {90, 120, 150});
  canvas.set_view({{1.0, 1.0}, 20.0});
  canvas.polyline(std::vector<Vec2>{{-1.0, 0.0}, {1.0, 2.0}, {3.0, 0.5}}, 0.2, {200, 100, 50, 128});
  canvas.circle({1.0, 1.0}, 0.7, {255, 255, 255});
  canvas.text({80.0, 4.0}, "Ärger 12.5 m/s", 14.0, {255, 255, 0}, Align::center);
}

std::string message_of_saving_to(const std::string& path) {
  return refusal<std::runtime_error>([&] { HeadlessCanvas(10, 10).save_png(path); });
}

}  // namespace

TEST(HeadlessCanvas, IsBlackAtFirst) {
  const HeadlessCanvas canvas(7, 5);
  EXPECT_EQ(canvas.width(), 7);
  EXPECT_EQ(canvas.height(), 5);
  EXPECT_EQ(canvas.raster().pixels(), std::vector<std::uint32_t>(35, 0U));
}

TEST(HeadlessCanvas, RefusesImpossibleSizes) {
  for (const auto& [width, height] : {std::array{0, 10}, std::array{10, -1}, std::array{16385, 10}})
    EXPECT_THROW(HeadlessCanvas(width, height), std::invalid_argument);
  HeadlessCanvas canvas(8, 8);
  EXPECT_THROW(canvas.resize(8, 0), std::invalid_argument);
  EXPECT_EQ(canvas.height(), 8);
}

TEST(HeadlessCanvas, ClearsToAGradientFromTopToBottom) {
  HeadlessCanvas canvas(4, 101);
  canvas.clear({0, 0, 0}, {200, 100, 50});
  EXPECT_EQ(pixel(canvas.raster(), 0, 0), 0x000000U);
  EXPECT_EQ(pixel(canvas.raster(), 3, 50), 0x643219U);
  EXPECT_EQ(pixel(canvas.raster(), 2, 100), 0xc86432U);
}

TEST(HeadlessCanvas, DrawsTheWorldUpwards) {
  HeadlessCanvas canvas(100, 60);
  canvas.set_view({{10.0, 5.0}, 10.0});
  canvas.polygon(std::vector<Vec2>{{11.0, 6.0}, {13.0, 6.0}, {13.0, 7.0}, {11.0, 7.0}}, {1, 2, 3});
  EXPECT_EQ(pixel(canvas.raster(), 60, 15), 0x010203U);  // x 60 … 80 and y 10 … 20 from the top
  EXPECT_EQ(pixel(canvas.raster(), 79, 19), 0x010203U);
  EXPECT_EQ(pixel(canvas.raster(), 58, 15), 0U);
  EXPECT_EQ(pixel(canvas.raster(), 70, 21), 0U);
  EXPECT_EQ(pixel(canvas.raster(), 70, 45), 0U);
}

TEST(HeadlessCanvas, BlendsATranslucentColour) {
  HeadlessCanvas canvas(20, 20);
  canvas.clear({100, 100, 100});
  canvas.panel({2.0, 2.0}, {16.0, 16.0}, 0.0, {200, 100, 0, 128});
  const std::uint32_t mixed = pixel(canvas.raster(), 10, 10);
  EXPECT_NEAR(mixed >> 16U, 150.0, 1.0);
  EXPECT_EQ((mixed >> 8U) & 0xffU, 100U);
  EXPECT_NEAR(mixed & 0xffU, 50.0, 1.0);
}

TEST(HeadlessCanvas, WritesTextInItsPlaceAndColour) {
  HeadlessCanvas canvas(200, 40);
  canvas.text({100.0, 5.0}, "Hello", 20.0, {255, 0, 0}, Align::center);
  const double width = canvas.text_width("Hello", 20.0);
  EXPECT_GT(width, 40.0);
  EXPECT_LT(width, 60.0);
  EXPECT_GE(canvas.line_height(20.0), 20.0);
  int inside = 0;
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 200; ++x) {
      const std::uint32_t color = pixel(canvas.raster(), x, y);
      EXPECT_EQ(color & 0xffffU, 0U);
      if (std::abs(x + 0.5 - 100.0) > width / 2.0 + 1.0 || y < 5) {
        EXPECT_EQ(color, 0U) << x << ", " << y;
      }
      inside += color == 0xff0000U;
    }
  EXPECT_GT(inside, 40);
}

TEST(HeadlessCanvas, TextOutsideOrUnusualIsHarmless) {
  HeadlessCanvas canvas(30, 30);
  for (const double at : {-1e9, -20.0, 25.0, 1e9}) canvas.text({at, at}, "Hello", 18.0, {255, 255, 255});
  canvas.text({5.0, 5.0}, "\xff\xfe broken \x01", 18.0, {255, 255, 255});
  canvas.text({5.0, 5.0}, "x", 1e9, {255, 255, 255});
  EXPECT_EQ(canvas.text_width("", 18.0), 0.0);
}

TEST(HeadlessCanvas, ManyDifferentTextsAndSizesAreDrawnCorrectly) {
  HeadlessCanvas canvas(200, 40);
  const double width = canvas.text_width("steady", 18.0);
  for (int i = 0; i < 1000; ++i) canvas.text({0.0, 0.0}, std::to_string(i), 6.0 + i % 40, {255, 255, 255});
  EXPECT_EQ(canvas.text_width("steady", 18.0), width);
}

TEST(HeadlessCanvas, WritesTheSamePictureTwice) {
  const TemporaryDirectory directory;
  std::vector<std::string> files;
  for (const char* const name : {"a.png", "b.png"}) {
    HeadlessCanvas canvas(160, 90);
    draw_scene(canvas);
    canvas.save_png((directory.path / name).string());
    files.push_back(bytes_of(directory.path / name));
  }
  EXPECT_EQ(files[0], files[1]);
  ASSERT_GT(files[0].size(), 33U);
  EXPECT_EQ(files[0].substr(0, 8), "\x89PNG\r\n\x1a\n");
  // The header: width and height, big-endian, after the chunk's length and name.
  EXPECT_EQ(files[0].substr(16, 8), std::string("\0\0\0\xa0\0\0\0\x5a", 8));
}

TEST(HeadlessCanvas, AFileThatCannotBeWrittenIsNamed) {
  const std::string missing = "/nonexistent/shot.png";
  EXPECT_EQ(message_of_saving_to(missing), "cannot write the picture /nonexistent/shot.png: No such file or directory");
  const std::string directory = fs::temp_directory_path().string();
  EXPECT_NE(message_of_saving_to(directory).find(directory), std::string::npos);
  if (fs::exists("/dev/full")) {
    EXPECT_NE(message_of_saving_to("/dev/full").find("/dev/full"), std::string::npos);
  }
}

TEST(HeadlessCanvas, AnInvalidFontIsNamed) {
  for (const char* const font : {"/nonexistent/letters.ttf", "/dev/null", "/"}) {
    const std::string message = refusal<std::runtime_error>([&] { const HeadlessCanvas canvas(10, 10, font); });
    EXPECT_TRUE(starts_with(message, std::string("cannot open the font ") + font + ": "));
    EXPECT_TRUE(says(message, "fonts-dejavu-core"));
  }
}

TEST(InputState, KeyIsHeldBetweenPressAndRelease) {
  InputState state;
  state.key_down(Key::a);
  const WindowInput first = state.take();
  EXPECT_TRUE(first.held(Key::a) && first.pressed(Key::a) && !first.released(Key::a));
  const WindowInput second = state.take();
  EXPECT_TRUE(second.held(Key::a) && !second.pressed(Key::a) && !second.released(Key::a));
  state.key_up(Key::a);
  const WindowInput third = state.take();
  EXPECT_TRUE(!third.held(Key::a) && !third.pressed(Key::a) && third.released(Key::a));
  EXPECT_FALSE(state.take().released(Key::a));
}

TEST(InputState, TapBetweenTwoPollsIsSeen) {
  InputState state;
  state.key_down(Key::f12);
  state.key_up(Key::f12);
  const WindowInput input = state.take();
  EXPECT_TRUE(input.pressed(Key::f12) && input.released(Key::f12) && !input.held(Key::f12));
}

TEST(InputState, AutoRepeatIsNotAnotherPress) {
  InputState state;
  state.key_down(Key::space);
  state.take();
  state.key_down(Key::space);
  EXPECT_FALSE(state.take().pressed(Key::space));
  state.key_up(Key::enter);  // pressed before the window had the focus
  EXPECT_FALSE(state.take().released(Key::enter));
}

TEST(InputState, LosingTheFocusReleasesEverything) {
  InputState state;
  state.key_down(Key::shift);
  state.button_down(MouseButton::right);
  state.take();
  state.focus_lost();
  const WindowInput input = state.take();
  EXPECT_TRUE(input.keys_held.none() && input.buttons_held.none());
  EXPECT_TRUE(input.released(Key::shift) && input.released(MouseButton::right));
}

TEST(SinglePresses, AreInOrderAndTheLastOneHasTheRest) {
  InputState events;
  events.mouse_at({10.0, 10.0});
  events.key_down(Key::down);
  events.key_up(Key::down);
  events.key_down(Key::down);
  events.button_down(MouseButton::left);
  events.mouse_at({50.0, 50.0});
  events.wheel({0.0, -2.0});
  events.text("x");
  events.quit();
  const std::vector<WindowInput> parts = single_presses(events.take());
  ASSERT_EQ(parts.size(), 5U);
  EXPECT_TRUE(parts[0].pressed(Key::down));
  EXPECT_FALSE(parts[0].held(Key::down)) << "it is held by a later press";
  EXPECT_TRUE(parts[1].pressed(Key::down));
  EXPECT_TRUE(parts[1].held(Key::down));
  EXPECT_FALSE(parts[1].pressed(MouseButton::left));
  EXPECT_TRUE(parts[2].pressed(MouseButton::left));
  EXPECT_EQ(parts[2].mouse, (ribbon::Vec2{10.0, 10.0}));
  EXPECT_FALSE(parts[2].quit);
  EXPECT_TRUE(parts[3].pressed(WheelTurn::down));
  EXPECT_TRUE(parts[4].pressed(WheelTurn::down));
  EXPECT_EQ(parts[4].mouse, (ribbon::Vec2{50.0, 50.0}));
  EXPECT_EQ(parts[4].text, "x");
  EXPECT_TRUE(parts[4].released(Key::down));
  EXPECT_TRUE(parts[4].quit);
  EXPECT_TRUE(events.take().presses.empty());
}

/// A press of one player must not take away what the other one holds or presses on its gamepad.
TEST(SinglePresses, KeepTheGamepadsApart) {
  InputState events;
  events.pad_down(PadButton::x, 1);
  events.take();
  events.key_down(Key::down);
  events.pad_down(PadButton::a, 1);
  events.key_down(Key::up);
  const std::vector<WindowInput> parts = single_presses(events.take());
  ASSERT_EQ(parts.size(), 3U);
  int presses = 0;
  for (const WindowInput& part : parts) {
    EXPECT_TRUE(part.with_pad(1).held(PadButton::x));
    presses += part.with_pad(1).pressed(PadButton::a) ? 1 : 0;
    EXPECT_FALSE(part.with_pad(0).pressed(PadButton::a));
  }
  EXPECT_EQ(presses, 1);
}

TEST(SinglePresses, WithoutAPressThereIsOnePart) {
  InputState events;
  events.focus_lost();
  const std::vector<WindowInput> parts = single_presses(events.take());
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_TRUE(parts[0].focus_lost);
}

TEST(SinglePresses, AFineWheelPressesOnceInAPoll) {
  InputState events;
  for (int k = 0; k < 10; ++k) events.wheel({0.0, 0.1});
  const std::vector<WindowInput> parts = single_presses(events.take());
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_TRUE(parts[0].pressed(WheelTurn::up));
}

TEST(WindowSize, FitsTheUsablePartOfTheDisplay) {
  EXPECT_EQ(fitting_size({1280, 720}, {1920, 1040}), (WindowSize{1280, 720}));
  EXPECT_EQ(fitting_size({1280, 720}, {800, 600}), (WindowSize{800, 600}));
  EXPECT_EQ(fitting_size({1280, 720}, {1366, 728}, {4, 30}), (WindowSize{1280, 698}));
  EXPECT_EQ(fitting_size({1280, 720}, {}), (WindowSize{1280, 720})) << "unknown";
  EXPECT_EQ(fitting_size({1280, 720}, {20, 20}, {30, 30}), (WindowSize{1, 1}));
}

TEST(InputState, MouseAndQuit) {
  InputState state;
  state.mouse_at({12.0, 34.0});
  state.button_down(MouseButton::left);
  state.button_up(MouseButton::left);
  state.quit();
  const WindowInput input = state.take();
  EXPECT_TRUE(input.quit && input.pressed(MouseButton::left) && !input.held(MouseButton::left));
  EXPECT_EQ(input.mouse, (Vec2{12.0, 34.0}));
  const WindowInput next = state.take();
  EXPECT_FALSE(next.quit);
  EXPECT_EQ(next.mouse, (Vec2{12.0, 34.0}));
}

TEST(Window, DrawsAndPacesWithoutAScreen) {
  const Environment driver("SDL_VIDEODRIVER", "dummy");
  const TemporaryDirectory directory;
  Window window("test", 160, 90);
  EXPECT_EQ(window.canvas().width(), 160);
  EXPECT_EQ(window.canvas().height(), 90);
  EXPECT_GE(window.pixel_scale(), 1.0);
  const std::int64_t start = engine::now_ns();
  for (int frame = 0; frame < 6; ++frame) {
    EXPECT_FALSE(window.poll().quit);
    draw_scene(window.canvas());
    window.present();
  }
  EXPECT_GE(engine::now_ns() - start, 5 * 16'000'000);  // without a display to wait for it limits itself to 60 Hz

  window.save_png((directory.path / "window.png").string());
  HeadlessCanvas canvas(160, 90);
  draw_scene(canvas);
  canvas.save_png((directory.path / "headless.png").string());
  EXPECT_EQ(bytes_of(directory.path / "window.png"), bytes_of(directory.path / "headless.png"));
}

TEST(Window, DrawsOnWhenItIsRenewed) {
  const Environment driver("SDL_VIDEODRIVER", "dummy");
  Window window("test", 160, 90);
  draw_scene(window.canvas());
  window.present();
  window.renew();
  EXPECT_EQ(window.canvas().width(), 160);
  EXPECT_EQ(pixel(window.raster(), 80, 60), 0U);  // black, as after any other change of the canvas
  draw_scene(window.canvas());
  EXPECT_NE(pixel(window.raster(), 80, 60), 0U);
  EXPECT_NO_THROW(window.present());
}

TEST(Window, OpensAgain) {
  const Environment driver("SDL_VIDEODRIVER", "dummy");
  for (int i = 0; i < 2; ++i) EXPECT_NO_THROW(Window("test", 64, 64).present());
  EXPECT_THROW(Window("test", 0, 64), std::invalid_argument);
}

TEST(Window, ReportsAMissingDisplay) {
  const Environment driver("SDL_VIDEODRIVER", nullptr);
  const Environment x11("DISPLAY", nullptr);
  const Environment wayland("WAYLAND_DISPLAY", nullptr);
  const Environment runtime("XDG_RUNTIME_DIR", "/nonexistent");
  try {
    const Window window("test", 64, 64);
    GTEST_SKIP() << "this machine shows windows without a desktop session";
  } catch (const std::runtime_error& error) {
    EXPECT_TRUE(says(error.what(), "no display"));
    EXPECT_TRUE(says(error.what(), "--headless"));
  }
}
