#pragma once

#include <string>
#include <vector>

#include "game/screens/menu.h"

namespace game {

/// A panel in the middle of the picture with a headline, lines of text and a menu below each other.
struct Card {
  std::string headline;
  std::vector<std::string> lines{};
  double width = 460.0;     ///< of the menu, at least, in units of text, as are all lengths in a card
  double text_size = 24.0;  ///< of the menu
  double line_size = 19.0;
  double side = 0.0;  ///< −1: at the left edge of the picture; 0: in the middle; 1: at the right one
};

/// Where a card's menu of so many lines stands; it gets fewer if the picture is not high enough.
MenuPlace menu_place(const engine::Canvas& canvas, double text_scale, const Card& card, int rows);
/// Draws all of a card but the menu.
void draw_card(engine::Canvas& canvas, double text_scale, const Card& card, int rows);
/// Darkens the picture a little, so that what comes next stands out.
void draw_shade(engine::Canvas& canvas);
/// A line at the bottom that says which keys work in menus.
void draw_menu_keys(engine::Canvas& canvas, double text_scale, bool pad, const std::string& more = "");

}  // namespace game
