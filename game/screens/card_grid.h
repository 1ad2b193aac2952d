#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/draw/canvas.h"
#include "engine/draw/image.h"
#include "game/screens/menu_input.h"
#include "game/simulation/medals.h"

namespace game {

/// A card of a grid: a picture with a title and a time below it.
struct PictureCard {
  std::string title;
  std::string time{};  ///< empty: none
  Medal medal = Medal::none;
  const engine::Image* picture = nullptr;  ///< twice as wide as high; null: none yet
};

/// The rectangle of a grid in pixels.
struct GridPlace {
  ribbon::Vec2 top_left;
  ribbon::Vec2 size;
  double scale;  ///< px per unit of text

  int columns() const;
  int rows() const;           ///< that are visible, at least 1
  ribbon::Vec2 cell() const;  ///< px, of a card with its margin
};

/// Cards in rows, of which one has the focus. The focus moves in four directions and wraps around; the grid scrolls to
/// it.
class CardGrid {
 public:
  /// Keeps the index of the focus, clamped to the number of cards.
  void set_cards(std::vector<PictureCard> cards);
  int focus() const { return focus_; }
  void set_focus(int card);
  int size() const { return static_cast<int>(cards_.size()); }

  /// Moves the focus by keys, gamepad and mouse. Returns the card that was chosen, if any.
  std::optional<int> update(const MenuInput& input, const GridPlace& place);
  void draw(engine::Canvas& canvas, const GridPlace& place) const;
  /// Returns whether a card is visible.
  bool shows(int card, const GridPlace& place) const;

 private:
  int first_row(const GridPlace& place) const;
  void move(int right, int down, int columns);
  std::optional<int> card_at(ribbon::Vec2 mouse, const GridPlace& place) const;
  void draw_card(engine::Canvas& canvas, ribbon::Vec2 at, const GridPlace& place, int card) const;
  void draw_scroll_bar(engine::Canvas& canvas, const GridPlace& place) const;

  std::vector<PictureCard> cards_;
  int focus_ = 0;
  int scrolled_ = 0;  // number of rows above the first visible one
};

/// Draws a medal as a disc with a rim; `center` and `radius` in px.
void draw_medal(engine::Canvas& canvas, ribbon::Vec2 center, double radius, Medal medal);

}  // namespace game
