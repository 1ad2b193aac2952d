#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/draw/canvas.h"
#include "engine/draw/canvas_raster.h"

namespace engine {

/// A canvas in memory. It needs no display and no video driver, and the same drawing gives the same bytes in every run.
class HeadlessCanvas : public Canvas {
 public:
  /// Black, width × height pixels, 1 … 16384 each; throws std::invalid_argument otherwise, and std::runtime_error if
  /// the font, a TrueType file, cannot be opened.
  HeadlessCanvas(int width, int height, const std::string& font = default_font());
  ~HeadlessCanvas() override;

  int width() const override { return raster_.width(); }
  int height() const override { return raster_.height(); }
  double text_width(std::string_view utf8, double size) const override;
  double line_height(double size) const override;

  void remember(int key) override;
  bool recall(int key) override;

  /// Black again, in another size. Throws as the constructor does, and then changes nothing.
  void resize(int width, int height);
  /// Writes the picture so far. Throws std::runtime_error naming the path and the reason if it cannot be written.
  void save_png(const std::string& path) const;

  const Raster& raster() const { return raster_; }

  /// The font that was there when this was built: DejaVu Sans.
  static std::string default_font();

 protected:
  void paint_background(Color top, Color bottom) override;
  void paint_mesh(const Mesh& mesh, Color color) override;
  void paint_textured(const TexturedMesh& mesh, const Texture& texture, const PixelBox& clip) override;
  void paint_text(ribbon::Vec2 top_left, std::string_view utf8, double size, Color color) override;

 private:
  class Typesetter;

  Raster raster_;
  std::unique_ptr<Typesetter> typesetter_;
  std::optional<int> remembered_key_;
  std::vector<std::uint32_t> remembered_;
};

}  // namespace engine
