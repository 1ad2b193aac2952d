#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "engine/draw/canvas.h"

namespace game {

/// Records the texts and counts the shapes that are drawn, without a picture.
class CountingCanvas : public engine::Canvas {
 public:
  int width() const override { return 1280; }
  int height() const override { return 720; }
  double text_width(std::string_view utf8, double size) const override {
    return 0.5 * size * static_cast<double>(utf8.size());
  }
  double line_height(double size) const override { return size; }
  bool shows(std::string_view text) const { return std::find(texts.begin(), texts.end(), text) != texts.end(); }
  /// Returns whether a text contains this one.
  bool shows_part(std::string_view part) const {
    return std::any_of(texts.begin(), texts.end(),
                       [part](const std::string& text) { return text.find(part) != std::string::npos; });
  }

  int shapes = 0;
  std::vector<std::string> texts;

 protected:
  void paint_background(engine::Color, engine::Color) override {}
  void paint_mesh(const engine::Mesh&, engine::Color) override { ++shapes; }
  void paint_textured(const engine::TexturedMesh&, const engine::Texture&, const engine::PixelBox&) override {}
  void paint_text(ribbon::Vec2, std::string_view utf8, double, engine::Color) override { texts.emplace_back(utf8); }
};

}  // namespace game
