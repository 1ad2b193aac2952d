#include "game/view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/support/mixed_level.h"

namespace game {
namespace {

/// Remembers the texts, and how many shapes there were.
class RecordingCanvas : public engine::Canvas {
 public:
  int width() const override { return 1280; }
  int height() const override { return 720; }
  double text_width(std::string_view utf8, double size) const override {
    return 0.5 * size * static_cast<double>(utf8.size());
  }
  double line_height(double size) const override { return size; }

  bool shows(const std::string& text) const { return std::find(texts.begin(), texts.end(), text) != texts.end(); }

  std::vector<std::string> texts;
  int shapes = 0;

 protected:
  void paint_background(engine::Color, engine::Color) override {}
  void paint_mesh(const engine::Mesh&, engine::Color) override { ++shapes; }
  void paint_textured(const engine::TexturedMesh&, const engine::Texture&, const engine::PixelBox&) override {}
  void paint_text(ribbon::Vec2, std::string_view utf8, double, engine::Color) override { texts.emplace_back(utf8); }
};

void draw(RecordingCanvas& canvas, const Level& level, bool debug) {
  Simulation simulation(level);
  for (int k = 0; k < 3; ++k) simulation.tick({});
  ViewOptions options;
  options.debug = debug;
  View(simulation).draw(canvas, 0.5, options);
}

TEST(View, ShowsTheCountsOfEachSolverThatIsThere) {
  RecordingCanvas mixed;
  draw(mixed, test_support::mixed_swing(), true);
  EXPECT_TRUE(mixed.shows("tangled"));
  EXPECT_TRUE(mixed.shows("iterations"));
  EXPECT_TRUE(mixed.shows("unconverged in all"));
  EXPECT_TRUE(mixed.shows("82"));  // points of a cord of the thesis's
  EXPECT_TRUE(mixed.shows("41"));  // and of the hammock
  RecordingCanvas direct;
  draw(direct, load_level("first_swing"), true);
  EXPECT_TRUE(direct.shows("iterations"));
  EXPECT_TRUE(direct.shows("impacts in all"));
  EXPECT_FALSE(direct.shows("tangled"));
  RecordingCanvas playing;
  draw(playing, test_support::mixed_swing(), false);
  EXPECT_FALSE(playing.shows("iterations"));
}

TEST(View, ShowsANotice) {
  const Level level = load_level("first_swing");
  const Simulation simulation(level);
  RecordingCanvas canvas;
  ViewOptions options;
  options.notice = "The recording has ended";
  View(simulation).draw(canvas, 1.0, options);
  EXPECT_TRUE(canvas.shows("The recording has ended"));
}

/// Each point, and each bar between two of them.
TEST(View, TheDebugViewDrawsThePointsAndBarsOfEitherSolver) {
  const auto more_in_debug = [](const Level& level) {
    RecordingCanvas playing;
    RecordingCanvas debug;
    draw(playing, level, false);
    draw(debug, level, true);
    return debug.shapes - playing.shapes;
  };
  constexpr int counts_panel = 1;
  const int thesis_cord = 41 * 2 + (41 + 40 * 2 + 40 * 2);  // points; bars across, along and the other way
  const int rope = 41 + 40;
  EXPECT_EQ(more_in_debug(load_level("first_swing")), counts_panel + 4 * rope);
  EXPECT_EQ(more_in_debug(test_support::mixed_swing()), counts_panel + rope + 3 * thesis_cord);
}

}  // namespace
}  // namespace game
