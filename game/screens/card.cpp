#include "game/screens/card.h"

#include <algorithm>

#include "game/screens/style.h"

namespace game {

using engine::Align;
using engine::Canvas;
using ribbon::Vec2;

namespace {

constexpr double margin = 26.0;
constexpr double headline_size = 40.0;
constexpr double outside = 44.0;  // above and below the card, for the line of keys

struct Layout {
  Vec2 corner, size;  // px
  double headline_y, lines_y;
  MenuPlace menu;
};

Layout lay_out(const Canvas& canvas, double scale, const Card& card, int rows) {
  const double headline = card.headline.empty() ? 0.0 : canvas.line_height(headline_size * scale) + 8.0 * scale;
  const double line = canvas.line_height(card.line_size * scale);
  const double lines = line * static_cast<double>(card.lines.size()) + (card.lines.empty() ? 0.0 : 14.0 * scale);
  double width = card.width * scale;
  for (const std::string& text : card.lines) width = std::max(width, canvas.text_width(text, card.line_size * scale));
  MenuPlace menu{{}, width, 0.0, card.text_size * scale};
  const double fixed = headline + lines + 1.6 * margin * scale;
  const double available = canvas.height() - 2.0 * outside * scale - fixed;
  menu.height = menu.row_height() * std::clamp(static_cast<int>(available / menu.row_height()), 1, std::max(rows, 1));
  if (rows == 0) menu.height = 0.0;
  menu.height += 1e-6;  // rounding must not remove a row
  const Vec2 size{width + 2.0 * margin * scale, fixed + menu.height};
  const double aside = 0.5 * (canvas.width() - size.x);
  const Vec2 corner{aside + card.side * std::max(aside - 24.0 * scale, 0.0), 0.5 * (canvas.height() - size.y)};
  const double top = corner.y + 0.8 * margin * scale;
  menu.top_left = {corner.x + margin * scale, top + headline + lines};
  return {corner, size, top, top + headline, menu};
}

}  // namespace

MenuPlace menu_place(const Canvas& canvas, double text_scale, const Card& card, int rows) {
  return lay_out(canvas, text_scale, card, rows).menu;
}

void draw_card(Canvas& canvas, double text_scale, const Card& card, int rows) {
  const Layout place = lay_out(canvas, text_scale, card, rows);
  canvas.panel(place.corner, place.size, 16.0 * text_scale, style::paper);
  const double middle = place.corner.x + 0.5 * place.size.x;
  canvas.text({middle, place.headline_y}, card.headline, headline_size * text_scale, style::gold, Align::center);
  double y = place.lines_y;
  for (const std::string& line : card.lines) {
    canvas.text({middle, y}, line, card.line_size * text_scale, style::faint, Align::center);
    y += canvas.line_height(card.line_size * text_scale);
  }
}

void draw_shade(Canvas& canvas) {
  canvas.panel({0.0, 0.0}, {1.0 * canvas.width(), 1.0 * canvas.height()}, 0.0, style::shade);
}

void draw_menu_keys(Canvas& canvas, double text_scale, bool pad, const std::string& more) {
  const std::string keys =
      (pad ? "D-pad: choose and change   A: go   B: back" : "↑ ↓ choose   ← → change   Enter: go   Esc: back") + more;
  const double size = 16.0 * text_scale;
  const Vec2 box{canvas.text_width(keys, size) + 2.0 * size, canvas.line_height(size) + 0.5 * size};
  const Vec2 corner{0.5 * (canvas.width() - box.x), canvas.height() - box.y - 6.0 * text_scale};
  canvas.panel(corner, box, 0.5 * size, style::paper);
  canvas.text(corner + Vec2{size, 0.25 * size}, keys, size, style::faint);
}

}  // namespace game
