#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tests/support/coupled_world.h"
#include "tests/tradeoff/scenes.h"

namespace tradeoff {

/// A representation of cords, with its name.
struct NamedMethod {
  std::string method;   ///< cord, box2d_chain, thesis
  std::string setting;  ///< balanced, substeps=4 iterations=8/3
  test_support::CordMethod how;
};

/// Returns the presets with these names.
std::vector<NamedMethod> presets(const std::vector<std::string>& names);
/// Returns Box2D's chains, with substeps of 8 and 3 iterations.
std::vector<NamedMethod> chains(const std::vector<int>& substeps, bool self_contact = false);
/// Returns cords of the thesis with numbers of iterations and spring shares (see CordMethod). The thesis uses k = 0.45.
std::vector<NamedMethod> thesis_cords(const std::vector<int>& substeps, double spring_share);
/// Returns both lists, one after the other.
std::vector<NamedMethod> together(std::vector<NamedMethod> a, const std::vector<NamedMethod>& b);

/// Sets up a scene.
using SetUp = std::function<void(test_support::CoupledWorld&)>;

/// The results of some ticks.
struct ContactFigures {
  double max_stretch = 0.0;  ///< of a rope, relative, maximum after any tick
  double energy_gain =
      0.0;  ///< maximum rise above the lowest earlier energy, relative to energy_scale; inf if that is 0
  double penetration = 0.0;  ///< m, maximum after any tick
  int unconverged = 0;       ///< ticks with an unconverged substep of a cord's island, summed over cords; for the
                             ///< thesis's method with one that only the springs solved
  int corrected = 0;         ///< the same with searches, fallbacks, energy gains and halvings; with limited motion
  int blew_up = 0;         ///< the tick, from 1, in which a point was NaN or 10 km away, which is the last one; 0: none
  int self_crossings = 0;  ///< this and the next two after the last tick
  int mutual_crossings = 0;
  int inverted = 0;
};

/// Runs the world for some ticks.
ContactFigures run(test_support::CoupledWorld& world, int ticks,
                   const std::function<void(test_support::CoupledWorld&)>& after_tick = {});

/// The cells for contact_columns: the cost of the cords in a tick, and the results; crossings only for cords with
/// self-contact or contact with each other. Further cells follow.
std::vector<double> figures_of(const test_support::CoupledWorld& world, const ContactFigures& figures,
                               std::optional<double> target_us = std::nullopt);

/// A world that is set up again before every repeat, or one that continues after its figures.
struct ContactVariant {
  NamedMethod method;
  std::string group;
  SetUp set_up;
  bool continues = false;
  ribbon::Vec2 gravity{0.0, -9.81};
  /// Computes the figures in a new world.
  std::function<std::vector<double>(test_support::CoupledWorld&)> figures;
};
Variant variant(const ContactVariant& how);

/// A note for the reports of all scenes with contacts.
inline constexpr const char* thesis_strip =
    "The thesis's cord is a strip of square cells, a link wide, and has no friction; penetration is into the strip.";
inline constexpr const char* no_b2_rope = "b2Rope has no contacts with bodies, and is not included.";

/// Returns the columns: times of the whole tick, of the cords and of b2World::Step, then the results. `more` are the
/// names of further figures.
std::vector<Column> contact_columns(const std::vector<std::string>& more = {});

}  // namespace tradeoff
