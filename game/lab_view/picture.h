#pragma once

#include <utility>
#include <vector>

#include "game/lab/experiment.h"
#include "game/simulation/snapshot.h"

namespace game::lab {

/// Where everything of an experiment is at a moment: after a tick, or between two of them.
struct Picture {
  struct Bench {
    Snapshot snapshot;                                                       ///< its cords and bodies
    std::vector<std::vector<std::pair<ribbon::Vec2, ribbon::Vec2>>> chains;  ///< m, both ends of each link
  };

  std::vector<Bench> benches;
  std::vector<ShownForce> forces;
};

/// Overwrites the picture with the present.
void take_picture(Picture& picture, const Experiment& experiment);
/// Interpolates linearly; `alpha` is 0 … 1 for `from` … `to`, which must be of the same experiment without a restart
/// between them.
Picture between(const Picture& from, const Picture& to, double alpha);

/// Returns the index of a body in Snapshot::bodies. Costs time proportional to it.
std::size_t number_of(const b2Body& body);

}  // namespace game::lab
