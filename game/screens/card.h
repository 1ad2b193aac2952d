#pragma once

#include <string>
#include <vector>

#include "game/screens/menu.h"

namespace game {

/// A panel with a headline, lines of text and a menu. Lengths are in units of text.
struct Card {
  std::string headline;
  std::vector<std::string> lines{};
  double width = 460.0;     ///< minimum width of the menu
  double text_size = 24.0;  ///< of the menu
  double line_size = 19.0;
  double side = 0.0;  ///< position: −1 at the left edge, 0 in the middle, 1 at the right edge
};

/// Returns the rectangle of a card's menu of `rows` lines; fewer are visible if the canvas is too low.
MenuPlace menu_place(const engine::Canvas& canvas, double text_scale, const Card& card, int rows);
/// Draws a card without the menu.
void draw_card(engine::Canvas& canvas, double text_scale, const Card& card, int rows);
/// Darkens the canvas, as a background for a card.
void draw_shade(engine::Canvas& canvas);
/// Draws the keys of menus at the bottom, followed by `more`.
void draw_menu_keys(engine::Canvas& canvas, double text_scale, bool pad, const std::string& more = "");

}  // namespace game
