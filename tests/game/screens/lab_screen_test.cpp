// The lab as a person uses it: its keys, buttons and sliders, by the frames of the program.

#include "game/screens/lab_screen.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "game/lab/figures.h"
#include "game/lab_view/world_view.h"
#include "game/screens/title_screen.h"
#include "game/view/hud.h"
#include "game/words/lab_words.h"
#include "tests/game/screens/text_canvas.h"

namespace game {
namespace {

using engine::Key;
using ribbon::Vec2;

class LabAt : public testing::TestWithParam<CanvasSize> {
 protected:
  LabAt() : canvas(GetParam().width, GetParam().height), scale(text_scale_of(canvas, 1.0)) {}

  Next frame(LabScreen& screen, const engine::WindowInput& input = {}, std::int64_t elapsed_ns = frame_ns) const {
    const MenuInput menu;
    return screen.update({input, menu, canvas, elapsed_ns, scale});
  }
  Next press(LabScreen& screen, Key key) const {
    engine::WindowInput input;
    input.keys_pressed.set(static_cast<std::size_t>(key));
    return frame(screen, input);
  }
  engine::WindowInput mouse(Vec2 at, bool pressed, bool held) const {
    engine::WindowInput input;
    input.mouse = at;
    input.buttons_pressed.set(static_cast<std::size_t>(engine::MouseButton::left), pressed);
    input.buttons_held.set(static_cast<std::size_t>(engine::MouseButton::left), held);
    return input;
  }
  Next click(LabScreen& screen, const Rectangle& place) const {
    const Vec2 at = place.corner + 0.5 * place.size;
    Next next = frame(screen, mouse(at, true, true), 0);
    frame(screen, mouse(at, false, false), 0);
    return next;
  }
  lab::Layout layout() const { return lab::layout_of(canvas, scale); }
  std::string draw(LabScreen& screen) {
    canvas.forget();
    screen.draw(canvas, scale);
    if (!session.notice.text().empty()) draw_notice(canvas, session.notice.text(), scale);
    return canvas.all();
  }

  TextCanvas canvas;
  double scale;
  Session session{"", ""};
};
INSTANTIATE_TEST_SUITE_P(Sizes, LabAt,
                         testing::Values(CanvasSize{640, 360}, CanvasSize{1280, 720}, CanvasSize{2560, 1440}),
                         [](const auto& size) { return std::to_string(size.param.width); });

/// No text is cut, hidden by a panel or overlapped by another one, at the start, in motion, with extreme values and
/// with a notice; and none ends in "…".
TEST_P(LabAt, AllTextsOfAllScenesAreReadable) {
  for (const lab::Scene& scene : lab::scenes()) {
    for (const char* notice : {"", "A gamepad is plugged in"}) {
      LabScreen screen(session, scene.name);
      session.notice.show(notice);
      const auto expect_readable = [&](const std::string& what) {
        const std::string texts = draw(screen);
        EXPECT_EQ(canvas.faults(), "") << scene.name << ": " << what;
        EXPECT_EQ(texts.find("…"), std::string::npos) << scene.name << ": " << what << "\n" << texts;
      };
      expect_readable("at the start");
      for (int k = 0; k < 30; ++k) frame(screen);
      expect_readable("in motion");
      press(screen, Key::p);
      for (int k = 0; k < 3; ++k) press(screen, Key::x);
      for (const double share : {0.0, 1.0}) {
        for (std::size_t k = 0; k < scene.knobs.size(); ++k) {
          const Rectangle bar = lab::Console::bar_place(k, layout());
          click(screen, {bar.corner + Vec2{share * bar.size.x - 0.5, 0.0}, {1.0, bar.size.y}});
        }
        expect_readable("with sliders at " + std::to_string(share));
      }
    }
  }
  session.notice.show("");
}

TEST_P(LabAt, PauseAndStepCountTicksExactly) {
  LabScreen screen(session, "bridge");
  for (int k = 0; k < 10; ++k) frame(screen);
  EXPECT_EQ(screen.experiment().ticks(), 10);
  press(screen, Key::p);
  for (int k = 0; k < 10; ++k) frame(screen);
  EXPECT_EQ(screen.experiment().ticks(), 10);
  for (int k = 1; k <= 3; ++k) {
    press(screen, Key::n);
    frame(screen);
    EXPECT_EQ(screen.experiment().ticks(), 10 + k);
  }
  click(screen, lab::Console::button_place(lab::Button::step, layout()));
  frame(screen);
  EXPECT_EQ(screen.experiment().ticks(), 14) << "by mouse too";
  click(screen, lab::Console::button_place(lab::Button::pause, layout()));
  for (int k = 0; k < 8; ++k) frame(screen);
  EXPECT_EQ(screen.experiment().ticks(), 22);
  press(screen, Key::x);
  const int before = screen.experiment().ticks();
  for (int k = 0; k < 20; ++k) frame(screen);
  EXPECT_NEAR(screen.experiment().ticks() - before, 10, 1) << "half speed";
}

TEST_P(LabAt, RestartReturnsToTheFirstState) {
  LabScreen screen(session, "capstan");
  const std::uint64_t first = screen.experiment().hash();
  for (int k = 0; k < 30; ++k) frame(screen);
  ASSERT_NE(screen.experiment().hash(), first);
  press(screen, Key::p);
  press(screen, Key::r);
  EXPECT_EQ(screen.experiment().ticks(), 0);
  EXPECT_EQ(screen.experiment().hash(), first);
}

/// A click on a slider changes the experiment; dragging in the world moves a cord, and dragging a slider across the
/// world does not.
TEST_P(LabAt, TheMouseTurnsSlidersAndDragsCords) {
  LabScreen screen(session, "bridge");
  const Rectangle bar = lab::Console::bar_place(0, layout());
  const Vec2 end = bar.corner + Vec2{bar.size.x, 0.5 * bar.size.y};
  frame(screen, mouse(end, true, true));
  EXPECT_EQ(screen.experiment().values()[lab::Knob::load_ratio], 1e4);
  canvas.set_view({});
  lab::set_view(canvas, screen.experiment().scene(), layout().world);
  const auto pin = [&] { return screen.experiment().benches()[0]->coupling().cord(0).positions().front(); };
  const Vec2 start = pin();
  frame(screen, mouse(canvas.to_pixels(start), false, true));
  EXPECT_FALSE(screen.experiment().benches()[0]->drag().cord_point());
  frame(screen, mouse(canvas.to_pixels(start), false, false));
  frame(screen, mouse(canvas.to_pixels(start), true, true));
  EXPECT_TRUE(screen.experiment().benches()[0]->drag().cord_point());
  for (int k = 0; k < 60; ++k) frame(screen, mouse(canvas.to_pixels(start + Vec2{0.4, 0.4}), false, true));
  EXPECT_LT(length(pin() - start - Vec2{0.4, 0.4}), 0.05);
  frame(screen, mouse(canvas.to_pixels(start), false, false));
  EXPECT_FALSE(screen.experiment().benches()[0]->drag().cord_point());
}

/// Also when no tick comes: nothing is dragged any more, and a press elsewhere picks what is there.
TEST_P(LabAt, ADragThatEndsInAPauseIsOver) {
  LabScreen screen(session, "bridge");
  canvas.set_view({});
  lab::set_view(canvas, screen.experiment().scene(), layout().world);
  const auto x = screen.experiment().benches()[0]->coupling().cord(0).positions();
  const Vec2 first = canvas.to_pixels(x.front());
  const Vec2 last = canvas.to_pixels(x.back());
  const auto dragged = [&] { return screen.experiment().benches()[0]->drag().cord_point(); };
  frame(screen, mouse(first, true, true));
  ASSERT_TRUE(dragged());
  press(screen, Key::p);
  frame(screen, mouse(first, true, true));
  frame(screen, mouse(first, false, true));
  frame(screen, mouse(first, false, false));
  EXPECT_FALSE(dragged());
  frame(screen, mouse(last, true, true));
  engine::WindowInput step = mouse(last, false, true);
  step.keys_pressed.set(static_cast<std::size_t>(Key::n));
  frame(screen, step);
  ASSERT_TRUE(dragged());
  EXPECT_EQ(dragged()->point, static_cast<int>(x.size()) - 1);
}

/// The preset fast takes a heap in one step, and leaves some substeps unconverged: both are shown.
TEST_P(LabAt, SaysWhatTheHeapDoesNotDo) {
  LabScreen screen(session, "pile");
  const auto slider = std::find_if(screen.experiment().scene().knobs.begin(), screen.experiment().scene().knobs.end(),
                                   [](const lab::KnobRange& range) { return range.knob == lab::Knob::substeps; });
  const auto line = static_cast<std::size_t>(slider - screen.experiment().scene().knobs.begin());
  const Rectangle bar = lab::Console::bar_place(line, layout());
  click(screen, {bar.corner + Vec2{slider->position_of(4.0) * bar.size.x - 0.5, 0.0}, {1.0, bar.size.y}});
  ASSERT_EQ(screen.experiment().values()[lab::Knob::substeps], 4.0);
  EXPECT_EQ(draw(screen).find("in a heap"), std::string::npos) << "nothing touches";
  for (int k = 0; k < 180; ++k) frame(screen);
  const std::string texts = draw(screen);
  EXPECT_NE(texts.find("4; 1 for 12 in a heap"), std::string::npos) << texts;
  EXPECT_NE(texts.find("substeps did not converge"), std::string::npos) << texts;
  EXPECT_EQ(canvas.faults(), "");
}

TEST_P(LabAt, OpensItsScenesByClicksAndLeavesByItsButton) {
  LabScreen screen(session, "heavy_load");
  for (std::size_t k = 0; k < lab::scenes().size(); ++k) {
    click(screen, lab::Console::scene_place(k, layout()));
    EXPECT_EQ(screen.experiment().scene().name, lab::scenes()[k].name);
    EXPECT_NE(screen.title().find(words::lab::scenes[k].title), std::string::npos);
  }
  EXPECT_EQ(click(screen, lab::Console::button_place(lab::Button::back, layout())).what, Next::What::back);
  const engine::WindowInput none;
  EXPECT_EQ(screen.update({none, {.back = true}, canvas, frame_ns, scale}).what, Next::What::back);
}

TEST_P(LabAt, IsInTheMenuOfTheTitle) {
  TitleScreen title(session);
  const engine::WindowInput none;
  title.update({none, {.down = 1}, canvas, frame_ns, scale});
  const Next next = title.update({none, {.accept = true}, canvas, frame_ns, scale});
  ASSERT_EQ(next.what, Next::What::open);
  EXPECT_NE(dynamic_cast<const LabScreen*>(next.screens.front().get()), nullptr);
}

TEST(LabScreenTest, RefusesAnUnknownScene) {
  Session session("", "");
  EXPECT_THROW(LabScreen(session, "nonsense"), std::runtime_error);
}

}  // namespace
}  // namespace game
