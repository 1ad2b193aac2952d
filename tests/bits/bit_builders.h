#pragma once

#include "tests/bits/bit_scenes.h"

// The initial states of the scenes of bits, and their changes before each tick.

namespace bits {

void build_ropes(BitWorld& scene);
void drive_ropes(BitWorld& scene, int tick);
void build_terms(BitWorld& scene);
void build_ribbons(BitWorld& scene);
void build_contacts(BitWorld& scene);
void build_self_contact(BitWorld& scene);
void build_thesis(BitWorld& scene);
void drive_thesis(BitWorld& scene, int tick);
void build_rough(BitWorld& scene);
void drive_rough(BitWorld& scene, int tick);
void build_asleep(BitWorld& scene);
void drive_asleep(BitWorld& scene, int tick);
void build_grips(BitWorld& scene);
void drive_grips(BitWorld& scene, int tick);
void build_ties(BitWorld& scene);
void drive_ties(BitWorld& scene, int tick);
void build_cuts(BitWorld& scene);
void drive_cuts(BitWorld& scene, int tick);
void build_listener(BitWorld& scene);
void build_wind(BitWorld& scene);
void drive_wind(BitWorld& scene, int tick);
void build_pulleys(BitWorld& scene);
void drive_pulleys(BitWorld& scene, int tick);

}  // namespace bits
