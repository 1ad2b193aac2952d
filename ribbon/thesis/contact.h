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

NearestPoint nearest_on_segment(Vec2 c, Vec2 a, Vec2 b);
/// T_c of Goto 2017, section 3.6, for c outside the triangle; the triangle may be turned over or have no area.
NearestPoint nearest_on_triangle_edges(Vec2 c, const std::array<Vec2, 3>& corners);
/// True if c lies in the triangle or on its edge; never for a triangle without area.
bool is_inside(Vec2 c, const std::array<Vec2, 3>& corners);

/// A circle that overlaps the cord.
struct Contact {
  Vec2 direction;                ///< unit vector along which the circle leaves the cord
  double depth;                  ///< m, above 0: how far it has to go
  std::array<int, 3> point;      ///< the cord's points that take the reaction
  std::array<double, 3> weight;  ///< and their shares of it, summing to 1
};

/// One circle as the contact search sees it.
struct Circle {
  Vec2 center;
  Vec2 center_before;  ///< at the start of the substep: tells from which side it came where two ways out tie
  double radius;       ///< m
  int point = -1;      ///< the cord's point that the circle belongs to; −1 for a rigid circle
};

/// Tests a circle against one triangle (Goto 2017, Eqs. 3.22–3.25, with depth r − |C − T_c|, positive in contact).
/// A centre inside the triangle leaves the cord through the nearest point of its outer boundary, boundary edges
/// within 2 columns of the circle's own point left out.
std::optional<Contact> find_contact(const Mesh& mesh, const Triangle& triangle, std::span<const Vec2> positions,
                                    const Circle& circle);

/// Eqs. 3.26 and 3.27 with the weights as masses, m_c = 1/w_c and m_t = 1/Σ b_j²·w_j, each side moving by the
/// other's share: moves the cord's points by −λ·b_j·w_j·d and returns λ [kg·m]; the circle is the caller's to move by
/// λ·w_c·d. At most `max_push` metres of the depth are resolved at a time. 0 if neither side can move.
double push_apart(const Contact& contact, double inverse_mass_circle, double max_push,
                  std::span<const double> inverse_mass, std::span<Vec2> positions);

}  // namespace ribbon
