#pragma once

#include <string>
#include <string_view>

#include "engine/scene/tiled_edit.h"
#include "game/simulation/level.h"
#include "game/simulation/simulation.h"

namespace game {

/// A level whose cords and gravity are changed while it runs, and the text of its file with these changes.
class TunedLevel {
 public:
  /// Reads the file of the level. Throws engine::MapError if it cannot be read or has changed since the level was
  /// loaded.
  explicit TunedLevel(const Level& level);

  /// Sets a property of an object (engine::map_itself: gravity) in the level and in the running scene. Throws
  /// engine::MapError, without a change, if the value is not accepted.
  void set(int object, std::string_view property, const engine::Properties::Value& value, engine::Scene& scene);
  /// Removes a property in the same way.
  void remove(int object, std::string_view property, engine::Scene& scene);

  /// Returns whether the level differs from the file.
  bool is_changed() const { return text_ != file_text_; }

  /// The changed level, for a restart.
  const Level& level() const { return level_; }
  /// Writes the changes to the file, without a change of any other byte. Throws engine::MapError if the file has
  /// changed since it was read, and std::runtime_error if it cannot be written; the file then stays as it is.
  void write();

 private:
  void take(std::string text, int object, engine::Scene& scene);

  std::string file_text_;
  std::string text_;
  Level level_;
};

}  // namespace game
