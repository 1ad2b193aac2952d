#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tests/study/level_study.h"

namespace study {

/// m. What a recommendation is for if nothing is asked for.
inline constexpr double default_error = 1e-2;

/// What a recommended setting must meet; a limit that is not given is met.
struct Limits {
  std::optional<double> max_error_m{};
  std::optional<double> median_us{};  ///< of a tick
  std::optional<double> p99_us{};     ///< 99th percentile of the ticks, from counted work
  std::optional<double> most_us{};    ///< the greatest tick, from counted work
  std::optional<double> most_work{};  ///< the greatest tick, counted work

  bool any() const { return max_error_m || has_budget(); }
  bool has_budget() const { return median_us || p99_us || most_us || most_work; }
};

/// What counted work costs on a machine: a tick takes base_us + us_per_work · work.
struct Calibration {
  double base_us = 0.0;           ///< of a tick without cords
  double us_per_work = 0.0;       ///< per unit of IslandReport::work
  double rank_correlation = 1.0;  ///< of time and work, Spearman's; samples of equal work (±1 %) count as one

  double us(double work) const { return base_us + us_per_work * work; }
};

/// Time and counted work per tick.
struct Sample {
  double work = 0.0;
  double us = 0.0;
};

/// Fits the samples, of equal relative errors, with a base and a slope of at least 0. Without samples all is 0.
Calibration calibrate(std::span<const Sample> samples);
/// The same for a study's settings of the direct solver: mean work and mean time of the ticks, of the repeat that took
/// the least.
Calibration calibrate(const Study& study);

/// The choice among the settings of a study.
struct Choice {
  std::optional<std::size_t> setting;  ///< meets all limits with the margin of a recommendation
  std::optional<std::size_t> nearest;  ///< without such a setting: the one that exceeds a limit by the smallest factor
  double excess = 0.0;                 ///< the nearest one's value relative to the usable part of its worst limit
};

/// Chooses among the level's own cords (see applicable): with max_error_m the cheapest setting, one that spends its
/// budget of work only if no other one meets the limits, and then one with ample_work if there is one; else the most
/// exact one.
Choice choose(const Study& study, const Limits& limits, const Calibration& calibration);

/// Returns what is recommended for the limits where a setting is chosen: with max_error_m with ample_work, because
/// other players may press cords together more than those of the study. One that spends its budget is recommended as it
/// is.
Setting recommended_for(const Limits& limits, const Measured& chosen);

/// Returns the limits in words: "an error of 0.01 m and a greatest tick of 300 us".
std::string in_words(const Limits& limits);

/// Returns what is recommended for the limits where a setting is chosen, with its costs and its error in words.
std::string in_words(const Study& study, std::size_t chosen, const Calibration& calibration, const Limits& limits);

}  // namespace study
