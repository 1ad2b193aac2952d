#include "ribbon/thesis/corrections.h"

#include "ribbon/linear/index.h"

namespace ribbon {

void correct_springs(std::span<const Connection> connections, double stiffness, double dt,
                     std::span<const double> inverse_mass, std::span<Vec2> positions) {
  // With W = w_a + w_b and κ = W·Ks·δ², the share κ/(1 + κ) of the stretch, divided by W, is 1/(W + 1/(Ks·δ²)).
  const double compliance = 1.0 / (stiffness * dt * dt);
  for (const Connection& bar : connections) {
    const double w_a = inverse_mass[at(bar.a)];
    const double w_b = inverse_mass[at(bar.b)];
    Vec2& a = positions[at(bar.a)];
    Vec2& b = positions[at(bar.b)];
    const Vec2 ab = b - a;
    const double size = length(ab);
    if (size == 0.0) continue;  // it has no direction; neighbours move its ends apart
    const double s = (size - bar.rest_length) / (size * (w_a + w_b + compliance));
    a += (s * w_a) * ab;
    b -= (s * w_b) * ab;
  }
}

double signed_area(Vec2 a, Vec2 b, Vec2 c) { return 0.5 * cross(b - a, c - a); }

void correct_areas(std::span<const Triangle> triangles, double floor, double stiffness,
                   std::span<const double> inverse_mass, std::span<Vec2> positions) {
  for (const Triangle& triangle : triangles) {
    Vec2& a = positions[at(triangle.a)];
    Vec2& b = positions[at(triangle.b)];
    Vec2& c = positions[at(triangle.c)];
    const double missing = floor * triangle.rest_area - signed_area(a, b, c);
    if (missing <= 0.0) continue;
    // A = ½ (b − a) × (c − a): its gradient at a corner is half the opposite side, rotated by 90°.
    const Vec2 grad_a = 0.5 * perp(c - b);
    const Vec2 grad_b = 0.5 * perp(a - c);
    const Vec2 grad_c = 0.5 * perp(b - a);
    const double w_a = inverse_mass[at(triangle.a)];
    const double w_b = inverse_mass[at(triangle.b)];
    const double w_c = inverse_mass[at(triangle.c)];
    const double slope = w_a * dot(grad_a, grad_a) + w_b * dot(grad_b, grad_b) + w_c * dot(grad_c, grad_c);
    if (slope == 0.0) continue;  // driven, or shrunk to a point: the gradient is 0
    const double s = stiffness * missing / slope;
    a += (s * w_a) * grad_a;
    b += (s * w_b) * grad_b;
    c += (s * w_c) * grad_c;
  }
}

}  // namespace ribbon
