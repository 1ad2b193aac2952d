#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "game/level.h"
#include "tests/study/dials.h"

namespace study {

/// A level's file, to be read with other dials than it has, and to be written with them.
class LevelFile {
 public:
  /// Throws engine::MapError for a file that is no level, and for one that has no cord.
  explicit LevelFile(const std::string& path);

  const std::string& path() const { return path_; }
  std::uint64_t hash() const { return hash_; }

  /// The level as it is.
  game::Level level() const { return game::load_level(path_); }
  /// With all its cords solved so. Throws engine::MapError if that cannot be built.
  game::Level with(const Dials& dials) const;
  /// The same, the cords moved by `offset` [m] to the right.
  game::Level moved(const Dials& dials, double offset) const;
  /// As it is, but for cords moved by `offset` [m] to the right.
  game::Level displaced(double offset) const;
  /// With a property of all its cords set, or without it if the value is null.
  game::Level with_property(const std::string& name, const nlohmann::ordered_json& value) const;
  /// With a property set on those of its cords that can be built with it; nothing if there are none.
  std::optional<game::Level> switched_on(const std::string& name, const nlohmann::ordered_json& value) const;
  /// Whether a cord declares it, as something else than false or 0.
  bool declares(const std::string& property) const;

  /// Writes the file anew with these dials; what else it says stays. Throws std::runtime_error, and leaves the file as
  /// it was, if it cannot be written.
  void apply(const Dials& dials) const;

 private:
  using Json = nlohmann::ordered_json;
  game::Level level_of(const Json& json) const;
  template <typename Visit>
  static void for_each_cord(Json& json, Visit&& visit);
  static void set(Json& cord, const std::string& name, const Json& value);
  static const Json* find(const Json& cord, const std::string& name);
  void displace(Json& cord, double offset) const;
  static void set_dials(Json& cord, const Dials& dials);
  static void make_thesis(Json& cord, const Dials& dials);

  std::string path_;
  std::uint64_t hash_;
  double pixels_per_metre_;
  Json json_;
};

}  // namespace study
