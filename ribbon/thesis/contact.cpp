#include "ribbon/thesis/contact.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <utility>

#include "ribbon/linear/index.h"

namespace ribbon {
namespace {

constexpr int own_columns = 2;  // a point does not leave the cord through boundary edges this near to its own column

/// Returns the unit normal of the boundary edge a → b that points out of the cord: the boundary is counter-clockwise.
Vec2 outward_normal(Vec2 a, Vec2 b) {
  const Vec2 edge = b - a;
  const double size = length(edge);
  return size > 0.0 ? (1.0 / size) * -perp(edge) : Vec2{0.0, 1.0};
}

bool is_own_edge(const Mesh& mesh, int a, int b, int point) {
  if (point < 0) return false;
  const int column = mesh.column(point);
  return std::abs(mesh.column(a) - column) <= own_columns || std::abs(mesh.column(b) - column) <= own_columns;
}

/// Returns the contact of a circle with its centre inside the cord; none if all boundary edges are its own.
std::optional<Contact> find_exit(const Mesh& mesh, std::span<const Vec2> positions, const Circle& circle) {
  std::optional<Contact> best;
  double best_distance = std::numeric_limits<double>::infinity();
  double best_travel = std::numeric_limits<double>::infinity();
  int a = mesh.boundary.back();
  for (const int b : mesh.boundary) {
    const int start = std::exchange(a, b);
    if (is_own_edge(mesh, start, b, circle.point)) continue;
    const NearestPoint q = nearest_on_segment(circle.center, positions[at(start)], positions[at(b)]);
    const double distance = length(q.point - circle.center);
    const double travel = length(q.point - circle.center_before);
    const bool nearer = distance < best_distance || (distance == best_distance && travel < best_travel);
    if (!nearer) continue;
    best_distance = distance;
    best_travel = travel;
    const Vec2 direction = distance > 0.0 ? (1.0 / distance) * (q.point - circle.center)
                                          : outward_normal(positions[at(start)], positions[at(b)]);
    best = Contact{direction, circle.radius + distance, {start, b, b}, {q.weight[0], q.weight[1], 0.0}};
  }
  return best;
}

}  // namespace

NearestPoint nearest_on_segment(Vec2 c, Vec2 a, Vec2 b) {
  const Vec2 ab = b - a;
  const double size2 = dot(ab, ab);
  const double s = size2 > 0.0 ? std::clamp(dot(c - a, ab) / size2, 0.0, 1.0) : 0.0;
  return {a + s * ab, {1.0 - s, s, 0.0}};
}

NearestPoint nearest_on_triangle_edges(Vec2 c, const std::array<Vec2, 3>& corners) {
  NearestPoint best{};
  double best_distance2 = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const NearestPoint on_edge = nearest_on_segment(c, corners[k], corners[next]);
    const double distance2 = dot(on_edge.point - c, on_edge.point - c);
    if (distance2 >= best_distance2) continue;
    best_distance2 = distance2;
    best.point = on_edge.point;
    best.weight = {};
    best.weight[k] = on_edge.weight[0];
    best.weight[next] = on_edge.weight[1];
  }
  return best;
}

bool is_inside(Vec2 c, const std::array<Vec2, 3>& corners) {
  const double turn_0 = cross(corners[1] - corners[0], c - corners[0]);
  const double turn_1 = cross(corners[2] - corners[1], c - corners[1]);
  const double turn_2 = cross(corners[0] - corners[2], c - corners[2]);
  if (cross(corners[1] - corners[0], corners[2] - corners[0]) == 0.0) return false;
  return (turn_0 >= 0.0 && turn_1 >= 0.0 && turn_2 >= 0.0) || (turn_0 <= 0.0 && turn_1 <= 0.0 && turn_2 <= 0.0);
}

std::optional<Contact> find_contact(const Mesh& mesh, const Triangle& triangle, std::span<const Vec2> positions,
                                    const Circle& circle) {
  const std::array<Vec2, 3> corners = {positions[at(triangle.a)], positions[at(triangle.b)], positions[at(triangle.c)]};
  const auto [low_x, high_x] = std::minmax({corners[0].x, corners[1].x, corners[2].x});
  const auto [low_y, high_y] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
  const Vec2 c = circle.center;
  const double r = circle.radius;
  if (c.x + r <= low_x || c.x - r >= high_x || c.y + r <= low_y || c.y - r >= high_y) return std::nullopt;

  if (is_inside(c, corners)) return find_exit(mesh, positions, circle);
  const NearestPoint t = nearest_on_triangle_edges(c, corners);
  const Vec2 away = c - t.point;
  const double distance2 = dot(away, away);
  if (distance2 >= r * r) return std::nullopt;  // Eq. 3.22
  const double distance = std::sqrt(distance2);
  if (distance == 0.0) return find_exit(mesh, positions, circle);  // on a triangle without area
  // Eqs. 3.23 and 3.24, of which the sign is corrected.
  return Contact{(1.0 / distance) * away, r - distance, {triangle.a, triangle.b, triangle.c}, t.weight};
}

double push_apart(const Contact& contact, double inverse_mass_circle, double max_push,
                  std::span<const double> inverse_mass, std::span<Vec2> positions) {
  double w = inverse_mass_circle;
  for (std::size_t j = 0; j < 3; ++j) w += contact.weight[j] * contact.weight[j] * inverse_mass[at(contact.point[j])];
  if (w == 0.0) return 0.0;
  const double lambda = std::min(contact.depth, max_push) / w;
  for (std::size_t j = 0; j < 3; ++j) {
    const double share = lambda * contact.weight[j] * inverse_mass[at(contact.point[j])];
    positions[at(contact.point[j])] -= share * contact.direction;
  }
  return lambda;
}

}  // namespace ribbon
