#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "tests/study/errors.h"
#include "tests/study/level_file.h"

namespace study {

/// The result of a level without a declared term, or with one that no cord declares.
struct TermResult {
  std::string term;  ///< friction, self_contact
  bool declared = true;
  bool can_be_built = true;          ///< false if no cord can have the term
  std::size_t first_difference = 0;  ///< first tick with a displacement of 1 cm; 0 if there is none
  Errors change;                     ///< before that tick
  double cost_share = unavailable;   ///< relative to the level's cost
};

/// A motion of a level's cords that an undeclared term would prevent.
struct Symptom {
  std::string what;  ///< cords pass through themselves
  std::string term;  ///< that prevents it
  std::size_t first_tick = 0;
  std::size_t ticks = 0;  ///< number of ticks with it
};

struct Terms {
  std::vector<TermResult> results;  ///< of declared terms, then of undeclared ones
  std::vector<Symptom> missing;
  std::size_t ticks = 0;  ///< compared ticks; after them the motion is too sensitive (see comparable_ticks)
};

/// Removes the declared terms of the cords of the direct solver, one at a time; adds undeclared ones with one natural
/// value (contacts, tension_only of ropes, area_stiffness 1 of ribbons); and looks for symptoms of undeclared terms.
Terms try_terms(const LevelFile& file, const std::string& replay_path, const std::function<void(double)>& progress);

/// Returns the number of ticks before the motion is too sensitive to compare paths: the rule of settings' errors (see
/// ribbon::study::probe_kick).
std::size_t comparable_ticks(const LevelFile& file, std::span<const engine::TickInput> inputs);

/// Returns a sentence on whether the level needs the term.
std::string verdict(const TermResult& result);

/// Returns whether a link of a rope without tension_only pushes by more than a thousandth of the cord's weight.
bool pushes(const ribbon::Cord& cord, double gravity);

}  // namespace study
