#include "game/lab/scene_list.h"

namespace game::lab {
namespace {

using ribbon::Vec2;

constexpr double bridge_length = 4.2;  // m
constexpr double span = 4.0;           // m
constexpr double bridge_mass = 0.42;   // kg
constexpr double ball_radius = 0.25;   // m
constexpr int bridge_points = 41;
constexpr double between_bridges = 5.0;  // m, from one bridge to the other

void build_bridges(Bench& bench, const KnobValues& values, Vec2 origin) {
  ribbon::CordDef def;
  def.points = bridge_points;
  def.length = bridge_length;
  def.radius = 0.02;
  def.mass_per_length = bridge_mass / bridge_length;
  def.stretch_stiffness = values[Knob::stretch];
  def.friction = values[Knob::friction];
  def.pins = {0, bridge_points - 1};
  def.positions = sagging(bridge_points, bridge_length, origin - Vec2{0.5 * (span + between_bridges), 0.0}, span);
  def.accuracy = accuracy_of(values);
  bench.add(def);
  bench.add(Disc{.at = def.positions[bridge_points / 2] + Vec2{0.0, ball_radius + 0.4},
                 .radius = ball_radius,
                 .mass = bridge_mass * values[Knob::load_ratio],
                 .friction = def.friction});
}

void tune_bridges(Bench& bench, const KnobValues& values) {
  bench.set_mass(*bench.bodies().back().body, bridge_mass * values[Knob::load_ratio]);
}

}  // namespace

Scene bridge() {
  using Scale = KnobRange::Scale;
  return {.name = "bridge",
          .low = {-4.8, -3.2},
          .high = {4.8, 1.0},
          .knobs = together({{Knob::load_ratio, 0.01, 1e4, 30.0, Scale::logarithmic},
                             stretch_knob(100.0, 1e8),
                             {Knob::friction, 0.0, 2.0, 0.5},
                             {Knob::chain_substeps, 1.0, 64.0, 4.0, Scale::whole}},
                            accuracy_knobs(1)),
          .chains_at = Vec2{between_bridges, 0.0},
          .build = build_bridges,
          .tune = tune_bridges,
          .readings = [](const Bench& bench, const KnobValues&) { return excess_readings(bench); }};
}

}  // namespace game::lab
