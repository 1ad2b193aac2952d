#pragma once

#include <box2d/box2d.h>

#include <cstdint>
#include <span>
#include <vector>

#include "ribbon/box.h"
#include "ribbon/box2d/near_finder.h"
#include "ribbon/rigid_circle.h"

namespace ribbon::box2d {

/// Adds the parts of a fixture that a cord of the direct solver may touch: a circle as a circle; an edge or a polygon
/// as its edges, with its corners as circles of the same radius; of a chain the edges of the given children, which are
/// ascending. Parts that do not overlap `swept_aabb` [m], enlarged by the travel of the fixture, are left out. `body`
/// is the index of the body in the step.
void add_shapes(std::span<const NearShape> parts, int body, const Box& swept_aabb, std::vector<RigidCircle>& circles,
                std::vector<RigidSegment>& segments);

/// Returns whether this id (Touch::other) of a part of a fixture is that of an edge, not of a circle.
inline bool is_edge(std::uint64_t id) { return id % 2 == 1; }
/// Returns the number of the fixture whose part has this id (Touch::other), or 0 for another cord.
std::uint64_t fixture_of(std::uint64_t id);

}  // namespace ribbon::box2d
