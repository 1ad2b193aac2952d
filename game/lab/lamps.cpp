#include "game/lab/scene_list.h"

namespace game::lab {
namespace {

using ribbon::Vec2;

constexpr int columns = 50;
constexpr Vec2 cell{0.5, 0.85};           // m, from lamp to lamp
constexpr double lamp_cord_length = 0.5;  // m
constexpr double lamp_radius = 0.07;      // m
constexpr double lamp_mass = 0.5;         // kg
constexpr int lamp_cord_points = 6;

void add_lamp(Bench& bench, const KnobValues& values, int number) {
  const int row = number / columns;
  const Vec2 hook{cell.x * (number % columns), -cell.y * row};
  ribbon::CordDef def;
  def.points = lamp_cord_points;
  def.length = lamp_cord_length;
  def.drag = values[Knob::air_drag];
  def.allow_sleep = values.is_on(Knob::may_sleep);
  def.pins = {0};
  def.positions = straight(lamp_cord_points, hook, {0.0, -lamp_cord_length});
  def.accuracy = accuracy_of(values);
  bench.add(def);
  b2Body& lamp = bench.add(Disc{.at = hook - Vec2{0.0, lamp_cord_length},
                                .radius = lamp_radius,
                                .mass = lamp_mass,
                                .meets_cords = false,
                                .damping = values[Knob::air_drag]});
  bench.hold(number, lamp_cord_points - 1, lamp);
  const float push = 0.02F * static_cast<float>(number * 7 % 11 - 5);  // m/s, another one for each neighbour
  lamp.SetLinearVelocity({push, 0.0F});
}

void build_lamps(Bench& bench, const KnobValues& values, Vec2) {
  for (int k = 0; k < values.whole(Knob::count); ++k) add_lamp(bench, values, k);
}

void tune_lamps(Bench& bench, const KnobValues& values) {
  bench.change_cords([&](ribbon::CordDef& def) {
    def.drag = values[Knob::air_drag];
    def.allow_sleep = values.is_on(Knob::may_sleep);
  });
  for (const engine::SceneBody& lamp : bench.bodies()) {
    lamp.body->SetLinearDamping(static_cast<float>(values[Knob::air_drag]));
    lamp.body->SetAngularDamping(static_cast<float>(values[Knob::air_drag]));
    lamp.body->SetAwake(true);
  }
}

std::vector<Reading> readings_of_lamps(const Bench& bench, const KnobValues&) {
  int awake = 0;
  for (const ribbon::box2d::CordId id : bench.coupling().cords()) {
    awake += bench.coupling().cord(id).direct().is_asleep() ? 0 : 1;
  }
  return {{Reading::Kind::awake, 1.0 * awake}, {Reading::Kind::unconverged, 1.0 * unconverged(bench)}};
}

}  // namespace

Scene lamps() {
  using Scale = KnobRange::Scale;
  return {.name = "lamps",
          .low = {-0.6, -17.0},
          .high = {25.1, 0.5},
          .knobs = together({{.knob = Knob::count,
                              .min = 10.0,
                              .max = 1000.0,
                              .initial = 1000.0,
                              .scale = Scale::logarithmic,
                              .rebuilds = true},
                             {Knob::may_sleep, 0.0, 1.0, 1.0, Scale::choice},
                             {Knob::air_drag, 0.0, 4.0, 1.0}},
                            accuracy_knobs(0)),
          .build = build_lamps,
          .tune = tune_lamps,
          .readings = readings_of_lamps};
}

}  // namespace game::lab
