#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "game/lab/scene_list.h"
#include "ribbon/thesis/mesh.h"

// Goto 2017, Table 4.3: conditions A to D.

namespace game::lab {
namespace {

using ribbon::Vec2;

constexpr double spacing = 0.05;      // m
constexpr double point_mass = 0.002;  // kg
constexpr int printed_substeps = 8;

struct Condition {
  const char* name;
  int w, h;
  int substeps;
};

/// Sets what the knobs change. The stiffness is that of the coefficient k with eight substeps, Ks = κm/(2δ²) with
/// κ = k/(1 − k), for any number of substeps.
void set_knobs(ribbon::ThesisDef& def, const KnobValues& values) {
  const double k = values[Knob::spring_share];
  const double dt = Bench::dt / printed_substeps;
  def.spring_stiffness = k / (1.0 - k) * point_mass / (2.0 * dt * dt);
  def.bar_damping = values[Knob::bar_damping] * point_mass / dt;
  def.area_stiffness = values[Knob::area];
  def.self_collision = values.is_on(Knob::self_collision);
  def.drag = values[Knob::air_drag];
  def.substeps = values.whole(Knob::iterations);
}

void build_thesis(Bench& bench, const KnobValues& values, const Condition& condition) {
  ribbon::ThesisDef def;
  def.w = condition.w;
  def.h = condition.h;
  def.spacing = spacing;
  def.point_mass = point_mass;
  set_knobs(def, values);
  const double angle = values[Knob::start_angle] * std::numbers::pi / 180.0;
  def.positions =
      ribbon::lay_along(std::array{Vec2{}, Vec2{std::sin(angle), -std::cos(angle)}}, def.w, def.h, def.spacing);
  def.pins.resize(static_cast<std::size_t>(def.h));
  std::iota(def.pins.begin(), def.pins.end(), 0);
  bench.add(def);
}

std::vector<Reading> readings_of_thesis(const Bench& bench, const KnobValues&) {
  const ribbon::StepReport& report = bench.coupling().cord(0).thesis_report();
  return {{Reading::Kind::self_contacts, 1.0 * report.self_contacts},
          {Reading::Kind::turned_over, 1.0 * report.turned_over}};
}

Scene scene_of(const Condition& condition) {
  using Scale = KnobRange::Scale;
  const double reach = spacing * (condition.w - 1) + 0.1;
  return {
      .name = condition.name,
      .low = {-1.2 * reach, -1.1 * reach},
      .high = {1.2 * reach, 0.25 * reach},
      .knobs = {{Knob::spring_share, 0.05, 0.95, 0.45},
                {Knob::iterations, 1.0, 64.0, 1.0 * condition.substeps, Scale::whole},
                {Knob::bar_damping, 0.0, 10.0, 5.0},
                {Knob::area, 0.0, 1.0, 0.5},
                {Knob::self_collision, 0.0, 1.0, 1.0, Scale::choice},
                {Knob::air_drag, 0.0, 5.0, 1.0},
                {.knob = Knob::start_angle, .min = 0.0, .max = 90.0, .initial = 45.0, .rebuilds = true}},
      .build = [condition](Bench& bench, const KnobValues& values, Vec2) { build_thesis(bench, values, condition); },
      .tune =
          [](Bench& bench, const KnobValues& values) {
            bench.change_thesis_cords([&](ribbon::ThesisDef& def) { set_knobs(def, values); });
          },
      .readings = readings_of_thesis};
}

}  // namespace

Scene thesis_a() { return scene_of({"thesis_a", 25, 2, 8}); }
Scene thesis_b() { return scene_of({"thesis_b", 10, 5, 8}); }
Scene thesis_c() { return scene_of({"thesis_c", 35, 2, 8}); }
Scene thesis_d() { return scene_of({"thesis_d", 35, 2, 4}); }

}  // namespace game::lab
