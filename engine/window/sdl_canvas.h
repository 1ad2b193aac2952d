#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/draw/canvas.h"
#include "engine/draw/canvas_raster.h"

namespace engine {

/// A canvas in memory. It needs no display and no video driver. The same drawing calls give the same bytes in each run.
class HeadlessCanvas : public Canvas {
 public:
  /// Makes a black canvas of width × height pixels, 1 … 16384 each. `font`: path of a TrueType file. Throws
  /// std::invalid_argument for other sizes and std::runtime_error if the font cannot be opened.
  HeadlessCanvas(int width, int height, const std::string& font = default_font());
  ~HeadlessCanvas() override;

  int width() const override { return raster_.width(); }
  int height() const override { return raster_.height(); }
  double text_width(std::string_view utf8, double size) const override;
  double line_height(double size) const override;

  void remember(int key) override;
  bool recall(int key, int rows) override;

  /// Changes the size and clears to black. Throws like the constructor, without a change.
  void resize(int width, int height);
  /// Writes the picture to a PNG file. Throws std::runtime_error with path and reason if it cannot be written.
  void save_png(const std::string& path) const;

  const Raster& raster() const { return raster_; }

  /// The path of DejaVu Sans that was found at build time.
  static std::string default_font();

 protected:
  void paint_background(Color top, Color bottom) override;
  void paint_mesh(const Mesh& mesh, Color color) override;
  void paint_textured(const TexturedMesh& mesh, const Texture& texture, const PixelBox& clip) override;
  void paint_skyline(std::span<const ribbon::Vec2> line, const SkylineLook& look) override;
  void paint_text(ribbon::Vec2 top_left, std::string_view utf8, double size, Color color) override;

 private:
  class Typesetter;

  Raster raster_;
  std::unique_ptr<Typesetter> typesetter_;
  std::optional<int> remembered_key_;
  std::vector<std::uint32_t> remembered_;
};

}  // namespace engine
