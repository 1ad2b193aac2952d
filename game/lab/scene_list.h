#pragma once

#include <vector>

#include "game/lab/scene.h"

// The scenes, each in the file that has its name, and what they share.

namespace game::lab {

/// A load that swings on a cord of 1 kg, beside one on a chain of Box2D's joints.
Scene heavy_load();
/// Two weights on a cord around a post: friction holds them up to a ratio of e^(μ·angle).
Scene capstan();
/// Ropes and ribbons that fall into a heap.
Scene pile();
/// Ribbons that fall through a lattice of pegs.
Scene strips();
/// Five columns under loads around the one at which they buckle.
Scene buckling();
/// A ball on a cord between two pins, beside one on a chain of Box2D's joints.
Scene bridge();
/// Up to a thousand lamps on ropes, which fall asleep.
Scene lamps();
/// The cords of Goto 2017, Table 4.3, by the thesis's method.
/// @{
Scene thesis_a();
Scene thesis_b();
Scene thesis_c();
Scene thesis_d();
/// @}

/// Returns the knobs preset, substeps and tolerance, with the values of a preset: 0 … 2.
std::vector<KnobRange> accuracy_knobs(int preset);
/// Returns the knob of EA from `min` to `max`, N; the greatest value means an inextensible cord, the initial one.
KnobRange stretch_knob(double min, double max);
/// Returns both lists, one after the other.
std::vector<KnobRange> together(std::vector<KnobRange> a, const std::vector<KnobRange>& b);

/// Returns the points of a straight line of equal links, `span` m from `start`.
std::vector<ribbon::Vec2> straight(int points, ribbon::Vec2 start, ribbon::Vec2 span);
/// Returns the points of links of equal length that sag evenly between `start` and a point at the same height at the
/// distance `span`, which is less than `length`.
std::vector<ribbon::Vec2> sagging(int points, double length, ribbon::Vec2 start, double span);

/// Returns by how much a bench's cord or chain is longer than its tensions make it, m.
double excess_length(const Bench& bench);
/// Returns the excess length and the number of unconverged substeps as what a scene shows.
std::vector<Reading> excess_readings(const Bench& bench);
/// Returns the number of substeps that did not converge since the start, of all cords of the direct solver.
int unconverged(const Bench& bench);
/// Returns the number of contacts of all cords in the last tick.
int contacts(const Bench& bench);

}  // namespace game::lab
