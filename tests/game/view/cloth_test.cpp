#include <gtest/gtest.h>

#include <cstddef>

#include "game/simulation/simulation.h"
#include "game/view/textures.h"
#include "game/view/view.h"
#include "tests/game/view/counting_canvas.h"

namespace game {
namespace {

struct Cloths {
  std::size_t count = 0;
  std::size_t triangles = 0;
};

/// Counts the ribbons and their triangles.
class ClothCanvas : public CountingCanvas {
 public:
  Cloths cloths;

 protected:
  void paint_textured(const engine::TexturedMesh& mesh, const engine::Texture& texture,
                      const engine::PixelBox&) override {
    const bool is_flag = texture.along_v == engine::Wrap::repeat;
    if (texture.image != &textures(false, Place::harbour).cloth || is_flag) return;
    ++cloths.count;
    cloths.triangles += mesh.indices.size() / 3;
  }
};

Cloths drawn_curtains(bool strain_tint) {
  const Level level = load_level("curtains");
  const Simulation simulation(level);
  ViewOptions options;
  options.strain_tint = strain_tint;
  ClothCanvas canvas;
  View(simulation).draw(canvas, 1.0, options);
  return canvas.cloths;
}

/// Curtains that hang at rest are straight, and need few of their smooth pieces.
TEST(Cloth, IsDrawnInPiecesOnlyWhereItBends) {
  const Cloths plain = drawn_curtains(false);
  ASSERT_EQ(plain.count, 4U);
  EXPECT_LT(plain.triangles, plain.count * 60);
  const Cloths coloured = drawn_curtains(true);  // each piece has a colour
  EXPECT_GT(coloured.triangles, plain.count * 200);
}

}  // namespace
}  // namespace game
