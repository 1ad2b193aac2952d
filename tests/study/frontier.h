#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace study {

/// What a setting came to.
struct Point {
  std::string method;                                         ///< direct, thesis
  std::string setting;                                        ///< tr_bdf2 substeps=1 tolerance=0.0005
  double cost_us = 0.0;                                       ///< a tick, the median
  double p99_us = 0.0;                                        ///< that 99 of 100 ticks stay below
  double error_m = std::numeric_limits<double>::quiet_NaN();  ///< the greatest of the errors that are lengths
  std::string failure = {};                                   ///< why it does not count; empty if it does
  bool apart = false;      ///< its error is relative to another motion: reported, never compared
  std::string group = {};  ///< what was simulated, if a report has several such: ratio=100. Groups are not compared
};

/// The names of the points' groups, each once, in their order.
std::vector<std::string> groups_of(std::span<const Point> points);

/// The share of a limit that a setting may use when it is measured. The rest is a margin for other runs and machines.
inline constexpr double kept_error = 0.8;
inline constexpr double kept_budget = 0.75;

/// Those that no other of their group is both cheaper and more exact than: group by group, by rising cost. What failed
/// or stands apart is never among them.
std::vector<std::size_t> front(std::span<const Point> points);

/// What the front says of our methods against the others, in sentences: where one of those is on it, at which errors,
/// and what ours cost there; or that none is. Empty if either are missing.
std::vector<std::string> who_is_ahead(std::span<const Point> points,
                                      const std::function<bool(const std::string& method)>& is_ours);

/// The cheapest whose error is at most kept_error · `most_error` [m].
std::optional<std::size_t> cheapest_within(std::span<const Point> points, double most_error);

/// The most exact whose cost is at most kept_budget · `budget_us`.
std::optional<std::size_t> most_exact_within(std::span<const Point> points, double budget_us);

}  // namespace study
