#include "tests/study/by_cord.h"

#include <algorithm>
#include <memory>

#include "tests/study/level_file.h"
#include "tests/study/text.h"

namespace study {
namespace {

/// What a cord alone may have: settings of the search from the cheapest one within the error on.
struct Candidate {
  int cord = 0;
  std::size_t first = 0;  // index of the setting
  double work = 0.0;      // of all cords
};

class Searcher {
 public:
  Searcher(const CordSearch& search, const std::function<Outcome(const CordSettings&)>& judge)
      : search_(&search), judge_(&judge), best_{search.common, search.of_common, search.of_common.work} {}

  CordSearchResult run() {
    for (const int cord : search_->cords) find_alone(cord);
    CordSearchResult result;
    result.least_work = search_->of_common.work;
    if (candidates_.empty()) return result;
    ByCord all = best_;
    for (const Candidate& candidate : candidates_) all.settings.own[candidate.cord] = search_->cheaper[candidate.first];
    all.outcome = judged(all.settings);
    result.least_work = all.outcome.failure.empty() ? all.outcome.work : unavailable;
    if (is_within(all.outcome) && all.outcome.work < best_.outcome.work) {
      best_ = std::move(all);
    } else {
      add_one_by_one();
    }
    drop_what_saves_nothing();
    best_.tried = tried_;
    if (best_.outcome.work < result.least_work) result.least_work = best_.outcome.work;
    if (best_.outcome.work < search_->of_common.work) result.found = std::move(best_);
    return result;
  }

 private:
  Outcome judged(const CordSettings& settings) {
    ++tried_;
    return (*judge_)(settings);
  }

  bool is_within(const Outcome& outcome) const {
    return outcome.failure.empty() && outcome.error_m <= search_->max_error_m;
  }

  void find_alone(int cord) {
    for (std::size_t k = 0; k < search_->cheaper.size(); ++k) {
      CordSettings alone = search_->common;
      alone.own[cord] = search_->cheaper[k];
      const Outcome outcome = judged(alone);
      if (!is_within(outcome)) continue;
      candidates_.push_back({cord, k, outcome.work});
      return;
    }
  }

  void add_one_by_one() {
    std::stable_sort(candidates_.begin(), candidates_.end(),
                     [](const Candidate& a, const Candidate& b) { return a.work < b.work; });
    for (const Candidate& candidate : candidates_) {
      for (std::size_t k = candidate.first; k < search_->cheaper.size(); ++k) {
        CordSettings more = best_.settings;
        more.own[candidate.cord] = search_->cheaper[k];
        Outcome outcome = judged(more);
        if (!is_within(outcome) || outcome.work > best_.outcome.work) continue;
        best_.settings = std::move(more);
        best_.outcome = std::move(outcome);
        break;
      }
    }
  }

  /// A cord that shares its island with one of the common setting.
  void drop_what_saves_nothing() {
    for (const Candidate& candidate : candidates_) {
      CordSettings fewer = best_.settings;
      if (fewer.own.erase(candidate.cord) == 0) continue;
      Outcome outcome = judged(fewer);
      if (!is_within(outcome) || outcome.work > best_.outcome.work) continue;
      best_.settings = std::move(fewer);
      best_.outcome = std::move(outcome);
    }
  }

  const CordSearch* search_;
  const std::function<Outcome(const CordSettings&)>* judge_;
  std::vector<Candidate> candidates_;  // a cord each
  ByCord best_;
  int tried_ = 0;
};

}  // namespace

CordSearchResult find_by_cord(const CordSearch& search, const std::function<Outcome(const CordSettings&)>& judge) {
  return Searcher(search, judge).run();
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
