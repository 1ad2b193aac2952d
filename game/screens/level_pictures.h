#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/draw/image.h"
#include "game/simulation/level.h"

namespace game {

/// Small pictures of the starts of levels, drawn from the levels themselves.
class LevelPictures {
 public:
  static constexpr int width = 512;   ///< px
  static constexpr int height = 256;  ///< px

  /// Returns the picture of a level in these colours; null if it was not drawn yet or cannot be drawn.
  const engine::Image* of(const Level& level, bool colour_safe) const;
  /// Returns whether make() was called for it.
  bool has_tried(const Level& level, bool colour_safe) const { return images_.contains(key_of(level, colour_safe)); }
  /// Draws the picture unless there is one. `signs`: as in ViewOptions.
  void make(const Level& level, const std::vector<std::string>& signs, bool colour_safe);

 private:
  using Key = std::pair<std::uint64_t, bool>;  // the hash of the level, and whether the colours are safe
  static Key key_of(const Level& level, bool colour_safe) { return {level.map.content_hash, colour_safe}; }

  std::map<Key, std::optional<engine::Image>> images_;
};

}  // namespace game
