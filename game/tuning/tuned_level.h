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
  /// Reads the level's file. Throws engine::MapError if it cannot be read or is not the one the level was loaded from.
  explicit TunedLevel(const Level& level);

  /// Sets a property of an object (engine::map_itself: the gravity), for good and in the running scene at once. Throws
  /// engine::MapError, and changes nothing, if it cannot be.
  void set(int object, std::string_view property, const engine::Properties::Value& value, engine::Scene& scene);
  /// The same without the property.
  void remove(int object, std::string_view property, engine::Scene& scene);

  /// Whether it differs from the file.
  bool is_changed() const { return text_ != file_text_; }

  /// The level to begin anew with.
  const Level& level() const { return level_; }
  /// Puts the changes into the file, which keeps every other byte. Throws engine::MapError if the file has changed
  /// since it was read, and std::runtime_error if it cannot be written; it then stays as it is.
  void write();

 private:
  void take(std::string text, int object, engine::Scene& scene);

  std::string file_text_;
  std::string text_;
  Level level_;
};

}  // namespace game
