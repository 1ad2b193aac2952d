#pragma once

#include <string>
#include <vector>

#include "tests/peers/figures.h"
#include "tests/peers/plan.h"

namespace peers {

/// A scene that all engines run.
struct Scene {
  std::string name;           ///< bridge
  std::string group;          ///< ratio=100; empty if the scene has no parts
  std::string description;    ///< a sentence without its full stop
  bool has_contacts = false;  ///< whether there are contacts; then it is in the page's second table
  SetUp set_up;
  int settling_ticks = 0;
  int ticks = 0;
  std::string error_name;  ///< name of the error, for the axis
  /// Returns the error that ranks the settings, m.
  double (*error)(const Figures& figures, const Recording& recording) = nullptr;
};

/// Returns the scenes in the order of the page.
const std::vector<Scene>& scenes();

}  // namespace peers
