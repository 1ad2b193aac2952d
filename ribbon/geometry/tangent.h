#pragma once

#include "ribbon/vec2.h"

namespace ribbon {

/// The straight part of a cord between a point and the wheel around which it runs.
struct TangentLine {
  Vec2 normal;    ///< unit vector from the centre of the wheel to where the line touches it
  Vec2 along;     ///< unit vector in which the cord runs
  double length;  ///< m, above 0
};

/// Returns the line on which a cord arrives at a wheel of this radius [m], from a point at r [m] from its centre. With
/// `sense` 1 it runs counterclockwise around the wheel, with −1 clockwise. A point on the wheel is taken to be just off
/// it.
TangentLine arriving_line(Vec2 r, double radius, double sense);
/// Returns the line on which it leaves the wheel to such a point.
TangentLine leaving_line(Vec2 r, double radius, double sense);

/// Return the lines from a point at r [m] to a place in the groove, and from that place to the point. The place is at
/// `normal` times the radius from the centre.
TangentLine line_to_groove(Vec2 r, double radius, Vec2 normal);
TangentLine line_from_groove(Vec2 r, double radius, Vec2 normal);

/// Returns the angle from a to b, −π … π [rad], both unit vectors. It uses only + − × ÷ √. Error: 1e-14.
double angle_between(Vec2 a, Vec2 b);
/// Returns eˣ for x ≥ 0, from 40 on as for 40. It uses only + − × ÷. Relative error: 1e-13.
double exponential(double x);

}  // namespace ribbon
