#pragma once

#include <cstdint>
#include <vector>

#include "game/lab/bench.h"
#include "game/lab/joint_chain.h"
#include "ribbon/box2d/coupling.h"

namespace game::lab {

/// Returns the kinetic, potential and elastic energy of all cords, chains and bodies of a bench, J. Elastic energy of
/// cords of the thesis's method is left out.
double energy(const Bench& bench);
/// Returns how much longer the most stretched cord or chain of a bench is than at rest: the mean of its rows, relative.
/// Negative if all are shorter.
double greatest_stretch(const Bench& bench);
/// Returns the length of a cord now, as the mean of its rows, and at rest, m.
/// @{
double length_now(const ribbon::box2d::CordView& cord);
double length_at_rest(const ribbon::box2d::CordView& cord);
/// @}
/// Returns the length of a chain with the gaps of its joints, m.
double length_now(const JointChain& chain);
/// Returns the number of cords that did not take the substeps that they asked for in the last tick: a heap of cords
/// with soft contacts is taken in one (ribbon::Accuracy::fast).
int cords_in_one_step(const Bench& bench);
/// Returns whether all positions and velocities of cords and bodies are finite.
bool is_finite(const Bench& bench);
/// Returns a hash of the whole state: cords and bodies.
std::uint64_t state_hash(const Bench& bench);

}  // namespace game::lab
