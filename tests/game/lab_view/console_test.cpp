#include "game/lab_view/console.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "engine/window/sdl_canvas.h"
#include "game/lab_view/plot.h"
#include "game/lab_view/tick_cost.h"
#include "game/lab_view/world_view.h"

namespace game::lab {
namespace {

using ribbon::Vec2;

struct Size {
  int width, height;
  double scale;
};

class ConsoleAt : public testing::TestWithParam<Size> {
 protected:
  ConsoleAt()
      : canvas(GetParam().width, GetParam().height),
        layout(layout_of(canvas, GetParam().scale)),
        experiment(scene_named("heavy_load")) {}

  ConsoleRequest press(Vec2 at) {
    const ConsoleRequest request = console.update({.mouse = at, .pressed = true, .held = true}, experiment, layout);
    console.update({.mouse = at}, experiment, layout);
    return request;
  }
  static Vec2 middle(const Rectangle& place) { return place.corner + 0.5 * place.size; }

  engine::HeadlessCanvas canvas;
  Layout layout;
  Experiment experiment;
  Console console;
};
INSTANTIATE_TEST_SUITE_P(Sizes, ConsoleAt,
                         testing::Values(Size{640, 360, 0.65}, Size{1280, 720, 1.0}, Size{2560, 1440, 1.5}),
                         [](const auto& size) { return std::to_string(size.param.width); });

/// Scenes, sliders of every scene and buttons have places of their own on the canvas, beside the world.
TEST_P(ConsoleAt, PlacesDoNotOverlap) {
  for (const Scene& scene : scenes()) {
    std::vector<Rectangle> places = {layout.world, layout.head, layout.plots};
    for (std::size_t k = 0; k < scenes().size(); ++k) places.push_back(Console::scene_place(k, layout));
    for (std::size_t k = 0; k < scene.knobs.size(); ++k) places.push_back(Console::knob_place(k, layout));
    for (int k = 0; k < button_count; ++k) places.push_back(Console::button_place(static_cast<Button>(k), layout));
    for (std::size_t k = 0; k < places.size(); ++k) {
      EXPECT_GE(places[k].corner.x, 0.0);
      EXPECT_GE(places[k].corner.y, 0.0);
      EXPECT_LE(places[k].corner.x + places[k].size.x, canvas.width() + 1e-6) << scene.name << " " << k;
      EXPECT_LE(places[k].corner.y + places[k].size.y, canvas.height() + 1e-6) << scene.name << " " << k;
      for (std::size_t other = k + 1; other < places.size(); ++other)
        EXPECT_LT(shared_area(places[k], places[other]), 1e-6) << scene.name << " " << k << " " << other;
    }
  }
}

TEST_P(ConsoleAt, AClickOpensASceneOrPressesAButton) {
  for (std::size_t k = 0; k < scenes().size(); ++k) EXPECT_EQ(press(middle(Console::scene_place(k, layout))).scene, k);
  for (int k = 0; k < button_count; ++k) {
    const auto button = static_cast<Button>(k);
    EXPECT_EQ(press(middle(Console::button_place(button, layout))).button, button);
  }
  const ConsoleRequest nothing = press(middle(layout.world));
  EXPECT_FALSE(nothing.scene || nothing.turn || nothing.button);
  EXPECT_FALSE(console.takes_mouse(middle(layout.world), layout));
  EXPECT_TRUE(console.takes_mouse(middle(layout.list), layout));
}

/// A slider that is held follows the mouse, also beside it, until it is released.
TEST_P(ConsoleAt, ASliderFollowsTheMouse) {
  const KnobRange& range = experiment.scene().knobs.front();
  const Rectangle bar = Console::bar_place(0, layout);
  const auto at = [&](double share) { return bar.corner + Vec2{share * bar.size.x, 0.5 * bar.size.y}; };
  const auto turn = [&](Vec2 mouse, bool pressed, bool held) {
    return console.update({.mouse = mouse, .pressed = pressed, .held = held}, experiment, layout).turn;
  };
  EXPECT_EQ(turn(at(1.0), true, true)->value, 1e6);
  EXPECT_EQ(turn(at(0.0) - Vec2{50.0, 90.0}, false, true)->value, 1.0);
  EXPECT_EQ(turn(at(0.5), false, true)->value, range.value_at(0.5));
  EXPECT_TRUE(console.takes_mouse(middle(layout.world), layout)) << "while it is held";
  EXPECT_FALSE(turn(at(0.7), false, false));
  EXPECT_FALSE(turn(at(0.7), false, true)) << "a button that went down elsewhere";
}

/// Keys reach every line: scenes, sliders and buttons.
TEST_P(ConsoleAt, KeysReachEverything) {
  std::vector<std::size_t> opened;
  std::vector<Knob> turned;
  std::vector<Button> buttons;
  const std::size_t lines = scenes().size() + experiment.scene().knobs.size() + std::size_t{button_count};
  for (std::size_t k = 0; k < lines; ++k) {
    const ConsoleRequest request = console.update({.accept = true}, experiment, layout);
    if (request.scene) opened.push_back(*request.scene);
    if (request.turn) turned.push_back(request.turn->knob);
    if (request.button) buttons.push_back(*request.button);
    console.update({.down = 1}, experiment, layout);
  }
  EXPECT_EQ(opened.size(), scenes().size());
  EXPECT_EQ(turned.size(), experiment.scene().knobs.size());
  EXPECT_EQ(buttons.size(), std::size_t{button_count});
  EXPECT_EQ(console.update({.accept = true}, experiment, layout).scene, 0U) << "it goes round";
  for (std::size_t k = 0; k < scenes().size(); ++k) console.update({.down = 1}, experiment, layout);
  const auto turn = console.update({.right = 1}, experiment, layout).turn;
  ASSERT_TRUE(turn);
  EXPECT_EQ(turn->value, experiment.scene().knobs.front().stepped(experiment.scene().knobs.front().initial, 1));
}

/// A pixel of the world and the place that it shows belong together.
TEST_P(ConsoleAt, ThePointerIsWhereTheViewShowsIt) {
  for (const Scene& scene : scenes()) {
    set_view(canvas, scene, layout.world);
    for (const Vec2 place : {scene.low, scene.high}) {
      const Vec2 pixel = canvas.to_pixels(place);
      EXPECT_GE(pixel.x, layout.world.corner.x - 1e-6) << scene.name;
      EXPECT_LE(pixel.x, layout.world.corner.x + layout.world.size.x + 1e-6) << scene.name;
      EXPECT_GE(pixel.y, layout.world.corner.y - 1e-6) << scene.name;
      EXPECT_LE(pixel.y, layout.world.corner.y + layout.world.size.y + 1e-6) << scene.name;
      EXPECT_LT(length(to_world(scene, layout.world, pixel) - place), 1e-9) << scene.name;
    }
  }
}

TEST(LabPlot, RangesHaveAllFiniteNumbers) {
  const std::vector<double> numbers = {std::nan(""), 3.0, -1.0, std::nan(""), 2.0};
  const PlotRange range = range_around(numbers, 1.0);
  EXPECT_EQ(range.low, -1.0);
  EXPECT_EQ(range.high, 3.0);
  const PlotRange narrow = range_around(std::vector{5.0, 5.0}, 1.0);
  EXPECT_EQ(narrow.low, 4.5);
  EXPECT_EQ(narrow.high, 5.5);
  const PlotRange empty = range_around({}, 1.0);
  EXPECT_EQ(empty.high - empty.low, 1.0);
}

TEST(LabTickCost, IsTheMedianAndTheMaximumOfTheLastSecond) {
  TickCost cost;
  EXPECT_EQ(cost.median_us(), 0.0);
  EXPECT_EQ(cost.worst_us(), 0.0);
  cost.add(9'000'000);
  for (int k = 0; k < 60; ++k) cost.add(1000 * (k % 3 + 1));
  EXPECT_EQ(cost.median_us(), 2.0);
  EXPECT_EQ(cost.worst_us(), 3.0) << "the first tick is more than a second ago";
  cost.forget();
  EXPECT_EQ(cost.worst_us(), 0.0);
}

}  // namespace
}  // namespace game::lab
