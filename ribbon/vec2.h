#pragma once

#include <cmath>

/// Simulates cords and ribbons made of mass points, in SI units and double precision, with y up. Independent of Box2D,
/// windows, files and clocks.
namespace ribbon {

/// A point or vector in the plane, with y up. It is plain data: its layout does not depend on compiler flags, and every
/// operation rounds once, in the order written. So all compilers give the same bits.
struct Vec2 {
  double x = 0.0;  ///< to the right
  double y = 0.0;  ///< up

  /// Adds b.
  constexpr Vec2& operator+=(Vec2 b) {
    x += b.x;
    y += b.y;
    return *this;
  }
  /// Subtracts b.
  constexpr Vec2& operator-=(Vec2 b) {
    x -= b.x;
    y -= b.y;
    return *this;
  }
  constexpr bool operator==(const Vec2&) const = default;
};

/// Sum, difference, negative and multiple, component by component.
/// @{
constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
constexpr Vec2 operator-(Vec2 a) { return {-a.x, -a.y}; }
constexpr Vec2 operator*(double s, Vec2 a) { return {s * a.x, s * a.y}; }
/// @}

/// Returns the scalar product a.x·b.x + a.y·b.y.
constexpr double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
/// Returns the z component of a × b: twice the area of the triangle (0, a, b), positive if it is counter-clockwise.
constexpr double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
/// Returns `a` rotated by 90° counter-clockwise.
constexpr Vec2 perp(Vec2 a) { return {-a.y, a.x}; }

/// Returns 0 for values below 1e-40, else the value. A disturbance that decays from link to link along a straight cord
/// would otherwise become subnormal, which makes arithmetic about fifty times slower.
inline double without_dust(double a) { return std::abs(a) < 1e-40 ? 0.0 : a; }
/// Applies without_dust to both components.
inline Vec2 without_dust(Vec2 a) { return {without_dust(a.x), without_dust(a.y)}; }

/// Returns √(x² + y²).
inline double length(Vec2 a) { return std::sqrt(dot(a, a)); }
/// Returns whether both components are finite.
inline bool is_finite(Vec2 a) { return std::isfinite(a.x) && std::isfinite(a.y); }

}  // namespace ribbon
