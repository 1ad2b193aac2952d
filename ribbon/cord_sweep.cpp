#include "ribbon/cord_sweep.h"

#include <initializer_list>

#include "ribbon/cord.h"
#include "ribbon/linear/fetch.h"
#include "ribbon/system/cord_parts.h"

namespace ribbon {

CordSweep sweep_of(const Cord& cord) {
  const CordParts& parts = cord.parts();
  return parts.sweep ? *parts.sweep : parts.find_sweep();
}

bool remembers_sweep(const Cord& cord) { return cord.parts().sweep.has_value(); }
bool meets_cords(const Cord& cord) { return cord.parts().meets_cords(); }

void fetch(const Cord& cord) {
  const CordParts& parts = cord.parts();
  fetch_bytes(&parts.sweep, sizeof parts.sweep);
  for (const void* const part :
       std::initializer_list<const void*>{&parts.def.radius, &parts.def.gravity_scale, &parts.def.cord_contact,
                                          &parts.state.pulleys, &parts.state.asleep}) {
    fetch_line(part);
  }
}

}  // namespace ribbon
