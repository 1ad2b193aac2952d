#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tests/tradeoff/measure.h"

namespace tradeoff {

/// A method and setting that runs a scene.
struct Variant {
  std::string method;   ///< cord, box2d_chain, dense_inverse
  std::string setting;  ///< substeps=8
  int points = 0;
  std::function<void()> reset;  ///< see Timed
  Tick tick;
  std::function<std::vector<double>()> figures;  ///< the results for the scene's columns, computed before any timing;
                                                 ///< empty if there are no such columns
  Tick rest = {};                                ///< see Timed
  std::string group = {};                        ///< part of the scene: ratio=100
  std::function<std::int64_t()> work = {};       ///< IslandReport::work of the last tick; empty if not counted
};

/// The results of a variant.
struct Row {
  const Variant& variant;
  Timing timing;
  std::vector<double> figures;
};

struct Column {
  std::string name;
  int decimals = 0;                         ///< below 0: four significant digits instead
  std::function<double(const Row&)> value;  ///< NaN leaves the cell empty
};

Column us_per_tick();
Column p99_us();
Column frames_per_second();
// For variants that time the rest of a tick separately, see Timing:
Column cords_us();
Column cords_max_us();
Column world_step_us();
/// Returns the column of the index-th figure.
Column figure(std::string name, std::size_t index);

/// Formats a number as in a setting: 0.001, 1e+08, inf.
std::string number(double value);

/// A scene and its variants, which are timed in turn.
struct Scene {
  std::string name;
  std::string description;
  int ticks = 0;  ///< per repeat
  std::function<std::vector<Variant>()> variants;
  std::vector<Column> columns = {us_per_tick(), p99_us()};
  /// The setting whose cost is 1 in the last column of the table; empty: that of the first row.
  std::string reference_setting = {};
  std::vector<std::string> notes = {};  ///< sentences for its report: which variants are missing, and why
  std::vector<std::string> slow = {};   ///< settings that a quick report leaves out
  int report_repeats = 9;               ///< default for the standard report
  int counted_ticks = 0;                ///< for the baseline of work if `ticks` would take too long; 0: `ticks`
};

const std::vector<Scene>& scenes();
/// Returns null for an unknown name.
const Scene* find_scene(const std::string& name);

}  // namespace tradeoff
