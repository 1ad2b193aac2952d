#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/study/level_file.h"
#include "tests/study/trace.h"

namespace study {

/// What a level is without a term that its cords declare, or with one that none of them does.
struct TermResult {
  std::string term;  ///< friction, self_contact
  bool declared = true;
  bool can_be_built = true;     ///< false if there is no such cord
  std::size_t shows_at = 0;     ///< the first tick in which something is a centimetre elsewhere; 0 if nothing is
  Errors change;                ///< as long as nothing is
  double cost_share = lacking;  ///< of the level's cost
};

/// What a level's cords do that a term would prevent which none of them declares.
struct Symptom {
  std::string what;  ///< cords pass through themselves
  std::string term;  ///< that prevents it
  std::size_t first_tick = 0;
  std::size_t ticks = 0;  ///< in which it is seen
};

struct Terms {
  std::vector<TermResult> results;  ///< of what is declared, and then of what is not
  std::vector<Symptom> lacking;
  std::size_t ticks = 0;  ///< after which what a run does is chance, and nothing is compared
};

/// Takes the declared terms of the cords of the direct solver away, one at a time; switches those on that are not
/// declared and have one natural value (contacts, tension_only of ropes, area_stiffness 1 of ribbons); and
/// looks for symptoms of what is not declared.
Terms try_terms(const LevelFile& file, const std::string& replay_path, const std::function<void(double)>& progress);

/// Whether the level needs it, in a sentence.
std::string verdict(const TermResult& result);

/// Whether a link of a cord pushes that would not with tension_only: a rope's, by more than a thousandth of the cord's
/// weight.
bool pushes(const ribbon::Cord& cord, double gravity);

}  // namespace study
