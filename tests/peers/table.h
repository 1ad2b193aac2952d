#pragma once

#include <limits>
#include <map>
#include <string>
#include <vector>

#include "tests/peers/contestants.h"
#include "tests/peers/judge.h"
#include "tests/study/report.h"

namespace peers {

/// What a setting came to in a scene.
struct Result {
  std::string engine;
  std::string setting;
  std::string group;
  double cost_us = Figures::none;  ///< a tick, the median
  double p99_us = Figures::none;   ///< that 99 of 100 ticks stay below
  double error_m = Figures::none;  ///< Scene::error
  Figures figures{};
  std::string failure{};  ///< why it does not count; empty if it does
};

/// By the name of its scene.
using Results = std::map<std::string, std::vector<Result>>;

/// A line a setting and scene, `names` in their order.
std::string csv_of(const std::vector<std::string>& names, const Results& results);

/// Returns Markdown: the engines, and two tables with a row per engine and a column per scene. A cell has the ends of
/// the engine's Pareto front, its cheapest and its most exact setting: error, and cost relative to that of `balanced`.
std::string table_of(const std::vector<Engine>& engines, const std::vector<std::string>& names, const Results& results);

/// A page with a plot of error against cost.
study::Report report_of(const std::string& name, const std::vector<Engine>& engines,
                        const std::vector<Result>& results);

}  // namespace peers
