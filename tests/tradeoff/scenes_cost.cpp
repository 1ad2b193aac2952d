#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>

#include "ribbon/cord.h"
#include "tests/support/thesis_scenes.h"
#include "tests/tradeoff/scene_lists.h"

namespace tradeoff {
namespace {

using ribbon::Accuracy;
using ribbon::Cord;
using ribbon::CordDef;
using ribbon::IslandReport;
using ribbon::Vec2;
using test_support::earth_gravity;
using test_support::frame_dt;

/// Cords that are stepped one after the other, and their reports since the last reset.
class CordBatch {
 public:
  CordBatch(const Cord& start, int count) : state_(start.save()) {
    for (int k = 0; k < count; ++k) cords_.emplace_back(start.def());
    reset();
  }

  void reset() {
    for (Cord& cord : cords_) cord.restore(state_);
    report_ = {};
  }

  void tick() {
    const std::int64_t before = report_.work;
    for (Cord& cord : cords_) report_ += cord.step(frame_dt, earth_gravity);
    work_ = report_.work - before;
  }

  int points() const { return static_cast<int>(cords_.size()) * cords_.front().size(); }
  const IslandReport& report() const { return report_; }
  /// Returns the work of the last tick.
  std::int64_t work() const { return work_; }

 private:
  std::vector<Cord> cords_;
  Cord::State state_;
  IslandReport report_;
  std::int64_t work_ = 0;
};

/// Figures of a whole repeat: Newton iterations per tick and cord, corrections, and unconverged substeps.
Variant variant(const char* method, std::string setting, const Cord& start, int count, int ticks) {
  const auto batch = std::make_shared<CordBatch>(start, count);
  return {method,
          std::move(setting),
          batch->points(),
          [batch] { batch->reset(); },
          [batch] { batch->tick(); },
          [batch, count, ticks] {
            batch->reset();
            for (int k = 0; k < ticks; ++k) batch->tick();
            const IslandReport& report = batch->report();
            return std::vector<double>{static_cast<double>(report.iterations) / (count * ticks),
                                       static_cast<double>(report.searches + report.fallbacks + report.energy_gains),
                                       static_cast<double>(report.unconverged)};
          },
          {},
          {},
          [batch] { return batch->work(); }};
}

constexpr int scaling_ticks = 20;

/// A cord straight down from its pin, with links of 0.2 m as in heavy_swing.
CordDef plumb_line(int points) {
  CordDef def;
  def.points = points;
  def.length = 0.2 * (points - 1);
  for (int p = 0; p < points; ++p) def.positions.push_back({0.0, -0.2 * p});
  def.pins = {0};
  return def;
}

/// Sets sideways velocities up to 1 m/s.
Cord swaying(int points) {
  Cord cord(plumb_line(points));
  for (int p = 0; p < points; ++p) cord.set_velocity(p, {std::sin(2.0 * std::numbers::pi * p / points), 0.0});
  return cord;
}

/// A load with the cord's mass is struck. The disturbance decays from link to link to irrelevant numbers, of which
/// those below 1e-308 are slow to compute with.
Cord struck(int points) {
  const CordDef def = plumb_line(points);
  Cord cord(def);
  cord.attach_mass(points - 1, def.mass_per_length * def.length);
  cord.set_velocity(points - 1, {5.0, 0.0});
  return cord;
}

std::vector<Variant> cord_scaling() {
  std::vector<Variant> list;
  for (const int points : {50, 500, 5000, 50000}) {
    list.push_back(variant("rope", "balanced swaying", swaying(points), 1, scaling_ticks));
  }
  for (const int points : {50, 500, 5000}) {
    list.push_back(variant("rope", "balanced struck", struck(points), 1, scaling_ticks));
  }
  return list;
}

Column ns_per_point_and_iteration() {
  return {"ns_per_point_and_iteration", 2,
          [](const Row& row) { return 1e3 * row.timing.median_us / (row.variant.points * row.figures[0]); }};
}

constexpr int ribbon_ticks = 120;

/// A strip of rubber, held by its first column and released from the horizontal: E = 1 MPa, 1 cm thick, 2 g per point.
Cord swinging_ribbon(int columns, int rows, double width, double modulus, const Accuracy& accuracy) {
  CordDef def;
  def.points = columns;
  def.rows = rows;
  def.length = 0.05 * (columns - 1);
  def.width = width;
  def.mass_per_length = 0.002 * columns * rows / def.length;
  ribbon::solid(modulus, 0.3, 0.01, def.width).apply_to(def);
  def.accuracy = accuracy;
  def.pins.resize(static_cast<std::size_t>(rows));
  std::iota(def.pins.begin(), def.pins.end(), 0);
  return Cord(def);
}

std::vector<Variant> ribbons() {
  const Accuracy balanced = Accuracy::balanced();
  const Accuracy fast = Accuracy::fast();
  return {variant("25x2", "balanced", swinging_ribbon(25, 2, 0.05, 1e5, balanced), 1, ribbon_ticks),
          variant("10x5", "balanced", swinging_ribbon(10, 5, 0.2, 1e4, balanced), 1, ribbon_ticks),
          variant("150 of 33x2", "fast", swinging_ribbon(33, 2, 0.05, 1e5, fast), 150, ribbon_ticks)};
}

}  // namespace

std::vector<Scene> cost_scenes() {
  return {
      {"cord_scaling",
       "hanging ropes of 50 to 50,000 points: cost per point and Newton iteration",
       scaling_ticks,
       cord_scaling,
       {us_per_tick(), p99_us(), figure("iterations_per_tick", 0), ns_per_point_and_iteration(),
        figure("unconverged", 2)}},
      {"ribbons",
       "a ribbon of 25 x 2 points, one of 10 x 5, and 150 of 33 x 2, swinging: a tick of all of them",
       ribbon_ticks,
       ribbons,
       {us_per_tick(), p99_us(), figure("iterations_per_tick", 0), figure("corrected", 1), figure("unconverged", 2)}},
  };
}

}  // namespace tradeoff
