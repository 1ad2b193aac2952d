#include "tests/study/by_cord.h"

#include <algorithm>
#include <memory>

#include "tests/study/level_file.h"
#include "tests/study/text.h"

namespace study {
namespace {

/// A cord that alone may have a cheaper setting.
struct Candidate {
  int cord = 0;
  const Setting* setting = nullptr;
  double work = 0.0;
};

}  // namespace

std::optional<ByCord> find_by_cord(const CordSearch& search, const std::function<Outcome(const CordSettings&)>& judge) {
  ByCord found{search.common, search.of_common, search.of_common.work};
  const auto saves = [&](const Outcome& outcome, double work) {
    ++found.tried;
    return outcome.failure.empty() && outcome.error_m <= search.max_error_m && outcome.work < work;
  };
  std::vector<Candidate> candidates;
  for (const int cord : search.cords) {
    for (const Setting& setting : search.cheaper) {
      CordSettings alone = search.common;
      alone.own[cord] = setting;
      const Outcome outcome = judge(alone);
      if (!saves(outcome, search.of_common.work)) continue;
      candidates.push_back({cord, &setting, outcome.work});
      break;
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.work < b.work; });
  for (const Candidate& candidate : candidates) {
    CordSettings more = found.settings;
    more.own[candidate.cord] = *candidate.setting;
    const Outcome outcome = judge(more);
    if (!saves(outcome, found.outcome.work)) continue;
    found.settings = std::move(more);
    found.outcome = outcome;
  }
  if (found.settings.own.empty()) return std::nullopt;
  return found;
}

std::vector<int> cord_objects_of(const game::Level& level) {
  const auto scene = level.make_scene();
  std::vector<int> objects;
  for (const ribbon::box2d::CordId c : scene->coupling().cords()) {
    if (scene->coupling().cord(c).solver() == ribbon::box2d::Solver::direct) objects.push_back(scene->cord_object(c));
  }
  return objects;
}

std::map<ribbon::box2d::CordId, ribbon::Accuracy> accuracies_of(const game::Level& level,
                                                                const CordSettings& settings) {
  std::map<ribbon::box2d::CordId, ribbon::Accuracy> accuracies;
  if (settings.own.empty()) return accuracies;
  const auto scene = level.make_scene();
  for (const ribbon::box2d::CordId c : scene->coupling().cords()) {
    const auto own = settings.own.find(scene->cord_object(c));
    if (own != settings.own.end()) accuracies[c] = accuracy_of(own->second);
  }
  return accuracies;
}

std::string in_words(const ByCord& by_cord, const LevelFile& file) {
  std::map<std::string, std::string> cords;  // by their setting
  for (const auto& [object, setting] : by_cord.settings.own) {
    std::string& names = cords[name_of(setting)];
    names += (names.empty() ? "" : ", ") + file.name_of_object(object);
  }
  std::string words;
  for (const auto& [setting, names] : cords) words.append(names).append(": ").append(setting).append("; ");
  return words + "all others: " + name_of(by_cord.settings.common) + ": work " + fixed(by_cord.outcome.work, 0) +
         " per tick, " + significant(by_cord.common_work / by_cord.outcome.work, 3) +
         " times less than with one setting for all, error " + significant(by_cord.outcome.error_m, 3) + " m";
}

}  // namespace study
