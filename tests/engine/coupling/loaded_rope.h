#pragma once

#include "tests/engine/coupling/grip_world.h"

namespace engine {

using ribbon::box2d::CordId;
using ribbon::box2d::GripId;

/// A rope of 10 m that hangs from a pin, with a load of 3 kg at its end and a light hand in its middle.
struct LoadedRope : GripWorld {
  explicit LoadedRope(CordDef def = hanging()) {
    rope = coupling.add(Cord(def));
    hand = add_body({0.0, -5.0}, 0.5);
    load = add_body({0.0, -10.0}, 3.0);
    hand_grip = coupling.hold(*hand, {.cord = rope, .arc = 5.0});
    load_grip = coupling.hold(*load, {.cord = rope, .arc = 10.0});
  }

  /// Falls asleep, with what it holds. Its definition allows that.
  void fall_asleep() {
    hand->SetSleepingAllowed(true);
    load->SetSleepingAllowed(true);
    tick(300);
    ASSERT_TRUE(coupling.cord(rope).direct().is_asleep());
  }
  static CordDef sleepy() {
    CordDef def = hanging();
    def.allow_sleep = true;
    def.drag = 1.0;
    return def;
  }

  CordId rope;
  b2Body* hand;
  b2Body* load;
  GripId hand_grip, load_grip;
};

}  // namespace engine
