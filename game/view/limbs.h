#pragma once

#include <cstddef>

#include "game/view/pose.h"

namespace game {

/// The lengths of the figure's bones, m. An arm and a leg have two of the same length.
inline constexpr double torso = 0.44;
inline constexpr double neck_to_head = 0.22;
inline constexpr double arm_bone = 0.27;
inline constexpr double leg_bone = 0.34;
/// m above the centre of a standing figure.
inline constexpr double hip_height = -0.045;

/// Returns the direction of a vector, or `fallback` for one without length.
ribbon::Vec2 unit(ribbon::Vec2 v, ribbon::Vec2 fallback);
/// Turns a vector by an angle, rad, counter-clockwise.
ribbon::Vec2 turned(ribbon::Vec2 v, double angle);

/// Sets hip, neck, head and shoulders. `up`: the direction of the torso. `shrug`: m, by how much the shoulders are
/// raised.
void set_torso(Pose& pose, ribbon::Vec2 hip, ribbon::Vec2 up, double shrug = 0.0);
/// Places a foot, or stretches the leg towards it if it is too far.
void set_leg(Pose& pose, std::size_t k, ribbon::Vec2 foot);
/// Places a hand, or stretches the arm towards it if it is too far. `bend`: ±1, the side of the elbow.
void set_arm(Pose& pose, std::size_t k, ribbon::Vec2 hand, double bend);
/// Places a hand at that position; the bones are drawn longer if it is too far.
void set_holding_arm(Pose& pose, std::size_t k, ribbon::Vec2 hand, double bend);

}  // namespace game
