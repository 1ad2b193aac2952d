#pragma once

#include <string>
#include <vector>

#include "tests/study/level_study.h"

namespace study {

/// The settings of the grid that a level can have, and sentences about the others but chains.
struct LevelGrid {
  std::vector<Setting> settings;
  std::vector<std::string> left_out;
};

/// `chains`: whether chains of Box2D's joints can stand in for its cords.
LevelGrid grid_of(const StudyOptions& options, const LevelFile& file, bool chains);

std::vector<Mesh> meshes_of(const std::vector<Setting>& grid);

/// Returns what a run with a setting takes, in substeps of a cord with the level's points.
double work_of(const Setting& setting);

}  // namespace study
