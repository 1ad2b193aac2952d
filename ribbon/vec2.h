#pragma once

#include <cmath>

/// Cords and ribbons: points with mass, in SI units, y up, double precision. Knows no Box2D, window, file or clock.
namespace ribbon {

/// A point or vector in the plane: metres, metres a second or newtons, y up.
/// Plain data on purpose: its layout does not change with a caller's Eigen or vector-extension flags, and every
/// operation rounds once, in the order written, so that results are the same bits on every compiler.
struct Vec2 {
  double x = 0.0;  ///< to the right
  double y = 0.0;  ///< up

  /// Adds b to it.
  constexpr Vec2& operator+=(Vec2 b) {
    x += b.x;
    y += b.y;
    return *this;
  }
  /// Takes b from it.
  constexpr Vec2& operator-=(Vec2 b) {
    x -= b.x;
    y -= b.y;
    return *this;
  }
  constexpr bool operator==(const Vec2&) const = default;
};

/// Sum, difference, opposite, and multiple, component by component.
/// @{
constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
constexpr Vec2 operator-(Vec2 a) { return {-a.x, -a.y}; }
constexpr Vec2 operator*(double s, Vec2 a) { return {s * a.x, s * a.y}; }
/// @}

/// a.x·b.x + a.y·b.y: the product of the lengths and the cosine between them.
constexpr double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
/// The z component of a × b: twice the signed area of the triangle (0, a, b), counter-clockwise positive.
constexpr double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
/// a turned a quarter turn counter-clockwise.
constexpr Vec2 perp(Vec2 a) { return {-a.y, a.x}; }

/// 0 for what is too small to mean anything. A disturbance that decays from link to link along a straight cord would
/// otherwise become subnormal, and arithmetic with such numbers takes some fifty times as long.
inline double without_dust(double a) { return std::abs(a) < 1e-40 ? 0.0 : a; }
/// The same of both components.
inline Vec2 without_dust(Vec2 a) { return {without_dust(a.x), without_dust(a.y)}; }

/// √(x² + y²), 0 or more.
inline double length(Vec2 a) { return std::sqrt(dot(a, a)); }
/// True if neither component is infinite or not a number.
inline bool is_finite(Vec2 a) { return std::isfinite(a.x) && std::isfinite(a.y); }

}  // namespace ribbon
