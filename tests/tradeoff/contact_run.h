#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tests/support/coupled_world.h"
#include "tests/tradeoff/scenes.h"

namespace tradeoff {

/// A way of making cords, by name.
struct NamedMethod {
  std::string method;   ///< cord, box2d_chain, thesis
  std::string setting;  ///< balanced, substeps=4 iterations=8/3
  test_support::CordMethod how;
};

/// The presets named.
std::vector<NamedMethod> presets(const std::vector<std::string>& names);
/// Box2D's chains, with substeps of 8 and 3 iterations.
std::vector<NamedMethod> chains(const std::vector<int>& substeps, bool meets_itself = false);
/// The thesis's cords, with so many iterations and springs that give back so much (see CordMethod): its own k was 0.45.
std::vector<NamedMethod> thesis_cords(const std::vector<int>& substeps, double spring_share);
/// Both lists, one after the other.
std::vector<NamedMethod> together(std::vector<NamedMethod> a, const std::vector<NamedMethod>& b);

/// What a scene sets up.
using SetUp = std::function<void(test_support::CoupledWorld&)>;

/// What came of some ticks.
struct ContactFigures {
  double max_stretch = 0.0;  ///< of a rope, the most after any tick, as a share
  double energy_gain = 0.0;  ///< the most that energy rose above the lowest before, as a share of energy_scale
  double penetration = 0.0;  ///< m, the most after any tick
  int unconverged = 0;       ///< ticks in which a substep of a cord's island was left unconverged, of all cords; of the
                             ///< thesis's, in which one was left to the springs
  int mended = 0;            ///< the same of searches, fallbacks, energy gains and halvings; of points held back
  int blew_up = 0;  ///< the tick, from 1, in which a point was no number or 10 km away: the last one run; 0: none
  int self_crossings = 0;  ///< these three after the last tick
  int mutual_crossings = 0;
  int inverted = 0;
};

/// Runs on.
ContactFigures run(test_support::CoupledWorld& world, int ticks,
                   const std::function<void(test_support::CoupledWorld&)>& after_tick = {});

/// The cells for contact_columns: the cost of our part of a tick, and the results; crossings only for cords with
/// self-contact or contact with each other. Further cells follow.
std::vector<double> figures_of(const test_support::CoupledWorld& world, const ContactFigures& figures,
                               std::optional<double> bar_us = std::nullopt);

/// A world that is set up again before every repeat, or one that continues after its figures.
struct ContactContestant {
  NamedMethod method;
  std::string group;
  SetUp set_up;
  bool goes_on = false;
  ribbon::Vec2 gravity{0.0, -9.81};
  /// Finds the figures in a world just set up.
  std::function<std::vector<double>(test_support::CoupledWorld&)> figures;
};
Contestant contestant(const ContactContestant& how);

/// A note for the reports of all scenes with contacts.
inline constexpr const char* thesis_strip =
    "The thesis's cord is a strip of square cells, a link wide, and has no friction; penetration is into the strip.";
inline constexpr const char* no_b2_rope = "b2Rope meets no bodies, and takes no part.";

/// The whole tick, our share of it and b2World::Step's, then what came of it. `more` are the names of further figures.
std::vector<Column> contact_columns(const std::vector<std::string>& more = {});

}  // namespace tradeoff
