#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/draw/image.h"
#include "game/simulation/level.h"

namespace game {

/// Small pictures of the starts of levels, drawn from the levels themselves.
class LevelPictures {
 public:
  static constexpr int width = 512;   ///< px
  static constexpr int height = 256;  ///< px

  /// Returns the picture of a level; null if it was not drawn yet or cannot be drawn.
  const engine::Image* of(const Level& level) const;
  /// Returns whether make() was called for it.
  bool has_tried(const Level& level) const { return images_.contains(level.map.content_hash); }
  /// Draws the picture unless there is one. `signs`: as in ViewOptions.
  void make(const Level& level, const std::vector<std::string>& signs, bool colour_safe);

 private:
  std::map<std::uint64_t, std::optional<engine::Image>> images_;  // by the hash of the level
};

}  // namespace game
