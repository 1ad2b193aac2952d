#pragma once

#include <optional>
#include <vector>

#include "game/view/pen.h"
#include "ribbon/box2d/coupling.h"

namespace game {

/// A cord at a moment between two ticks.
struct DrawnCord {
  const ribbon::box2d::Coupling& coupling;
  ribbon::box2d::CordId index;
  ribbon::box2d::CordShape shape;
  const std::vector<ribbon::Vec2>& points;  ///< m
  bool is_line = false;                     ///< the player's own

  int size() const { return static_cast<int>(points.size()); }
  int point(int i, int j) const { return i * shape.rows + j; }
  ribbon::Vec2 at(int p) const { return points[static_cast<std::size_t>(p)]; }
  ribbon::PointKind kind(int p) const { return coupling.cord(index).kind(p); }
};

/// By how much the cord is longer between two columns than at rest, as a share, in the middle of its rows.
double strain(const DrawnCord& cord, int column);

/// The strain that has the brightest colour, as a share; colours go by its square root, so that a per mille is seen.
inline constexpr double most_strain = 0.1;
engine::Color strain_color(double strain);

/// A rope, if the cord has one row of points, and else a cloth; what holds it, and whipping on its loose ends.
/// `colors`, one a column, if it is not to have its own.
void draw_cord(Pen& pen, const DrawnCord& cord, const std::vector<engine::Color>& colors);

}  // namespace game
