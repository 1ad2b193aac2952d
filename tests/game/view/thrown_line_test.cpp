// The thrown line in a picture of a recorded run.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "engine/replay/replay.h"
#include "game/view/figure_state.h"
#include "game/view/view.h"

namespace game {
namespace {

using ribbon::Vec2;

/// Records the corners of what is drawn in the colour of the player's line, in m.
class LineCanvas : public engine::Canvas {
 public:
  int width() const override { return 1280; }
  int height() const override { return 720; }
  double text_width(std::string_view, double) const override { return 0.0; }
  double line_height(double size) const override { return size; }

  /// Returns the distance from the middle of the nearest end or joint of the line.
  double distance(Vec2 p) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < corners.size(); ++k)
      for (std::size_t other = k + 1; other < std::min(k + 4, corners.size()); ++other)
        nearest = std::min(nearest, length(0.5 * (corners[k] + corners[other]) - p));
    return nearest;
  }

  std::vector<Vec2> corners;

 protected:
  void paint_background(engine::Color, engine::Color) override {}
  void paint_mesh(const engine::Mesh&, engine::Color) override {}
  void paint_text(Vec2, std::string_view, double, engine::Color) override {}
  void paint_textured(const engine::TexturedMesh& mesh, const engine::Texture&, const engine::PixelBox&) override {
    if (mesh.vertices.empty() || mesh.vertices.front().color != palette(false, Place::storm).line)
      return;  // that of the level
    for (const engine::TexturedVertex& vertex : mesh.vertices) corners.push_back(to_world(vertex.at));
  }
};

TEST(ThrownLineInAPicture, FliesFromTheDrawnHand) {
  const engine::Replay replay = engine::load_replay(assets_folder() + "/replays/long_line.replay");
  const Level level = load_level("long_line");
  Simulation simulation(level);
  View view(simulation);
  int flying = 0;
  for (const engine::RecordedTick& tick : replay.ticks) {
    simulation.tick(tick.input);
    if (simulation.player().line().state() != Line::State::flying) continue;
    ++flying;
    LineCanvas canvas;
    view.draw(canvas, 1.0, {});
    const double time = 1.0 * simulation.run_ticks() / ticks_per_second;
    const Pose pose = pose_of(figure_of(simulation, simulation.current(), time));
    EXPECT_LT(std::min(canvas.distance(pose.hand[0]), canvas.distance(pose.hand[1])), 0.02) << simulation.ticks();
  }
  EXPECT_GT(flying, 20);
}

}  // namespace
}  // namespace game
