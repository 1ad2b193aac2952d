#pragma once

#include <box2d/box2d.h>

#include <cstdint>
#include <span>
#include <vector>

#include "ribbon/box.h"
#include "ribbon/box2d/near_finder.h"
#include "ribbon/rigid_circle.h"

namespace ribbon::box2d {

/// Parts of a fixture as a cord of the direct solver sees them: a circle as such, an edge or polygon as its edges, and
/// its corners as circles of the same radius; of a chain the edges of these children, which rise. Adds what overlaps
/// the `reach` of the cord [m] widened by each part's way; `body` is the index of the fixture's body.
void add_shapes(std::span<const NearShape> parts, int body, const Box& reach, std::vector<RigidCircle>& circles,
                std::vector<RigidSegment>& segments);

/// The id of the fixture that a touch is with, 0 for another cord.
std::uint64_t fixture_of(std::uint64_t touched);

}  // namespace ribbon::box2d
