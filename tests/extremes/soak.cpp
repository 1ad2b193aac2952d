#include <algorithm>
#include <cmath>
#include <string>

#include "tests/extremes/balls.h"
#include "tests/extremes/table.h"
#include "tests/support/allocations.h"
#include "tests/support/constants.h"

// A lively scene over a long time: its cost and memory must not grow.

namespace extremes {
namespace {

using constants::dt;
using constants::gravity;
using constants::infinity;
using ribbon::Vec2;

/// Allocations of the candidate vectors: one whenever a size exceeds its maximum so far, which becomes rarer with time.
constexpr double most_allocations = 4.0;

#if defined(__SSE2__)
constexpr unsigned met_subnormal = 0x12;  // flags: as an operand, as a result
void forget_subnormals() { __builtin_ia32_ldmxcsr(__builtin_ia32_stmxcsr() & ~met_subnormal); }
bool were_subnormals() { return (__builtin_ia32_stmxcsr() & met_subnormal) != 0; }
#else
void forget_subnormals() {}
bool were_subnormals() { return false; }
#endif

struct Figures {
  double energy = 0.0;       // its range within the last tenth of the ticks, divided by that within the first
  double allocations = 0.0;  // in the second half
  double cost = 0.0;         // Newton steps in the last tenth of the ticks, divided by those in the first
  double peak = 0.0;         // the longest tick, divided by the mean
  double subnormals = 0.0;   // share of ticks
};

ribbon::CordDef cord_of(int rows) {
  ribbon::CordDef def;
  def.points = 21;
  def.rows = rows;
  def.length = 2.0;
  def.width = 0.1 * (rows - 1);
  def.mass_per_length = 0.5;
  def.friction = 0.3;
  def.drag = 0.2;
  if (rows > 1) {
    ribbon::solid(1e6, 0.0, 0.1, def.width).apply_to(def);
    def.damping = 0.01;
    def.area_stiffness = 1.0;
  }
  for (int i = 0; i < def.points; ++i) {
    for (int j = 0; j < rows; ++j) def.positions.push_back({0.1 * j, -0.1 * i});
  }
  for (int j = 0; j < rows; ++j) def.pins.push_back(j);
  return def;
}

/// A cord over a peg, under gravity; its anchor moves along a figure eight of 2 m in 1.7 s.
Figures soak(Method method, int rows, int ticks, Counts& counts, const Scope& scope) {
  TestedCord cord(method, cord_of(rows), dt);
  cord.attach_load(1.0);
  Balls balls;
  balls.add({0.3, -1.2}, 0.15, 0.0);
  const std::vector<Vec2> anchors(cord.positions().begin(), cord.positions().begin() + rows);
  const test_support::AllocationCount allocations;
  long taken = 0;
  long first_cost = 0;
  long last_cost = 0;
  long most_cost = 0;
  double first_peak = 0.0;
  double last_peak = 0.0;
  long subnormal_ticks = 0;
  const int tenth = ticks / 10;
  bool finite = true;
  for (int k = 0; k < ticks && finite; ++k) {
    const double phase = 3.7 * dt * k;
    const Vec2 way{std::sin(phase), 0.5 * std::sin(2.0 * phase)};
    for (int j = 0; j < rows; ++j) cord.operate(j, anchors[static_cast<std::size_t>(j)] + way);
    const int before = cord.counts().direct.iterations;
    forget_subnormals();
    const long held = allocations.so_far();
    balls.step(cord, dt, gravity);
    if (k >= ticks / 2) taken += allocations.so_far() - held;
    if (were_subnormals()) ++subnormal_ticks;
    const long cost = cord.counts().direct.iterations - before;
    const double energy = std::abs(cord.energy(gravity));
    finite = cord.is_finite() && std::isfinite(energy);
    most_cost = std::max(most_cost, cost);
    if (k < tenth) {
      first_cost += cost;
      first_peak = std::max(first_peak, energy);
    } else if (k >= ticks - tenth) {
      last_cost += cost;
      last_peak = std::max(last_peak, energy);
    }
    if (k % 1000 == 0) scope.progress(static_cast<double>(k) / ticks);
  }
  counts += cord.counts();
  if (!finite) return {infinity, infinity, infinity, infinity, infinity};
  Figures figures;
  figures.energy = last_peak / first_peak;
  figures.allocations = static_cast<double>(taken);
  figures.cost = first_cost > 0 ? static_cast<double>(last_cost) / static_cast<double>(first_cost) : 1.0;
  figures.peak = static_cast<double>(most_cost);
  figures.subnormals = static_cast<double>(subnormal_ticks);
  return figures;
}

}  // namespace

std::vector<Row> run_soak(const Scope& scope) {
  std::vector<Row> rows;
  for (const Method method : all_methods) {
    const int ticks = scope.full                   ? 1'000'000
                      : method <= Method::balanced ? 40'000
                      : method == Method::accurate ? 20'000
                                                   : 1'500;
    const std::string what = std::to_string(ticks) + " ticks";
    WorstCase energy(what, "energy, last tenth / first", method, 2.0);
    WorstCase allocations(what, "allocations in 2nd half", method, most_allocations);
    WorstCase cost(what, "Newton steps, last / first", method, 1.25);
    WorstCase peak(what, "Newton steps of a tick", method, method == Method::thesis ? 0.0 : 2500.0);
    WorstCase subnormals(what, "ticks with subnormals", method, 0.0);
    for (const int across : {1, 3}) {
      if (method == Method::thesis && across == 1) continue;
      const std::string setting = across == 1 ? "rope" : "ribbon of 3 rows";
      if (!scope.wants(setting)) continue;
      Counts counts;
      const Figures figures = soak(method, across, ticks, counts, scope);
      energy.take(figures.energy, setting, "gains energy");
      allocations.take(figures.allocations, setting, "takes memory");
      cost.take(figures.cost, setting, "slows down");
      peak.take(figures.peak, setting, "slow");
      subnormals.take(figures.subnormals, setting, "slow");
      for (WorstCase* figure : {&energy, &allocations, &cost, &peak, &subnormals}) figure->add(counts);
    }
    rows.insert(rows.end(), {energy.row(), allocations.row(), cost.row(), peak.row(), subnormals.row()});
  }
  return rows;
}

}  // namespace extremes
