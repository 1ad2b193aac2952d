#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "game/simulation/level.h"
#include "tests/study/setting.h"
#include "tests/study/trace.h"

namespace study {

class LevelFile;

/// Of settings by cord, with the recorded player and all others.
struct Outcome {
  double error_m = 0.0;
  double work = 0.0;  ///< of the recording, mean over the ticks
  std::string failure{};
};

/// A recommendation by cord.
struct ByCord {
  CordSettings settings;
  Outcome outcome;
  double common_work = 0.0;  ///< of the recording with the common setting for all cords
  int tried = 0;             ///< number of choices that were measured
};

/// What a search by cord is given.
struct CordSearch {
  std::vector<int> cords;        ///< ids of their objects in the map
  std::vector<Setting> cheaper;  ///< than the common setting for all cords, the cheapest first
  double max_error_m = 0.0;      ///< with the margin of a recommendation
  CordSettings common;
  Outcome of_common;
};

/// What a search by cord finds.
struct CordSearchResult {
  std::optional<ByCord> found{};  ///< none if nothing is saved
  /// The work of the run in which each cord has the cheapest setting that it alone may have; NaN if that run fails. An
  /// assignment within the error needs as much, unless the errors of cords cancel. Cords of one island are solved with
  /// the most accurate setting among them: the work of islands with a cord that needs one is in it.
  double least_work = unavailable;
};

/// Finds cheaper settings for single cords, without trying all products: first the cheapest one of each cord with which
/// the common setting of all others is still within the error; then all of these at once. If that is beyond the error,
/// one cord after the other is given the cheapest one that the error still allows, the one that saves most first. (A
/// cord that shares its island saves nothing alone, but the last of that island does.)
CordSearchResult find_by_cord(const CordSearch& search, const std::function<Outcome(const CordSettings&)>& judge);

/// Returns the ids of the objects of a level's cords of the direct solver; and the accuracies of the cords that are not
/// those of the common setting.
std::vector<int> cord_objects_of(const game::Level& level);
std::map<ribbon::box2d::CordId, ribbon::Accuracy> accuracies_of(const game::Level& level, const CordSettings& settings);

/// Returns the recommendation in words, with the cords' names in the map, or the numbers of their objects.
std::string in_words(const ByCord& by_cord, const LevelFile& file);

}  // namespace study
