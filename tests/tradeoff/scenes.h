#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tests/tradeoff/measure.h"

namespace tradeoff {

/// One way of running a scene.
struct Contestant {
  std::string method;   ///< cord, box2d_chain, dense_inverse
  std::string setting;  ///< substeps=8
  int points = 0;
  std::function<void()> reset;  ///< see Timed
  Tick tick;
  std::function<std::vector<double>()> figures;  ///< what comes of it, found before any timing: those that the scene's
                                                 ///< columns ask for. Empty if they ask for none
  Tick rest = {};                                ///< see Timed
  std::string group = {};                        ///< what it simulates, if a scene has several such: ratio=100
  std::function<std::int64_t()> work = {};       ///< CordReport::work of the last tick; empty if it counts none
};

/// The results of a contestant.
struct Row {
  const Contestant& contestant;
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
// For contestants that time the rest of a tick separately, see Timing:
Column our_us();
Column our_worst_us();
Column world_step_us();
/// The index-th of a contestant's figures.
Column figure(std::string name, std::size_t index);

/// As it stands in a setting: 0.001, 1e+08, inf.
std::string number(double value);

/// A scene and the ways of running it, to be timed side by side.
struct Scene {
  std::string name;
  std::string description;
  int ticks = 0;  ///< a repeat
  std::function<std::vector<Contestant>()> contestants;
  std::vector<Column> columns = {us_per_tick(), p99_us()};
  std::string yardstick = {};  ///< the setting whose cost is 1 in the last column of the table; empty: the first row's
  std::vector<std::string> notes = {};  ///< sentences for its report: which contestants are missing, and why
  std::vector<std::string> slow = {};   ///< settings that a quick report leaves out
  int report_repeats = 9;               ///< of the standard report, unless others are asked for
  int counted_ticks = 0;                ///< of the baseline of work, where `ticks` would take long; 0: as many as those
};

const std::vector<Scene>& scenes();
/// Null if there is none of that name.
const Scene* find_scene(const std::string& name);

}  // namespace tradeoff
