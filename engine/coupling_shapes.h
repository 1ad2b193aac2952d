#pragma once

#include <box2d/box2d.h>

#include <cstdint>
#include <vector>

#include "ribbon/quadtree.h"
#include "ribbon/rigid_circle.h"

namespace engine {

/// A fixture as a cord of the direct solver sees it: a circle as such, an edge, chain or polygon as its edges, and its
/// corners as circles of the same radius. Adds what overlaps `reach` [m]; `body` is the index of the fixture's body,
/// and `id` the fixture's.
void add_shape(const b2Fixture& fixture, int body, std::uint64_t id, const ribbon::Box& reach,
               std::vector<ribbon::RigidCircle>& circles, std::vector<ribbon::RigidSegment>& segments);

/// The id of the fixture that a touch is with, 0 for another cord.
std::uint64_t fixture_of(std::uint64_t touched);

}  // namespace engine
