#pragma once

#include <string>
#include <vector>

#include "game/screens/menu.h"
#include "game/view/free_space.h"

namespace game {

/// A panel with a headline, lines of text and a menu. Lengths are in units of text.
struct Card {
  std::string headline;
  double before_headline = 0.0;      ///< width left free to the left of the headline, for a picture
  std::vector<std::string> lines{};  ///< lines that are too wide for the canvas are broken
  double width = 460.0;              ///< minimum width of the menu
  double text_size = 24.0;           ///< of the menu
  double line_size = 19.0;
  double side = 0.0;    ///< position: −1 at the left edge, 0 in the middle, 1 at the right edge
  bool column = false;  ///< it has the whole height of the canvas at the left edge
};

/// Returns the rectangle of a card's menu of `rows` lines; fewer are visible if the canvas is too low.
MenuPlace menu_place(const engine::Canvas& canvas, double text_scale, const Card& card, int rows);
/// Returns the rectangle of the card in px.
Rectangle card_place(const engine::Canvas& canvas, double text_scale, const Card& card, int rows);
/// Returns the place of a card's headline in px: its left end, and the middle of its height.
ribbon::Vec2 headline_place(const engine::Canvas& canvas, double text_scale, const Card& card, int rows);
/// Draws a card without the menu.
void draw_card(engine::Canvas& canvas, double text_scale, const Card& card, int rows);
/// Darkens the canvas, as a background for a card.
void draw_shade(engine::Canvas& canvas);

/// Returns the keys, or buttons, of menus.
std::string menu_keys(bool pad);
/// Draws a line with keys at the bottom, in the middle of `width` px from the left; 0: of the canvas.
void draw_keys_line(engine::Canvas& canvas, double text_scale, const std::string& keys, double width = 0.0);

}  // namespace game
