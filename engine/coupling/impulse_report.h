#pragma once

#include <vector>

#include "ribbon/box2d/contact_listener.h"
#include "ribbon/box2d/coupled_cord.h"
#include "ribbon/box2d/coupling_types.h"
#include "ribbon/box2d/fixture_ids.h"

namespace ribbon::box2d {

/// Calls post_solve for all contacts of the step, whose pushes were recorded. `memory` is for the contacts of a
/// fixture.
void report_impulses(CordTable& cords, const FixtureIds& fixtures, ContactListener& listener,
                     std::vector<TouchImpulse>& memory);

}  // namespace ribbon::box2d
