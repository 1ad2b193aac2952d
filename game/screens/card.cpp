#include "game/screens/card.h"

#include <algorithm>

#include "game/screens/style.h"
#include "game/view/hud.h"
#include "game/view/text_box.h"
#include "game/words/words.h"

namespace game {

using engine::Align;
using engine::Canvas;
using ribbon::Vec2;

namespace {

constexpr double inner_margin = 26.0;
constexpr double headline_size = 40.0;
constexpr double outside = notice_strip;  // above and below the card: for a notice and for the line of keys
constexpr double arrow = 14.0;            // above and below a menu that scrolls
constexpr double beside_card = 12.0;      // at least, left and right of the card

struct Layout {
  Vec2 corner, size;  // px
  double headline_y, lines_y;
  std::vector<std::string> lines;
  MenuPlace menu;
};

Layout lay_out(const Canvas& canvas, double scale, const Card& card, int rows) {
  const double most = canvas.width() - 2.0 * (inner_margin + beside_card) * scale;
  std::vector<std::string> lines;
  for (const std::string& text : card.lines) {
    for (std::string& line : wrapped(canvas, text, card.line_size * scale, card.column ? card.width * scale : most)) {
      lines.push_back(std::move(line));
    }
  }
  const double headline = card.headline.empty() ? 0.0 : canvas.line_height(headline_size * scale) + 8.0 * scale;
  const double line = canvas.line_height(card.line_size * scale);
  const double text = line * static_cast<double>(lines.size()) + (lines.empty() ? 0.0 : arrow * scale);
  const double title = canvas.text_width(card.headline, headline_size * scale) + card.before_headline * scale;
  double width = std::max(card.width * scale, title);
  for (const std::string& each : lines) width = std::max(width, canvas.text_width(each, card.line_size * scale));
  width = std::min(width, most);
  MenuPlace menu{{}, width, 0.0, card.text_size * scale};
  const double fixed = headline + text + 1.6 * inner_margin * scale;
  const double available = canvas.height() - 2.0 * outside * scale - fixed;
  menu.height = menu.row_height() * std::clamp(static_cast<int>(available / menu.row_height()), 1, std::max(rows, 1));
  if (rows == 0) menu.height = 0.0;
  menu.height += 1e-6;  // rounding must not remove a row
  Vec2 size{width + 2.0 * inner_margin * scale, fixed + menu.height};
  const double aside = 0.5 * (canvas.width() - size.x);
  Vec2 corner{aside + card.side * std::max(aside - beside_card * scale, 0.0), 0.5 * (canvas.height() - size.y)};
  const double top = corner.y + 0.8 * inner_margin * scale;
  if (card.column) {
    corner = {};
    size.y = canvas.height();
  }
  menu.top_left = {corner.x + inner_margin * scale, top + headline + text};
  return {corner, size, top, top + headline, std::move(lines), menu};
}

}  // namespace

MenuPlace menu_place(const Canvas& canvas, double text_scale, const Card& card, int rows) {
  return lay_out(canvas, text_scale, card, rows).menu;
}

Rectangle card_place(const Canvas& canvas, double text_scale, const Card& card, int rows) {
  const Layout place = lay_out(canvas, text_scale, card, rows);
  return {place.corner, place.size};
}

Vec2 headline_place(const Canvas& canvas, double text_scale, const Card& card, int rows) {
  const Layout place = lay_out(canvas, text_scale, card, rows);
  const double size = headline_size * text_scale;
  const double middle = place.corner.x + 0.5 * (place.size.x + card.before_headline * text_scale);
  return {middle - 0.5 * canvas.text_width(card.headline, size), place.headline_y + 0.5 * canvas.line_height(size)};
}

void draw_card(Canvas& canvas, double text_scale, const Card& card, int rows) {
  const Layout place = lay_out(canvas, text_scale, card, rows);
  canvas.panel(place.corner, place.size, card.column ? 0.0 : 16.0 * text_scale, style::card);
  const double middle = place.corner.x + 0.5 * place.size.x;
  const double headline = middle + 0.5 * card.before_headline * text_scale;
  canvas.text({headline, place.headline_y}, card.headline, headline_size * text_scale, style::gold, Align::center);
  double y = place.lines_y;
  for (const std::string& line : place.lines) {
    canvas.text({middle, y}, line, card.line_size * text_scale, style::faint, Align::center);
    y += canvas.line_height(card.line_size * text_scale);
  }
}

void draw_shade(Canvas& canvas) {
  canvas.panel({0.0, 0.0}, {1.0 * canvas.width(), 1.0 * canvas.height()}, 0.0, style::shade);
}

std::string menu_keys(bool pad) { return pad ? words::menu_buttons : words::menu_keys; }

void draw_keys_line(Canvas& canvas, double text_scale, const std::string& keys, double width) {
  const double size = 16.0 * text_scale;
  const double whole = width > 0.0 ? width : 1.0 * canvas.width();
  const Vec2 box{canvas.text_width(keys, size) + 2.0 * size, canvas.line_height(size) + 0.5 * size};
  const Vec2 corner{0.5 * (whole - box.x), canvas.height() - box.y - 6.0 * text_scale};
  canvas.panel(corner, box, 0.5 * size, style::card);
  canvas.text(corner + Vec2{size, 0.25 * size}, keys, size, style::faint);
}

}  // namespace game
