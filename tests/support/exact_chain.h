#pragma once

#include <vector>

#include "ribbon/vec2.h"

namespace test_support {

/// The scene that ropes are judged by: a 10 m rope of 50 links and 1 kg with a load of 70 kg at its end, pinned at the
/// origin and released at rest from the horizontal, along +x. 60 Hz, five seconds.
namespace heavy {
constexpr int links = 50;
constexpr double length = 10.0;      // m
constexpr double rope_mass = 1.0;    // kg, half a link's share at each end of every link
constexpr double load_mass = 70.0;   // kg
constexpr double gravity = 9.81;     // m/s², downwards
constexpr double tick = 1.0 / 60.0;  // s
constexpr int ticks = 300;
}  // namespace heavy

/// Where the load of a chain that does not stretch is after each tick of that scene, m. Nothing of the cords under test
/// is in it: the chain's tensions follow from its links keeping their length, and the classical Runge–Kutta method
/// takes `substeps` a tick, at least 30 or so (it is explicit). 160, the default, are converged to a few nanometres.
std::vector<ribbon::Vec2> exact_heavy_load(int substeps = 160);

}  // namespace test_support
