#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "game/simulation/level.h"
#include "tests/study/setting.h"

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

/// Finds a cheaper setting for single cords, without trying all products: first the cheapest one of each cord with
/// which the common setting of all others is still within the error, then one cord after the other is given its own,
/// the one that saves most first, as long as all of them together are within the error. None if nothing is saved.
std::optional<ByCord> find_by_cord(const CordSearch& search, const std::function<Outcome(const CordSettings&)>& judge);

/// Returns the ids of the objects of a level's cords of the direct solver; and the accuracies of the cords that are not
/// those of the common setting.
std::vector<int> cord_objects_of(const game::Level& level);
std::map<ribbon::box2d::CordId, ribbon::Accuracy> accuracies_of(const game::Level& level, const CordSettings& settings);

/// Returns the recommendation in words, with the cords' names in the map, or the numbers of their objects.
std::string in_words(const ByCord& by_cord, const LevelFile& file);

}  // namespace study
