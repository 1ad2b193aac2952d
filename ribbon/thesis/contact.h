#pragma once

#include <array>
#include <optional>
#include <span>

#include "ribbon/thesis/mesh.h"

namespace ribbon {

/// The point of a triangle or segment nearest to another point.
struct NearestPoint {
  Vec2 point;
  std::array<double, 3> weight;  ///< barycentric: point = Σ weight·corner
};

/// Returns the point of the segment from a to b that is nearest to c.
NearestPoint nearest_on_segment(Vec2 c, Vec2 a, Vec2 b);
/// Returns the point of the edges of a triangle that is nearest to c: T_c of Goto 2017, section 3.6, for c outside the
/// triangle. The triangle may be inverted or have no area.
NearestPoint nearest_on_triangle_edges(Vec2 c, const std::array<Vec2, 3>& corners);
/// Returns whether c is in the triangle or on its edge. False for a triangle without area.
bool is_inside(Vec2 c, const std::array<Vec2, 3>& corners);

/// A circle that overlaps the cord.
struct Contact {
  Vec2 direction;                ///< unit vector along which the circle leaves the cord
  double depth;                  ///< m, above 0: penetration along `direction`
  std::array<int, 3> point;      ///< points of the cord that take the reaction
  std::array<double, 3> weight;  ///< their shares of the reaction; the sum is 1
};

/// A circle in the contact search.
struct Circle {
  Vec2 center;
  Vec2 center_before;  ///< at the start of the substep: chooses between two equally near exits
  double radius;       ///< m
  int point = -1;      ///< point of the cord that the circle belongs to; −1 for a rigid circle
};

/// Tests a circle against one triangle: Goto 2017, Eqs. 3.22–3.24, with the depth r − |C − T_c|, positive in contact. A
/// centre inside the triangle leaves the cord through the nearest point of the outer boundary, except for boundary
/// edges within 2 columns of the circle's own point.
std::optional<Contact> find_contact(const Mesh& mesh, const Triangle& triangle, std::span<const Vec2> positions,
                                    const Circle& circle);

/// Radii of what is pushed, the most that a contact moves it by in a substep. More would throw a crumpled cord apart.
inline constexpr double max_push_in_radii = 0.5;

/// Resolves at most `max_push` [m] of a contact: Eqs. 3.25–3.27 with the weights as masses, m_c = 1/w_c and
/// m_t = 1/Σ b_j²·w_j, each side moving by the other's share. Moves the points of the cord by −λ·b_j·w_j·d and returns
/// λ [kg·m]; the caller moves the circle by λ·w_c·d. Returns 0 if neither side can move.
double push_apart(const Contact& contact, double inverse_mass_circle, double max_push,
                  std::span<const double> inverse_mass, std::span<Vec2> positions);

}  // namespace ribbon
