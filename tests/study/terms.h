#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/study/level_file.h"
#include "tests/study/trace.h"

namespace study {

/// What a level is without a term that its cords declare.
struct TermResult {
  std::string term;            ///< friction, self_contact
  bool can_do_without = true;  ///< false if such a cord cannot be built
  std::size_t shows_at = 0;    ///< the first tick in which something is a centimetre elsewhere; 0 if nothing is
  Errors change;               ///< as long as nothing is
  double cost_share = 0.0;     ///< of the level's cost
};

/// What a level's cords do that a term would prevent which none of them declares.
struct Symptom {
  std::string what;  ///< cords pass through themselves
  std::string term;  ///< that prevents it
  std::size_t first_tick = 0;
  std::size_t ticks = 0;  ///< in which it is seen
};

struct Terms {
  std::vector<TermResult> declared;
  std::vector<Symptom> lacking;
  std::size_t ticks = 0;  ///< after which what a run does is chance, and nothing is compared
};

/// Takes the declared terms of the cords of the direct solver away, one at a time, and looks for symptoms of those that
/// are not declared.
Terms try_terms(const LevelFile& file, const std::string& replay_path, const std::function<void(double)>& progress);

/// Whether the level needs it, in a sentence.
std::string verdict(const TermResult& result);

}  // namespace study
