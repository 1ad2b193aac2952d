#pragma once

#include <optional>
#include <vector>

#include "game/view/pen.h"
#include "ribbon/box2d/coupling.h"

namespace game {

/// A cord between two ticks.
struct DrawnCord {
  const ribbon::box2d::Coupling& coupling;
  ribbon::box2d::CordId index;
  ribbon::box2d::CordShape shape;
  const std::vector<ribbon::Vec2>& points;  ///< m
  bool is_line = false;                     ///< the player's line
  double load = 0.0;                        ///< the largest tension of a rope that the player holds, in its weights

  int size() const { return static_cast<int>(points.size()); }
  int point(int i, int j) const { return i * shape.rows + j; }
  ribbon::Vec2 at(int p) const { return points[static_cast<std::size_t>(p)]; }
  ribbon::PointKind kind(int p) const { return coupling.cord(index).kind(p); }
};

/// Returns the colour of a cord without tints.
const engine::Color& own_color(const Pen& pen, const DrawnCord& cord);

/// Returns the strain between two columns, length / rest length − 1, as a mean of all rows.
double strain(const DrawnCord& cord, int column);

/// Returns the largest tension of a rope's links in N; 0 for ribbons and cords of the thesis's solver.
double largest_tension(const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord);

/// The strain with the brightest colour. Colours are a function of its square root, so that 0.1 % is visible.
inline constexpr double max_strain = 0.1;
engine::Color strain_color(double strain);

/// Returns the smooth line through a row of points, m, with `steps` pieces between two columns.
std::vector<ribbon::Vec2> smooth_row(const DrawnCord& cord, int row, int steps);

/// Draws a cord as a rope if it has one row, else as cloth, with its pins and with whipping on free ends. `colors`: one
/// per column; replaces its own colour unless empty.
void draw_cord(Pen& pen, const DrawnCord& cord, const std::vector<engine::Color>& colors);

}  // namespace game
