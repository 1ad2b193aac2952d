#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/replay/replay.h"
#include "game/simulation/level.h"
#include "game/simulation/player.h"
#include "game/simulation/run_header.h"
#include "game/simulation/simulation.h"
#include "ribbon/box2d/convert.h"

namespace bits {

/// The recorded runs in the assets folder, sorted by path.
inline std::vector<std::string> golden_replays() {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(game::assets_folder() + "/replays")) {
    if (entry.path().extension() == ".replay") paths.push_back(entry.path().string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// The test name of each.
inline std::string name_of_replay(const testing::TestParamInfo<std::string>& replay) {
  return std::filesystem::path(replay.param).stem().string();
}

/// A recorded run and the level that it was recorded with.
struct GoldenRun {
  explicit GoldenRun(const std::string& path)
      : replay(engine::load_replay(path)), level(game::load_level(replay.header.level)) {
    check_header(replay.header, game::replay_header(level));
  }
  engine::Replay replay;
  game::Level level;
};

}  // namespace bits
