#include "game/view/text_box.h"

#include <algorithm>

#include "game/view/hud_style.h"

namespace game {

using engine::Align;
using engine::Canvas;
using ribbon::Vec2;

namespace {

constexpr const char* cut_off = "…";

/// Returns the number of bytes of the longest start of the text that is at most `max_width` px wide, at least one
/// letter.
std::size_t fitting_bytes(const Canvas& canvas, const std::string& text, double size, double max_width) {
  std::size_t fits = 0;
  for (std::size_t end = 1; end <= text.size(); ++end) {
    const bool inside_letter = end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U;
    if (inside_letter) continue;
    if (fits > 0 && canvas.text_width(text.substr(0, end), size) > max_width) break;
    fits = end;
  }
  return fits;
}

}  // namespace

std::vector<std::string> wrapped(const Canvas& canvas, const std::string& text, double size, double max_width,
                                 std::size_t max_lines) {
  std::vector<std::string> lines;
  std::string rest = text;
  while (!rest.empty()) {
    if (canvas.text_width(rest, size) <= max_width) {
      lines.push_back(rest);
      break;
    }
    std::size_t end = fitting_bytes(canvas, rest, size, max_width);
    if (lines.size() + 1 == max_lines) {
      const double room = max_width - canvas.text_width(cut_off, size);
      lines.push_back(rest.substr(0, fitting_bytes(canvas, rest, size, room)) + cut_off);
      break;
    }
    const std::size_t space = rest.rfind(' ', end);
    if (space != std::string::npos && space > 0) end = space;
    lines.push_back(rest.substr(0, end));
    rest.erase(0, rest.find_first_not_of(' ', end));
  }
  return lines;
}

Vec2 TextBox::size(const Canvas& canvas) const {
  double width = headline.empty() ? 0.0 : canvas.text_width(headline, headline_size);
  for (const std::string& line : lines) width = std::max(width, canvas.text_width(line, text_size));
  double height = canvas.line_height(text_size) * static_cast<double>(lines.size());
  if (!headline.empty()) height += canvas.line_height(headline_size);
  return Vec2{width, height} + 2.0 * margin;
}

void TextBox::draw(Canvas& canvas, Vec2 corner) const {
  const Vec2 box = size(canvas);
  canvas.panel(corner, box, std::min(0.5 * text_size, 0.5 * box.y), hud_style::paper);
  const double left = align == Align::center ? 0.5 * box.x : align == Align::right ? box.x - margin.x : margin.x;
  Vec2 at = corner + Vec2{left, margin.y};
  canvas.text(at, headline, headline_size, hud_style::gold, align);
  if (!headline.empty()) at.y += canvas.line_height(headline_size);
  for (const std::string& line : lines) {
    canvas.text(at, line, text_size, color, align);
    at.y += canvas.line_height(text_size);
  }
}

}  // namespace game
