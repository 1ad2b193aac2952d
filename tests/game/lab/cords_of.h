#pragma once

#include "game/lab/experiment.h"

namespace game::lab {

/// Returns the bench of an experiment that has the cords; the others have what they are compared with.
inline const Bench& cords_of(const Experiment& experiment) { return *experiment.benches().front(); }

}  // namespace game::lab
