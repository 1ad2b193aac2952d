#include "ribbon/medium.h"

#include "ribbon/cord.h"
#include "ribbon/system/cord_in_medium.h"

namespace ribbon {

double medium_delta_v(const Cord& cord, const Medium& medium, double time, double dt, Vec2 gravity) {
  Surroundings surroundings;
  surroundings.medium = &medium;
  surroundings.time = time;
  return max_medium_push(cord.parts(), surroundings, dt, gravity).delta_v;
}

}  // namespace ribbon
