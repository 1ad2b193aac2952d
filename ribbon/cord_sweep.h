#pragma once

#include "ribbon/box.h"

// Bounds of the motion of a cord. A search for the neighbours of many cords, such as that of a coupling, reads them.

namespace ribbon {

class Cord;

/// Bounds of a cord's position and motion.
struct CordSweep {
  Box box;               ///< m, around its points and their targets
  double speed2 = 0.0;   ///< m²/s², square of the highest speed of a point
  double elastic = 0.0;  ///< J, elastic energy; 0 while the cord sleeps
  double link = 0.0;     ///< m, rest length of the first link
};

/// Returns the bounds. O(1) after a step of a DirectSolver, until the cord is changed; otherwise O(points).
CordSweep sweep_of(const Cord& cord);
/// Returns whether the cord is unchanged since a step of a DirectSolver, so that sweep_of is O(1).
bool remembers_sweep(const Cord& cord);
/// Returns whether the cord collides with other cords: with those that declare cord_contact as it does, and, with
/// self_contact, with other pieces of the cord that it was cut from.
bool meets_cords(const Cord& cord);
/// Starts to load into the cache what these functions, Cord::def and pulleys_of read. Call it in a loop over many
/// cords, for a cord some turns ahead. It changes nothing but the speed.
void fetch(const Cord& cord);

}  // namespace ribbon
