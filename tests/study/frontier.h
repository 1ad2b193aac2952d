#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ribbon/study/conditions.h"

namespace study {

/// The result of a setting.
struct Point {
  std::string method;                                         ///< direct, thesis
  std::string setting;                                        ///< tr_bdf2 substeps=1 tolerance=0.0005
  double cost_us = 0.0;                                       ///< per tick, median
  double p99_us = 0.0;                                        ///< per tick, 99th percentile
  double error_m = std::numeric_limits<double>::quiet_NaN();  ///< largest of the errors that are lengths
  std::string failure = {};                                   ///< why it does not count; empty if it counts
  bool not_compared = false;  ///< its error is relative to another motion: reported, never compared
  std::string group = {};     ///< part of the scene: ratio=100. Groups are not compared
};

/// Returns whether the error of a result counts: the setting did not fail, and its error is a number.
bool is_compared(const Point& point);

/// Returns the names of the points' groups, each once, in their order.
std::vector<std::string> groups_of(std::span<const Point> points);

using ribbon::study::usable_error_share;
/// The share of a budget that a setting may use where it was measured. The rest is a margin for other machines.
inline constexpr double usable_budget_share = 0.75;

/// Returns the Pareto front of each group, by increasing cost: the points for which no other one is both cheaper and
/// more exact. Failed and separate points are excluded.
std::vector<std::size_t> front(std::span<const Point> points);

/// Returns sentences that compare our methods with the others: where another method is on the front, at which errors,
/// and what ours cost there; or that none is. Empty if either are missing.
std::vector<std::string> compare_with_baselines(std::span<const Point> points,
                                                const std::function<bool(const std::string& method)>& is_ours);

/// Returns the cheapest point with an error up to usable_error_share · `max_error` [m].
std::optional<std::size_t> cheapest_within(std::span<const Point> points, double max_error);

/// Returns the most exact point with a cost up to usable_budget_share · `budget_us`.
std::optional<std::size_t> most_exact_within(std::span<const Point> points, double budget_us);

}  // namespace study
