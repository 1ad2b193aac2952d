#include <array>
#include <cmath>
#include <numbers>

#include "game/lab/scene_list.h"

namespace game::lab {
namespace {

using ribbon::Vec2;

constexpr int column_points = 22;                              // of which the first two are clamped
constexpr double column_height = 2.0;                          // m
constexpr double between_columns = 1.1;                        // m, from one column to the next
constexpr std::array shares = {0.80, 0.95, 1.05, 1.20, 1.50};  // of the load that the knob sets

/// The load at which a clamped–free chain of n free links buckles: (EI/l)·(D·θ) = P·l·θ with D of the fixed–free chain,
/// whose least eigenvalue is 4·sin²(π/(2(2n + 1))).
double critical_load(double bending_stiffness) {
  const double link = column_height / (column_points - 1);
  const double s = std::sin(std::numbers::pi / (2.0 * (2 * (column_points - 2) + 1)));
  return 4.0 * bending_stiffness / (link * link) * s * s;
}

void load(Bench& bench, const KnobValues& values) {
  for (std::size_t k = 0; k < shares.size(); ++k) {
    const double force = shares[k] * values[Knob::load_share] * critical_load(values[Knob::bending]);
    bench.coupling().cord(static_cast<int>(k)).direct().set_load(column_points - 1, {0.0, -force});
  }
}

void build_columns(Bench& bench, const KnobValues& values, Vec2) {
  for (std::size_t k = 0; k < shares.size(); ++k) {
    const double x = between_columns * (static_cast<double>(k) - 0.5 * (shares.size() - 1));
    ribbon::CordDef def;
    def.points = column_points;
    def.length = column_height;
    def.radius = 0.025;
    def.stretch_stiffness = values[Knob::stretch];
    def.bending_stiffness = values[Knob::bending];
    def.drag = values[Knob::air_drag];
    def.pins = {0, 1};
    def.positions = straight(column_points, {x, 0.0}, {0.0, column_height});
    def.accuracy = accuracy_of(values);
    bench.add(def);
    // A column that stays exactly straight would not show that it could buckle.
    bench.coupling().cord(static_cast<int>(k)).direct().set_velocity(column_points - 1, {0.3, 0.0});
  }
  load(bench, values);
}

void tune_columns(Bench& bench, const KnobValues& values) {
  bench.change_cords([&](ribbon::CordDef& def) { def.drag = values[Knob::air_drag]; });
  load(bench, values);
}

std::vector<Reading> readings_of_columns(const Bench& bench, const KnobValues& values) {
  return {{Reading::Kind::critical_load, critical_load(values[Knob::bending])},
          {Reading::Kind::unconverged, 1.0 * unconverged(bench)}};
}

/// The arrows are as long as the loads are large, relative to the critical one.
std::vector<ShownForce> forces(const Bench& bench, const KnobValues& values) {
  std::vector<ShownForce> list;
  for (std::size_t k = 0; k < shares.size(); ++k) {
    const double share = shares[k] * values[Knob::load_share];
    const auto x = bench.coupling().cord(static_cast<int>(k)).positions();
    list.push_back({x.back(), {0.0, -0.35 * share}, x.front() - Vec2{0.0, 0.15}, share});
  }
  return list;
}

}  // namespace

Scene buckling() {
  using Scale = KnobRange::Scale;
  return {.name = "buckling",
          .low = {-3.1, -1.0},
          .high = {4.3, 2.6},
          .knobs = together({{Knob::load_share, 0.0, 2.0, 1.0},
                             {Knob::bending, 0.1, 100.0, 1.0, Scale::logarithmic},
                             stretch_knob(1e3, 1e8),
                             {Knob::air_drag, 0.0, 5.0, 1.0}},
                            accuracy_knobs(1)),
          .gravity = {},
          .build = build_columns,
          .tune = tune_columns,
          .readings = readings_of_columns,
          .forces = forces};
}

}  // namespace game::lab
