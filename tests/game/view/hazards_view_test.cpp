// What is drawn of ropes near their end: char, flames and frays.

#include <gtest/gtest.h>

#include <vector>

#include "engine/window/sdl_canvas.h"
#include "game/view/fraying.h"
#include "game/view/hazards.h"
#include "game/view/view.h"
#include "tests/game/simulation/small_level.h"
#include "tests/game/view/counting_canvas.h"

namespace game {
namespace {

DrawnCord drawn(const Simulation& simulation, ribbon::box2d::CordId id) {
  const ribbon::box2d::Coupling& coupling = simulation.scene().coupling();
  return {coupling, id, coupling.cord(id).shape(), simulation.current().cords[static_cast<std::size_t>(id)]};
}

int shapes_of(const Simulation& simulation) {
  CountingCanvas canvas;
  View(simulation).draw(canvas, 1.0, {});
  return canvas.shapes;
}

/// A load of 50 kg on a rope of 2 kg: 0.5 kN at its pin.
engine::TiledMap loaded(double breaking_force) {
  MapObject rope = hanging_rope(10, {6.0, 10.0});
  rope.properties.insert("breaking_force", breaking_force);
  MapObject load = box_of(11, "load", {6.0, 5.7}, {0.6, 0.6});
  load.properties.insert("mass", 50.0);
  load.properties.insert("cord", std::int64_t{10});
  return small_map({rope, load});
}

TEST(Fraying, ARopeNearItsBreakingForceIsFrayedWhereItIsLoadedMost) {
  const Level weak = level_of(loaded(620.0));
  const Level strong = level_of(loaded(6200.0));
  const Level other = level_of(loaded(0.0));
  Simulation simulation(weak);
  Simulation safe(strong);
  Simulation unbreakable(other);
  for (Simulation* each : {&simulation, &safe, &unbreakable}) run(*each, 60);
  EXPECT_NEAR(load_share(drawn(simulation, 0), 0), 52.0 * 9.81 / 620.0, 0.02);
  EXPECT_NEAR(load_share(drawn(safe, 0), 0), 0.1 * 52.0 * 9.81 / 620.0, 0.002);
  EXPECT_EQ(load_share(drawn(unbreakable, 0), 0), 0.0);
  EXPECT_EQ(load_share(drawn(simulation, 0), 99), 0.0);
  EXPECT_EQ(shapes_of(safe), shapes_of(unbreakable));
  EXPECT_GT(shapes_of(simulation), shapes_of(safe) + 40) << "a fibre a link or more";
}

TEST(Burning, ARopeInAFireIsBlackAndFlames) {
  MapObject fire = box_of(20, "fire", {6.0, 8.0}, {0.5, 0.15});
  fire.properties.insert("seconds", 2.0);
  const Level level = level_of(small_map({hanging_rope(10, {6.0, 10.0}), fire}));
  Simulation simulation(level);
  const int before = shapes_of(simulation);
  run(simulation, 60);
  EXPECT_GE(shapes_of(simulation), before + 3) << "a flame on the rope";
  CountingCanvas canvas;
  const Palette& colors = palette(false);
  const Pen pen{canvas, colors, textures(false, Place::hills)};
  std::vector<engine::Color> tints;
  add_char(pen, drawn(simulation, 0), simulation.rules().burning(), tints);
  ASSERT_EQ(tints.size(), 41U);
  EXPECT_EQ(tints[5], own_color(pen, drawn(simulation, 0)));
  EXPECT_LT(tints[20].g, tints[5].g);
  tints.clear();
  add_char(pen, drawn(simulation, 0), Burning{}, tints);
  EXPECT_TRUE(tints.empty()) << "a cord that was in no fire keeps its look";
}

TEST(Hazards, AreDrawnAndCoinsAreCounted) {
  const auto shapes_with = [](std::vector<MapObject> objects) {
    const Level level = level_of(small_map(std::move(objects)));
    const Simulation simulation(level);
    return shapes_of(simulation);
  };
  const int empty = shapes_with({});
  EXPECT_GT(shapes_with({box_of(20, "fire", {5.0, 2.5}, {1.0, 1.0})}), empty);
  EXPECT_GT(shapes_with({box_of(20, "spikes", {5.0, 2.5}, {1.0, 1.0})}), empty);
  EXPECT_GT(shapes_with({line_of(20, "blade", {{5.0, 5.0}, {6.0, 5.0}})}), empty);
  EXPECT_GT(shapes_with({point_of(20, "coin", {5.0, 5.0})}), empty);
  MapObject chaser = disc_of(20, "chaser", {5.0, 5.0}, 0.5);
  chaser.properties.insert("path", std::int64_t{21});
  EXPECT_GT(shapes_with({chaser, line_of(21, "path", {{5.0, 5.0}, {9.0, 5.0}})}), empty);
  const Level level = level_of(small_map({point_of(20, "coin", {5.0, 2.5}), point_of(21, "coin", {8.0, 9.0})}));
  Simulation simulation(level);
  run(simulation, 40, button_right);
  CountingCanvas canvas;
  View(simulation).draw(canvas, 1.0, {});
  EXPECT_TRUE(canvas.shows_part("coins 1/2"));
  const Level without = level_of(small_map({}));
  const Simulation plain(without);
  CountingCanvas other;
  View(plain).draw(other, 1.0, {});
  EXPECT_FALSE(other.shows_part("coins"));
}

}  // namespace
}  // namespace game
