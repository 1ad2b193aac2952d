#pragma once

#include <optional>
#include <span>
#include <vector>

#include "ribbon/vec2.h"

namespace game {

/// A rectangle in pixels.
struct Rectangle {
  ribbon::Vec2 corner;  ///< top left
  ribbon::Vec2 size;

  bool operator==(const Rectangle&) const = default;
};

/// Returns the area in px² that both rectangles have.
double shared_area(const Rectangle& a, const Rectangle& b);

/// Finds places on a canvas for boxes of text, so that none covers another one.
class FreeSpace {
 public:
  /// `area`: where boxes may be; `gap`: px between boxes.
  FreeSpace(const Rectangle& area, double gap) : area_(area), gap_(gap) {}

  /// Keeps boxes away from a rectangle.
  void take(const Rectangle& taken) { taken_.push_back(taken); }
  /// Returns the top left corner for a box and takes its place: the first corner of `wanted` that is free, else the
  /// free one that is nearest to the first of them. None if the box fits nowhere. `last`: the index of the corner of
  /// `wanted` in the frame before, which is kept while it is free, so that a box does not jump back and forth.
  std::optional<ribbon::Vec2> place(ribbon::Vec2 size, std::span<const ribbon::Vec2> wanted, int& last);
  const Rectangle& area() const { return area_; }

 private:
  ribbon::Vec2 inside(ribbon::Vec2 corner, ribbon::Vec2 size) const;
  bool is_free(const Rectangle& box, double gap) const;
  std::optional<ribbon::Vec2> nearest_free(ribbon::Vec2 size, ribbon::Vec2 wanted) const;

  Rectangle area_;
  double gap_;
  std::vector<Rectangle> taken_;
};

}  // namespace game
