#include <gtest/gtest.h>

#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/window/sdl_canvas.h"
#include "game/view/backdrop_parts.h"
#include "game/view/view.h"
#include "tests/support/refusal.h"

namespace game {
namespace {

using nlohmann::json;

/// Returns first_swing in another place; empty: without the property.
Level swing_in(const std::string& place) {
  json map = json::parse(std::ifstream(assets_folder() + "/levels/first_swing.tmj"));
  if (!place.empty()) map["properties"].push_back({{"name", "place"}, {"type", "string"}, {"value", place}});
  return level_of(engine::parse_tiled_map(map.dump(), "swing.tmj"));
}

using Pixels = std::vector<std::uint32_t>;

Pixels picture(const Level& level, const ViewOptions& options, int width = 320, int height = 180) {
  const Simulation simulation(level);
  engine::HeadlessCanvas canvas(width, height);
  View(simulation).draw(canvas, 1.0, options);
  return canvas.raster().pixels();
}

TEST(Place, IsReadFromTheLevel) {
  EXPECT_EQ(swing_in("").place, Place::hills);
  for (const Place place : places) EXPECT_EQ(swing_in(std::string(place_name(place))).place, place);
}

TEST(Place, AnUnknownOneIsRefusedWithThoseThatAreAccepted) {
  const std::string sentence = test_support::refusal<engine::MapError>([] { swing_in("moon"); });
  EXPECT_NE(sentence.find("place"), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("moon"), std::string::npos) << sentence;
  for (const Place place : places) EXPECT_NE(sentence.find(place_name(place)), std::string::npos) << sentence;
}

/// A place is a look: the hash of a run does not depend on it.
TEST(Place, HasNoEffectOnARun) {
  const Level hills = swing_in("hills");
  const Level storm = swing_in("storm");
  Simulation a(hills);
  Simulation b(storm);
  for (int k = 0; k < 60; ++k) {
    a.tick({});
    b.tick({});
  }
  EXPECT_EQ(a.hash().combined(), b.hash().combined());
}

TEST(Place, EachHasAPictureOfItsOwnInBothPalettes) {
  std::vector<Pixels> pictures;
  for (const Place place : places) {
    for (const bool safe : {false, true}) {
      ViewOptions options;
      options.colour_safe = safe;
      pictures.push_back(picture(swing_in(std::string(place_name(place))), options));
    }
  }
  for (std::size_t a = 0; a < pictures.size(); ++a)
    for (std::size_t b = a + 1; b < pictures.size(); ++b) EXPECT_NE(pictures[a], pictures[b]) << a << " " << b;
}

/// What a view stores for one size or palette is not drawn in another.
TEST(Place, StoredPicturesFollowTheSizeAndThePalette) {
  for (const Place place : places) {
    const Level level = swing_in(std::string(place_name(place)));
    const Simulation simulation(level);
    View view(simulation);
    engine::HeadlessCanvas canvas(320, 180);
    ViewOptions options;
    const auto expect_fresh = [&](const char* after) {
      view.draw(canvas, 1.0, options);
      EXPECT_EQ(canvas.raster().pixels(), picture(level, options, canvas.width(), canvas.height()))
          << place_name(place) << " " << after;
    };
    expect_fresh("at first");
    expect_fresh("again");
    canvas.resize(480, 270);
    expect_fresh("resize");
    options.colour_safe = true;
    expect_fresh("another palette");
  }
}

/// Drops and strokes of lightning move; with reduced motion there are none.
TEST(Place, AStormIsStillWithReducedMotion) {
  const Level level = swing_in("storm");
  for (const bool reduced : {false, true}) {
    Simulation simulation(level);
    View view(simulation);
    engine::HeadlessCanvas canvas(320, 180);
    ViewOptions options;
    options.reduced_motion = reduced;
    options.hud = false;
    const auto upper_part = [&] {  // without the player, and without ropes
      view.draw(canvas, 1.0, options);
      const Pixels& all = canvas.raster().pixels();
      return Pixels(all.begin(), all.begin() + 320 * 10);
    };
    for (int k = 0; k < 120; ++k) simulation.tick({});
    const Pixels before = upper_part();
    for (int k = 0; k < 20; ++k) simulation.tick({});
    EXPECT_EQ(upper_part() == before, reduced);
  }
}

/// A far layer is drawn only as far as a nearer one does not hide it.
TEST(Backdrop, HiddenPartsOfALayerDoNotChangeThePicture) {
  constexpr Range far{0.9, 0.4, 0.2, 0.6, 0.03, 1};
  constexpr Range near{0.7, 0.2, 0.1, 0.5, 0.01, 2};
  const auto drawn = [&](bool cut) {
    engine::HeadlessCanvas canvas(320, 180);
    canvas.set_view({{20.0, 6.0}, 15.0});
    Pen pen{canvas, palette(false), textures(false, Place::hills)};
    const Outline nearer = outline_of(pen, near);
    draw_range(pen, outline_of(pen, far), {100, 120, 140}, {200, 200, 200}, cut ? nearer.lowest + 1.0 : 180.0);
    draw_range(pen, nearer, {40, 60, 50}, {90, 90, 90}, 180.0);
    return canvas.raster().pixels();
  };
  EXPECT_EQ(drawn(true), drawn(false));
}

TEST(Stamps, AreStoredBySizeAndColour) {
  const engine::Image& glow = textures(false, Place::hills).glow;
  Stamps stamps;
  const engine::Image* const first = &stamps.get(glow, 20, 12, {255, 0, 0, 128}).image;
  EXPECT_EQ(first->width(), 32);
  EXPECT_EQ(first->height(), 16);
  EXPECT_EQ(&stamps.get(glow, 20, 12, {255, 0, 0, 128}).image, first);
  EXPECT_EQ(stamps.count(), 1U);
  stamps.get(glow, 21, 12, {255, 0, 0, 128});
  stamps.get(glow, 20, 12, {255, 0, 0, 129});
  EXPECT_EQ(stamps.count(), 3U);
  for (int k = 0; k < 300; ++k) stamps.get(glow, 1 + k, 4, {255, 255, 255});
  EXPECT_LE(stamps.count(), Stamps::max_count);
}

}  // namespace
}  // namespace game
