#pragma once

#include <string>
#include <vector>

#include "tests/peers/judge.h"
#include "tests/peers/plan.h"

namespace peers {

/// A scene that all engines play.
struct Scene {
  std::string name;         ///< bridge
  std::string group;        ///< ratio=100; empty if the scene has one alone
  std::string description;  ///< a sentence without its stop
  bool touches = false;     ///< something, and is in the page's second table
  SetUp set_up;
  int calm_ticks = 0;
  int ticks = 0;
  std::string error_name;  ///< of what error() is, for the axis
  /// m, by which the scene is judged.
  double (*error)(const Figures& figures, const Recording& recording) = nullptr;
};

/// In the order of the page.
const std::vector<Scene>& scenes();

}  // namespace peers
