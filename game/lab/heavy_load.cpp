#include <cmath>
#include <numbers>

#include "game/lab/scene_list.h"

namespace game::lab {
namespace {

using ribbon::Vec2;

constexpr double cord_length = 3.0;  // m
constexpr double cord_mass = 1.0;    // kg
constexpr int points = 31;
constexpr Vec2 place{-3.3, 0.0};  // m, of the pin of the cord

void build(Bench& bench, const KnobValues& values, Vec2 origin) {
  const double angle = values[Knob::start_angle] * std::numbers::pi / 180.0;
  const Vec2 pin = origin + place;
  const Vec2 along = cord_length * Vec2{std::sin(angle), -std::cos(angle)};
  ribbon::CordDef def;
  def.points = points;
  def.length = cord_length;
  def.radius = 0.02;
  def.mass_per_length = cord_mass / cord_length;
  def.stretch_stiffness = values[Knob::stretch];
  def.damping = 0.02;
  def.pins = {0};
  def.positions = straight(points, pin, along);
  def.accuracy = accuracy_of(values);
  bench.add(def);
  b2Body& load = bench.add(
      Disc{.at = pin + along, .radius = 0.3, .mass = cord_mass * values[Knob::load_ratio], .meets_cords = false});
  bench.hold(0, points - 1, load);
}

void tune(Bench& bench, const KnobValues& values) {
  bench.set_mass(*bench.bodies().back().body, cord_mass * values[Knob::load_ratio]);
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
          .build = build,
          .tune = tune,
          .readings = [](const Bench& bench, const KnobValues&) { return excess_readings(bench); }};
}

}  // namespace game::lab
