#include "ribbon/system/fetch_cord.h"

#include "ribbon/linear/fetch.h"
#include "ribbon/system/cord_parts.h"

namespace ribbon {

void fetch_cord(const Cord& cord) { fetch_line(&cord); }

void fetch_parts(const Cord& cord) { fetch_bytes(&cord.parts(), sizeof(CordParts)); }

void fetch_lists(const Cord& cord) {
  const CordParts& parts = cord.parts();
  if (parts.state.asleep) return;
  parts.elasticity->fetch();
  const Cord::State& state = parts.state;
  fetch_list(state.positions);
  fetch_list(state.velocities);
  fetch_list(state.accelerations);
  fetch_list(state.tensions);
  fetch_list(state.masses);
  fetch_list(state.kinds);
  fetch_list(state.targets);
}

}  // namespace ribbon
