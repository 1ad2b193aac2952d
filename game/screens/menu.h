#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/draw/canvas.h"
#include "game/screens/menu_input.h"

namespace game {

struct MenuItem {
  std::string label;
  std::string value{};      ///< at the right; empty: none
  bool adjustable = false;  ///< left and right change the value
};

/// The rectangle of a menu in pixels.
struct MenuPlace {
  ribbon::Vec2 top_left;
  double width;
  double height;  ///< of all visible lines
  double text_size;

  double row_height() const { return 1.75 * text_size; }
  int rows() const;
};

/// A choice of the player in a menu.
struct MenuChoice {
  int item;
  int step;  ///< ±1: the value was changed; 0: the line was chosen

  bool operator==(const MenuChoice&) const = default;
};

/// A list of lines of which one has the focus. Up and down wrap around; a long list scrolls.
class Menu {
 public:
  /// Keeps the index of the focus, clamped to the number of lines.
  void set_items(std::vector<MenuItem> items);
  const std::vector<MenuItem>& items() const { return items_; }
  int focus() const { return focus_; }
  void set_focus(int item);

  /// Moves the focus by keys, gamepad and mouse, and returns the choice, if any. For an adjustable line, accept and
  /// click are steps to the right, and a click on its left arrow is a step to the left.
  std::optional<MenuChoice> update(const MenuInput& input, const MenuPlace& place);
  void draw(engine::Canvas& canvas, const MenuPlace& place) const;

 private:
  int first_shown(const MenuPlace& place) const;
  std::optional<int> item_at(ribbon::Vec2 mouse, const MenuPlace& place) const;
  void draw_row(engine::Canvas& canvas, ribbon::Vec2 at, const MenuPlace& place, int item) const;
  int size() const { return static_cast<int>(items_.size()); }

  std::vector<MenuItem> items_;
  int focus_ = 0;
  int scrolled_ = 0;  // number of lines above the first visible one
};

}  // namespace game
