#pragma once

#include <string>
#include <vector>

#include "tests/tradeoff/measure.h"

namespace tradeoff {

/// One way of running a scene.
struct Contestant {
  std::string method;   ///< banded, dense_inverse
  std::string setting;  ///< the dials: substeps=8
  int points = 0;
  Tick tick;
};

/// A scene and the ways of running it, to be timed side by side.
struct Scene {
  std::string name;
  std::string description;
  int ticks = 0;  ///< a repeat
  std::vector<Contestant> (*contestants)();
};

const std::vector<Scene>& scenes();
/// Null if there is none of that name.
const Scene* find_scene(const std::string& name);

}  // namespace tradeoff
