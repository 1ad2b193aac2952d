#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "engine/window/sdl_canvas.h"
#include "game/view/free_space.h"

namespace game {

constexpr std::int64_t frame_ns = 16'666'668;  // slightly more than a tick

/// The size of a canvas, as the parameter of tests.
struct CanvasSize {
  int width, height;  ///< px
};

/// Returns the name of such a parameter, as 640x360.
inline std::string size_name(const testing::TestParamInfo<CanvasSize>& size) {
  return std::to_string(size.param.width) + "x" + std::to_string(size.param.height);
}

/// A canvas that records the boxes of the texts and panels that are drawn on it, in order.
class TextCanvas : public engine::HeadlessCanvas {
 public:
  using HeadlessCanvas::HeadlessCanvas;

  void forget() { drawn_.clear(); }
  /// All texts, one per line.
  std::string all() const {
    std::string texts;
    for (const Drawn& each : drawn_) {
      if (!each.is_panel) (texts += each.text) += '\n';
    }
    return texts;
  }

  /// The box of the text that was drawn last with these words; none if it was not drawn.
  Rectangle place_of(const std::string& words) const {
    Rectangle place{};
    for (const Drawn& each : drawn_) {
      if (!each.is_panel && each.text == words) place = each.box;
    }
    return place;
  }

  /// The texts that share pixels with a rectangle.
  std::string texts_in(const Rectangle& place) const {
    std::string texts;
    for (const Drawn& each : drawn_) {
      if (!each.is_panel && shared_area(each.box, place) > 0.0) (texts += each.text) += '\n';
    }
    return texts;
  }

  /// The right edge of the panels that begin at the left edge of the canvas, px.
  double last_panel_at_left() const {
    double edge = 0.0;
    for (const Drawn& each : drawn_) {
      if (each.is_panel && each.box.corner.x <= 0.0) edge = std::max(edge, each.box.size.x);
    }
    return edge;
  }

  /// Returns what is wrong with the texts: two that overlap, one that a panel hides, one that its panel or the edge of
  /// the canvas cuts. `world`: texts of the level, which the edge of the canvas may cut. `covered_by_menu`: those that
  /// a panel of a menu may hide. The panel with
  /// parameters, which the user can move, may hide texts of the world.
  std::string faults(const std::set<std::string>& world = {}, bool covered_by_menu = false) const {
    std::string found;
    for (std::size_t k = 0; k < drawn_.size(); ++k) {
      if (drawn_[k].is_panel) continue;
      const bool of_world = world.contains(drawn_[k].text) || is_mass(drawn_[k].text);
      const bool hidden = is_hidden(k, of_world && !covered_by_menu);
      if (hidden && !(covered_by_menu && of_world)) found += "hidden by a panel: " + drawn_[k].text + '\n';
      if (hidden) continue;
      if (!of_world && is_cut(k)) found += "cut: " + drawn_[k].text + '\n';
      for (std::size_t other = k + 1; other < drawn_.size(); ++other) {
        if (drawn_[other].is_panel || !overlap(k, other)) continue;
        if (of_world && is_mass(drawn_[other].text)) continue;  // a body that moves before a sign
        found += "overlap: " + drawn_[k].text + " | " + drawn_[other].text + '\n';
      }
    }
    return found;
  }

  void panel(ribbon::Vec2 top_left, ribbon::Vec2 size, double corner_radius, engine::Color color) override {
    HeadlessCanvas::panel(top_left, size, corner_radius, color);
    const bool whole = size.x >= width() && size.y >= height();
    if (!whole) drawn_.push_back({true, "", {top_left, size}});
  }

 protected:
  void paint_text(ribbon::Vec2 at, std::string_view utf8, double size, engine::Color color) override {
    HeadlessCanvas::paint_text(at, utf8, size, color);
    drawn_.push_back({false, std::string(utf8), {at, {text_width(utf8, size), line_height(size)}}});
  }
  /// The panel with parameters is the only one that clips.
  void paint_textured(const engine::TexturedMesh& mesh, const engine::Texture& texture,
                      const engine::PixelBox& clip) override {
    HeadlessCanvas::paint_textured(mesh, texture, clip);
    if (clip.left == std::numeric_limits<int>::min()) return;
    const auto [low, high] = std::minmax_element(mesh.vertices.begin(), mesh.vertices.end(),
                                                 [](const auto& a, const auto& b) { return a.at.x < b.at.x; });
    const auto [top, bottom] = std::minmax_element(mesh.vertices.begin(), mesh.vertices.end(),
                                                   [](const auto& a, const auto& b) { return a.at.y < b.at.y; });
    const ribbon::Vec2 corner{std::max(low->at.x, 1.0 * clip.left), std::max(top->at.y, 1.0 * clip.top)};
    const ribbon::Vec2 end{std::min(high->at.x, 1.0 * clip.right), std::min(bottom->at.y, 1.0 * clip.bottom)};
    drawn_.push_back({true, parameters, {corner, end - corner}});
  }

 private:
  struct Drawn {
    bool is_panel;
    std::string text;
    Rectangle box;
  };

  static constexpr const char* parameters = "parameters";  // the name of the panel with them
  static constexpr double tolerance = 1.0;                 // px, for positions that are rounded

  /// The mass of a body is a text of the world too.
  static bool is_mass(const std::string& text) { return text.ends_with(" kg") || text.ends_with(" t"); }
  static Rectangle narrowed(const Rectangle& box) {
    return {box.corner + ribbon::Vec2{tolerance, tolerance}, box.size - ribbon::Vec2{2.0 * tolerance, 2.0 * tolerance}};
  }
  bool is_hidden(std::size_t text, bool may_be_below_parameters) const {
    return std::any_of(drawn_.begin() + static_cast<std::ptrdiff_t>(text), drawn_.end(), [&](const Drawn& later) {
      if (may_be_below_parameters && later.text == parameters) return false;
      return later.is_panel && shared_area(narrowed(drawn_[text].box), later.box) > 0.0;
    });
  }
  static bool contains(const Rectangle& outer, const Rectangle& inner) {
    return inner.corner.x >= outer.corner.x && inner.corner.y >= outer.corner.y &&
           inner.corner.x + inner.size.x <= outer.corner.x + outer.size.x &&
           inner.corner.y + inner.size.y <= outer.corner.y + outer.size.y;
  }
  bool is_cut(std::size_t text) const {
    const Rectangle box = narrowed(drawn_[text].box);
    if (!contains({{}, {1.0 * width(), 1.0 * height()}}, box)) return true;
    const Rectangle middle{box.corner + 0.5 * box.size, {0.5, 0.5}};
    for (std::size_t k = text; k-- > 0;) {
      if (drawn_[k].is_panel && shared_area(drawn_[k].box, middle) > 0.0) return !contains(drawn_[k].box, box);
    }
    return false;
  }
  bool overlap(std::size_t a, std::size_t b) const {
    const ribbon::Vec2 apart = drawn_[a].box.corner - drawn_[b].box.corner;
    if (drawn_[a].text == drawn_[b].text && length(apart) < 3.0) return false;  // a text and its shadow
    return shared_area(narrowed(drawn_[a].box), narrowed(drawn_[b].box)) > 0.0;
  }

  std::vector<Drawn> drawn_;
};

}  // namespace game
