#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "game/simulation/level.h"
#include "tests/study/setting.h"

namespace study {

/// The range of LevelFile::varied. The logarithms of factors are uniformly distributed.
struct Variation {
  static constexpr double factor = 4.0;  ///< mass, drag, damping, bending, and the player's mass: ¼ … 4 times
  static constexpr double links = 2.0;   ///< number of links: ½ … 2 times
  static constexpr double place = 0.1;   ///< m, maximum displacement of a cord in x and y
};

/// A level's file, which can be read and written with other settings.
class LevelFile {
 public:
  /// Throws engine::MapError for a file that is not a level.
  explicit LevelFile(const std::string& path);

  const std::string& path() const { return path_; }
  std::uint64_t hash() const { return hash_; }

  /// Returns the level without changes.
  game::Level level() const;
  /// Returns the stretch stiffness of ribbons in place of inextensible ropes, N: five times the weight of everything
  /// that moves stretches one of them by 1e-4.
  double ribbon_stiffness() const;
  /// Returns the level with a setting for all cords of the map, or some of their own, and, of the direct solver, for
  /// lines that are thrown. Throws engine::MapError if it cannot be built.
  game::Level with(const CordSettings& settings) const;
  /// Returns why the level cannot have the setting; empty if it can. It can have every setting of the direct solver for
  /// its own points and rows.
  std::string left_out_reason(const Setting& setting) const;
  /// Returns whether the map has a cord or ribbon.
  bool has_cords() const;
  /// Returns a random variation of the level: each cord, and the player, within Variation; the same for the same seed.
  LevelFile varied(unsigned seed) const;
  /// Returns the level with a property of all cords set, or removed if the value is null.
  game::Level with_property(const std::string& name, const nlohmann::ordered_json& value) const;
  /// Returns the level with a property set for those cords that can be built with it; none if there are no such cords.
  std::optional<game::Level> switched_on(const std::string& name, const nlohmann::ordered_json& value) const;
  /// Returns whether a cord declares the property with a value other than false or 0.
  bool declares(const std::string& property) const;

  /// Writes these settings to the cords of the file and leaves every other byte. Throws std::runtime_error if it has no
  /// cord, or cannot be written; then the file is unchanged.
  void apply(const CordSettings& settings) const;
  /// Returns the name of an object of the map, or "cord 12" for one without.
  std::string name_of_object(int id) const;

 private:
  using Json = nlohmann::ordered_json;
  game::Level level_of(const Json& json) const;
  game::Level level_of(const Json& json, const Setting& setting) const;
  template <typename Visit>
  static void for_each_object(Json& json, const std::string& kind, Visit&& visit);
  template <typename Visit>
  static void for_each_cord(Json& json, Visit&& visit) {
    for_each_object(json, "cord", visit);
    for_each_object(json, "ribbon", visit);
  }
  static void set(Json& cord, const std::string& name, const Json& value);
  static std::string with_changes(const std::string& text, const Json& before, const Json& after);
  static const Json* find(const Json& cord, const std::string& name);
  static int rows_of(const Json& cord);
  static void multiply_links(Json& cord, double times);
  /// Ropes around wheels stay ropes of the direct solver.
  void apply_setting(Json& cord, const Setting& setting) const;
  static const Setting& setting_of(const Json& cord, const CordSettings& settings);
  void make_ribbon(Json& cord, int rows) const;
  void change_rows(Json& cord, int rows) const;
  static void make_thesis(Json& cord, const Setting& setting);

  std::string path_;
  std::uint64_t hash_;
  double pixels_per_metre_;
  Json json_;
  std::vector<int> reeved_;  // ids of the cords around wheels
};

}  // namespace study
