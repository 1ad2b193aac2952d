#include "game/view/view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/window/sdl_canvas.h"
#include "game/simulation/buttons.h"
#include "tests/game/view/counting_canvas.h"
#include "tests/support/mixed_level.h"

namespace game {
namespace {

int contacts_of(const Simulation& simulation) {
  const ribbon::box2d::Coupling& coupling = simulation.scene().coupling();
  int count = 0;
  for (int c = 0; c < coupling.size(); ++c)
    if (coupling.cord(c).solver() == ribbon::box2d::Solver::direct)
      count += static_cast<int>(coupling.cord(c).direct().touches().size());
  return count;
}

void draw(CountingCanvas& canvas, const Level& level, bool debug) {
  Simulation simulation(level);
  for (int k = 0; k < 3; ++k) simulation.tick({});
  ViewOptions options;
  options.debug = debug;
  View(simulation).draw(canvas, 0.5, options);
}

TEST(View, ShowsTheCountsOfEachSolverInUse) {
  CountingCanvas mixed;
  draw(mixed, test_support::mixed_swing(), true);
  EXPECT_TRUE(mixed.shows("tangled"));
  EXPECT_TRUE(mixed.shows("iterations"));
  EXPECT_TRUE(mixed.shows("unconverged in all"));
  EXPECT_TRUE(mixed.shows("82"));  // points of a cord of the thesis's
  EXPECT_TRUE(mixed.shows("41"));  // and of the hammock
  CountingCanvas direct;
  draw(direct, load_level("first_swing"), true);
  EXPECT_TRUE(direct.shows("iterations"));
  EXPECT_TRUE(direct.shows("impacts in all"));
  EXPECT_FALSE(direct.shows("tangled"));
  CountingCanvas playing;
  draw(playing, test_support::mixed_swing(), false);
  EXPECT_FALSE(playing.shows("iterations"));
}

TEST(View, ShowsWhichCordsAreAsleep) {
  const Level level = load_level("first_swing");
  Simulation simulation(level);
  ViewOptions options;
  options.debug = true;
  for (const bool expected : {false, true}) {
    CountingCanvas canvas;
    View(simulation).draw(canvas, 1.0, options);
    EXPECT_EQ(canvas.shows("asleep"), expected);
    for (int k = 0; k < 90; ++k) simulation.tick({});
  }
}

TEST(View, ShowsANotice) {
  const Level level = load_level("first_swing");
  const Simulation simulation(level);
  CountingCanvas canvas;
  ViewOptions options;
  options.notice = "The recording has ended";
  View(simulation).draw(canvas, 1.0, options);
  EXPECT_TRUE(canvas.shows("The recording has ended"));
}

/// All points, all bars between them, the box of each cord, and a line and a dot for each contact.
TEST(View, TheDebugViewDrawsThePointsAndBarsOfEitherSolver) {
  const auto more_in_debug = [](const Level& level) {
    CountingCanvas playing;
    CountingCanvas debug;
    draw(playing, level, false);
    draw(debug, level, true);
    Simulation simulation(level);
    for (int k = 0; k < 3; ++k) simulation.tick({});
    return debug.shapes - playing.shapes - 2 * contacts_of(simulation);
  };
  constexpr int counts_panel = 1;
  constexpr int boxes = 4;
  const int thesis_cord = 41 * 2 + (41 + 40 * 2 + 40 * 2);  // points; bars across, along and the other way
  const int rope = 41 + 40;
  EXPECT_EQ(more_in_debug(load_level("first_swing")), counts_panel + boxes + 4 * rope);
  EXPECT_EQ(more_in_debug(test_support::mixed_swing()), counts_panel + boxes + rope + 3 * thesis_cord);
}

TEST(View, TheDebugViewShowsContacts) {
  const Level level = load_level("first_swing");
  Simulation simulation(level);
  while (contacts_of(simulation) == 0 && simulation.ticks() < 600) simulation.tick({});
  const int contacts = contacts_of(simulation);
  ASSERT_GT(contacts, 0);
  CountingCanvas playing;
  CountingCanvas debug;
  ViewOptions options;
  View(simulation).draw(playing, 1.0, options);
  options.debug = true;
  View(simulation).draw(debug, 1.0, options);
  EXPECT_EQ(debug.shapes - playing.shapes, 1 + 4 + 4 * (41 + 40) + 2 * contacts);
}

/// A level with a rope that runs over a wheel above the player, to the right, where it is longer.
Level reeved_swing() {
  using nlohmann::json;
  json map = json::parse(std::ifstream(assets_folder() + "/levels/first_swing.tmj"));
  const double scale = load_level("first_swing").map.pixels_per_metre;
  json& objects = map["layers"][0]["objects"];
  double x = 0.0;
  double y = 0.0;
  for (const json& object : objects) {
    if (object["type"] != "player") continue;
    x = object["x"];
    y = object["y"];
  }
  const auto property = [](const char* name, const char* type, const json& value) {
    return json{{"name", name}, {"type", type}, {"value", value}};
  };
  const auto made = [&](int id, const char* kind, double left, double up, const json& properties) {
    return json{{"id", id},     {"name", ""},    {"type", kind},  {"x", x + left * scale}, {"y", y - up * scale},
                {"width", 0.0}, {"height", 0.0}, {"rotation", 0}, {"visible", true},       {"properties", properties}};
  };
  json cord = made(900, "cord", 1.0, 4.0, {property("columns", "int", 41), property("mass", "float", 2.0)});
  const auto corner = [&](double right, double up) { return json{{"x", right * scale}, {"y", -up * scale}}; };
  cord["polyline"] = {corner(0.0, 0.0), corner(0.5, 2.0), corner(1.0, -1.0)};
  json wheel = made(901, "wheel", 1.0, 6.0, {property("cord", "int", 900), property("inertia", "float", 0.1)});
  wheel["width"] = wheel["height"] = scale;
  wheel["ellipse"] = true;
  objects.push_back(cord);
  objects.push_back(wheel);
  return level_of(engine::parse_tiled_map(map.dump(), "reeved_swing.tmj"));
}

/// A wheel turns clockwise with the rope that runs over it to the right, in the picture as in the world.
TEST(View, ShowsWheels) {
  const Level level = reeved_swing();
  Simulation simulation(level);
  for (int k = 0; k < 20; ++k) simulation.tick({});
  ASSERT_EQ(simulation.current().wheels.size(), 1U);
  const Snapshot::Wheel before = simulation.previous().wheels[0];
  const Snapshot::Wheel after = simulation.current().wheels[0];
  EXPECT_EQ(after.radius, 0.5);
  EXPECT_LT(length(after.center - before.center), 1e-6);
  EXPECT_LT(after.angle, before.angle);
  EXPECT_LT(before.angle, 0.0);
  EXPECT_NEAR(interpolate(simulation.previous(), simulation.current(), 0.25).wheels[0].angle,
              0.75 * before.angle + 0.25 * after.angle, 1e-12);
  CountingCanvas canvas;
  View(simulation).draw(canvas, 1.0, {});
  const int shown = canvas.shapes;
  simulation.scene().coupling().pulley(simulation.scene().wheels()[0].pulley).remove();
  simulation.tick({});
  EXPECT_EQ(simulation.current().wheels[0].radius, 0.0);
  CountingCanvas without;
  View(simulation).draw(without, 1.0, {});
  EXPECT_LT(without.shapes, shown);
}

std::vector<std::uint32_t> picture(const ViewOptions& options, int ticks, int frames_apart) {
  const Level level = load_level("first_swing");
  Simulation simulation(level);
  View view(simulation);
  engine::HeadlessCanvas canvas(320, 180);
  for (int k = 0; k < ticks; ++k) {
    engine::TickInput input;
    input.buttons = button_right;
    simulation.tick(input);
    if (simulation.ticks() % frames_apart == 0) view.draw(canvas, 1.0, options);
  }
  view.draw(canvas, 1.0, options);
  return canvas.raster().pixels();
}

TEST(View, TwoRunsGiveTheSamePictures) {
  for (const bool reduced : {false, true}) {
    ViewOptions options;
    options.reduced_motion = reduced;
    options.strain_tint = reduced;
    EXPECT_EQ(picture(options, 120, 2), picture(options, 120, 2));
  }
}

TEST(View, EachOptionChangesThePicture) {
  const ViewOptions usual;
  const auto plain = picture(usual, 60, 1);
  ViewOptions options;
  options.strain_tint = true;
  EXPECT_NE(picture(options, 60, 1), plain);
  options = usual;
  options.colour_safe = true;
  EXPECT_NE(picture(options, 60, 1), plain);
  options = usual;
  options.ghost = GhostPose{{3.0, 6.0}, {}};
  EXPECT_NE(picture(options, 60, 1), plain);
  options = usual;
  options.reduced_motion = true;
  EXPECT_NE(picture(options, 60, 1), plain);
}

TEST(View, DrawingDoesNotChangeARun) {
  const Level level = load_level("first_swing");
  Simulation seen(level);
  Simulation unseen(level);
  View view(seen);
  engine::HeadlessCanvas canvas(160, 90);
  ViewOptions options;
  options.debug = true;
  for (int k = 0; k < 200; ++k) {
    engine::TickInput input;
    input.buttons = k % 50 < 30 ? button_right : button_grab | button_jump;
    seen.tick(input);
    unseen.tick(input);
    view.draw(canvas, 0.5, options);
    ASSERT_EQ(seen.hash(), unseen.hash()) << k;
  }
}

/// A shank with a ring, each twice because of the outline.
TEST(View, AHangingWeightHasAnEye) {
  const Level level = load_level("sandbox");
  Simulation simulation(level);
  CountingCanvas hanging;
  View(simulation).draw(hanging, 1.0, {});
  for (const engine::SceneBody& made : simulation.scene().bodies()) {
    if (made.kind == engine::BodyKind::load) simulation.scene().coupling().body(*made.body).release();
  }
  CountingCanvas let_go;
  View(simulation).draw(let_go, 1.0, {});
  EXPECT_EQ(hanging.shapes, let_go.shapes + 4);
}

TEST(View, TheStrainLegendIsThereOnRequest) {
  const Level level = load_level("first_swing");
  const Simulation simulation(level);
  for (const bool wanted : {false, true}) {
    CountingCanvas canvas;
    ViewOptions options;
    options.strain_tint = wanted;
    View(simulation).draw(canvas, 1.0, options);
    EXPECT_EQ(canvas.shows("stretched by"), wanted);
  }
}

}  // namespace
}  // namespace game
