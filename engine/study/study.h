#pragma once

#include <box2d/box2d.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ribbon/box2d/coupling.h"
#include "ribbon/cord_def.h"

/// Which accuracy the cords of a game should have: measures the error and the cost of several in a scene of the game.
namespace ribbon::study {

/// A run of a scene, before its first tick.
struct Scene {
  b2World& world;             ///< in which the cords are
  box2d::Coupling& coupling;  ///< of the cords in this world
  /// Plays tick 0, 1, 2 … with the same input in every run. It owns what the references refer to.
  std::function<void(int tick)> tick;
};

/// Makes the scene anew. All runs of it must be the same.
using MakeScene = std::function<Scene()>;

/// A setting of all cords of the direct solver.
struct Setting {
  std::string name;                    ///< in tables
  std::optional<Accuracy> accuracy{};  ///< none: each cord's own
};

/// Returns the cords' own, the three presets, and one step from each.
std::vector<Setting> settings();

/// What is measured.
struct Options {
  std::vector<Setting> settings = study::settings();  ///< that are compared
  int windows = 4;  ///< number of quarters of a second that are compared too, see measure(), 0 … 1000
  int repeats = 5;  ///< number of timed runs of each setting, 1 … 1000
};

/// The results of a setting.
struct Measured {
  Setting setting;  ///< that was measured
  /// m, the larger of the RMS errors of the cords' points and of the dynamic bodies, from the start and in windows.
  /// Smaller errors than ten times the difference of two converged runs are set to that.
  double error_m = 0.0;
  double work = 0.0;       ///< counted work of the cords, mean over the ticks: IslandReport::work
  double most_work = 0.0;  ///< of the tick with the most
  double median_us = 0.0;  ///< of a tick of the game: of each tick the median over the repeats, of these the median
  double most_us = 0.0;    ///< of these the greatest
  std::string failure{};   ///< why it does not count: not converged in all ticks, blown up; empty if it counts
};

/// The results of a scene.
struct Study {
  int ticks = 0;                   ///< number that was played
  int compared_ticks = 0;          ///< from the start on; after these the motion is too sensitive
  double compared_cords = 0;       ///< share of the windows' ticks in which cords are compared
  double compared_bodies = 0;      ///< share of the windows' ticks in which bodies are compared
  double agreement_m = 0.0;        ///< largest RMS difference of two converged runs in the compared ticks
  std::vector<Measured> settings;  ///< in the order of Options::settings

  /// Returns the settings for which no other one has both less work and a smaller error, by increasing work.
  std::vector<std::size_t> front() const;
  /// Returns the setting with the least work whose error is at most 0.8 · max_error_m; the rest is a margin for other
  /// inputs. None if there is none. It is the same setting on every machine.
  std::optional<std::size_t> cheapest_within(double max_error_m) const;
  /// Returns a table of the settings as lines of text.
  std::string table() const;
};

/// Measures settings in the first `ticks` ticks of a scene. Errors are relative to a converged run (64 substeps;
/// another one with 32 must agree to 0.1 mm) for as long as the motion is not so sensitive that runs whose velocities
/// differ by 4 mm/s are 1 cm apart. Because much of a game is after that, errors are also measured in windows of a
/// quarter of a second along the run, each from the state that the cords' own setting reaches, after a quarter with 16
/// substeps.
///
/// Work is the same on every machine; times are those of whole ticks, for settings in turn. Costs, in ticks, some 200
/// times their number. Throws DefinitionError for a value out of range, and CallError without a function, for a scene
/// without a cord of the direct solver, and for one of which two runs differ: use no clock, and seed random numbers.
Study measure(const MakeScene& make, int ticks, const Options& options = {});

/// Returns the worst of studies of the same settings, with other inputs: of each setting the largest error, the largest
/// work and times, and the first failure. An input that touches no cord says nothing of one that does; so measure
/// several, and recommend by the worst. Throws DefinitionError if the studies have different settings, or without any.
Study worst_of(const std::vector<Study>& studies);

}  // namespace ribbon::study
