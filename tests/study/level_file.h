#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "game/simulation/level.h"
#include "tests/study/dials.h"

namespace study {

/// How far LevelFile::varied goes. Factors are drawn evenly in their logarithm.
struct Variation {
  static constexpr double factor = 4.0;  ///< mass, drag, damping, bending, and the player's mass: ¼ … 4 times
  static constexpr double links = 2.0;   ///< ½ … 2 times as many
  static constexpr double place = 0.1;   ///< m, that a cord is moved to each side, up and down
};

/// A level's file, which can be read and written with other settings.
class LevelFile {
 public:
  /// Throws engine::MapError for a file that is no level, and for one that has no cord.
  explicit LevelFile(const std::string& path);

  const std::string& path() const { return path_; }
  std::uint64_t hash() const { return hash_; }

  /// The level as it is.
  game::Level level() const;
  /// N, the stretch stiffness of the ribbons that stand in for ropes without one: with five times the weight of all
  /// that moves on one of them it stretches by a ten thousandth.
  double ribbon_stiffness() const;
  /// With all its cords solved so. Throws engine::MapError if that cannot be built.
  game::Level with(const Dials& dials) const;
  /// The same, the cords moved by `offset` [m] to the right.
  game::Level moved(const Dials& dials, double offset) const;
  /// As it is, but for cords moved by `offset` [m] to the right.
  game::Level displaced(double offset) const;
  /// The same level otherwise, the same for the same seed: each of its cords, and the player, within Variation.
  LevelFile varied(unsigned seed) const;
  /// With a property of all its cords set, or without it if the value is null.
  game::Level with_property(const std::string& name, const nlohmann::ordered_json& value) const;
  /// With a property set on those of its cords that can be built with it; nothing if there are none.
  std::optional<game::Level> switched_on(const std::string& name, const nlohmann::ordered_json& value) const;
  /// Whether a cord declares it, as something else than false or 0.
  bool declares(const std::string& property) const;

  /// Writes these settings to the file and keeps every other byte. Throws std::runtime_error, and leaves the file as it
  /// was, if it cannot be written.
  void apply(const Dials& dials) const;

 private:
  using Json = nlohmann::ordered_json;
  game::Level level_of(const Json& json) const;
  template <typename Visit>
  static void for_each_object(Json& json, const std::string& kind, Visit&& visit);
  template <typename Visit>
  static void for_each_cord(Json& json, Visit&& visit) {
    for_each_object(json, "cord", visit);
  }
  static void set(Json& cord, const std::string& name, const Json& value);
  static std::string with_changes(const std::string& text, const Json& before, const Json& after);
  static const Json* find(const Json& cord, const std::string& name);
  void displace(Json& cord, double offset) const;
  static void multiply_links(Json& cord, double times);
  void set_dials(Json& cord, const Dials& dials) const;
  void make_ribbon(Json& cord, int rows) const;
  static void make_thesis(Json& cord, const Dials& dials);

  std::string path_;
  std::uint64_t hash_;
  double pixels_per_metre_;
  Json json_;
};

}  // namespace study
