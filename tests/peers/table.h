#pragma once

#include <limits>
#include <map>
#include <string>
#include <vector>

#include "tests/peers/figures.h"
#include "tests/peers/variants.h"
#include "tests/study/report.h"

namespace peers {

/// The result of a setting in a scene.
struct Result {
  std::string engine;
  std::string setting;
  std::string group;
  double cost_us = Figures::none;  ///< per tick, median
  double p99_us = Figures::none;   ///< per tick, 99th percentile
  double error_m = Figures::none;  ///< Scene::error
  Figures figures{};
  std::string failure{};  ///< why it does not count; empty if it counts
};

/// By name of the scene.
using Results = std::map<std::string, std::vector<Result>>;

/// Returns CSV with a line per setting and scene, in the order of `names`.
std::string csv_of(const std::vector<std::string>& names, const Results& results);

/// Returns Markdown: the engines, and two tables with a row per engine and a column per scene. A cell has the ends of
/// the engine's Pareto front, its cheapest and its most exact setting: error, and cost relative to that of `balanced`.
std::string table_of(const std::vector<Engine>& engines, const std::vector<std::string>& names, const Results& results);

/// Returns a page with a plot of error against cost.
study::Report report_of(const std::string& name, const std::vector<Engine>& engines,
                        const std::vector<Result>& results);

}  // namespace peers
