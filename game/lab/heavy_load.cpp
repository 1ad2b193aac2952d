#include <cmath>
#include <numbers>

#include "game/lab/scene_list.h"

namespace game::lab {
namespace {

using ribbon::Vec2;

constexpr double rope_length = 3.0;  // m
constexpr double rope_mass = 1.0;    // kg
constexpr int rope_points = 31;
constexpr Vec2 place{-3.3, 0.0};  // m, of the pin of the cord

void build_heavy_load(Bench& bench, const KnobValues& values, Vec2 origin) {
  const double angle = values[Knob::start_angle] * std::numbers::pi / 180.0;
  const Vec2 pin = origin + place;
  const Vec2 along = rope_length * Vec2{std::sin(angle), -std::cos(angle)};
  ribbon::CordDef def;
  def.points = rope_points;
  def.length = rope_length;
  def.radius = 0.02;
  def.mass_per_length = rope_mass / rope_length;
  def.stretch_stiffness = values[Knob::stretch];
  def.damping = 0.02;
  def.pins = {0};
  def.positions = straight(rope_points, pin, along);
  def.accuracy = accuracy_of(values);
  bench.add(def);
  b2Body& load = bench.add(
      Disc{.at = pin + along, .radius = 0.3, .mass = rope_mass * values[Knob::load_ratio], .meets_cords = false});
  bench.hold(0, rope_points - 1, load);
}

void tune_heavy_load(Bench& bench, const KnobValues& values) {
  bench.set_mass(*bench.bodies().back().body, rope_mass * values[Knob::load_ratio]);
}

}  // namespace

Scene heavy_load() {
  using Scale = KnobRange::Scale;
  return {.name = "heavy_load",
          .low = {-6.7, -7.2},
          .high = {6.7, 0.9},
          .knobs = together({{Knob::load_ratio, 1.0, 1e6, 100.0, Scale::logarithmic},
                             {.knob = Knob::start_angle, .min = 0.0, .max = 90.0, .initial = 60.0, .rebuilds = true},
                             stretch_knob(1e3, 1e10),
                             {Knob::chain_substeps, 1.0, 64.0, 16.0, Scale::whole}},
                            accuracy_knobs(1)),
          .chains_at = Vec2{-2.0 * place.x, 0.0},
          .build = build_heavy_load,
          .tune = tune_heavy_load,
          .readings = [](const Bench& bench, const KnobValues&) { return excess_readings(bench); }};
}

}  // namespace game::lab
