#pragma once

#include <string>
#include <vector>

#include "engine/draw/canvas.h"

namespace game {

/// Breaks a text into lines of at most `max_width` px, between words where it can. After `max_lines` the last line ends
/// in "…".
std::vector<std::string> wrapped(const engine::Canvas& canvas, const std::string& text, double size, double max_width,
                                 std::size_t max_lines = 100);

/// Lines of text on a panel. Lengths in px.
struct TextBox {
  std::vector<std::string> lines{};
  double text_size = 16.0;
  engine::Color color{255, 255, 255};
  engine::Align align = engine::Align::left;
  std::string headline{};  ///< above the lines
  double headline_size = 0.0;
  ribbon::Vec2 margin{8.0, 4.0};

  ribbon::Vec2 size(const engine::Canvas& canvas) const;
  void draw(engine::Canvas& canvas, ribbon::Vec2 corner) const;
};

}  // namespace game
