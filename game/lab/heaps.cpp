#include <array>

#include "game/lab/scene_list.h"

// Cords that fall and come to lie on each other: the scenes pile and strips.

namespace game::lab {
namespace {

using ribbon::Vec2;

/// A ribbon of two rows along a level line, whose row 0 begins at `corner`.
ribbon::CordDef level_ribbon(int points, double link, double width, Vec2 corner) {
  ribbon::CordDef def;
  def.points = points;
  def.rows = 2;
  def.length = link * (points - 1);
  def.width = width;
  def.area_stiffness = 1.0;
  def.poisson_ratio = 0.3;
  for (int i = 0; i < points; ++i) {
    for (int j = 0; j < 2; ++j) def.positions.push_back(corner + Vec2{link * i, width * j});
  }
  return def;
}

void finish(ribbon::CordDef& def, const KnobValues& values) {
  def.stretch_stiffness = values[Knob::stretch];
  def.bending_stiffness = values[Knob::bending];
  def.friction = values[Knob::friction];
  def.self_contact = true;
  def.cord_contact = true;
  def.accuracy = accuracy_of(values);
}

std::vector<Reading> readings_of_heap(const Bench& bench, const KnobValues&) {
  return {{Reading::Kind::contacts, 1.0 * contacts(bench)}, {Reading::Kind::unconverged, 1.0 * unconverged(bench)}};
}

void build_pile(Bench& bench, const KnobValues& values, Vec2) {
  constexpr double length = 1.2;  // m
  bench.add_edges(std::array{Vec2{-1.4, 2.6}, Vec2{-1.0, 0.0}, Vec2{1.0, 0.0}, Vec2{1.4, 2.6}}, values[Knob::friction]);
  for (int k = 0; k < values.whole(Knob::count); ++k) {
    const Vec2 start{-0.5 * length + 0.3 * (k % 3 - 1), 0.2 + 0.16 * k};
    ribbon::CordDef def;
    if (k % 2 == 0) {
      def = level_ribbon(13, length / 12.0, 0.06, start);
      def.mass_per_length = 0.2;
    } else {
      def.points = 17;
      def.length = length;
      def.positions = straight(def.points, start, {length, 0.0});
    }
    def.radius = 0.015;
    finish(def, values);
    bench.add(def);
  }
}

void build_strips(Bench& bench, const KnobValues& values, Vec2) {
  constexpr int columns = 6;
  constexpr int rows = 6;
  constexpr double cell = 2.0;  // m, of the lattice: two pegs
  constexpr double right = columns * cell;
  constexpr double floor = -6.4;
  bench.add_edges(std::array{Vec2{0.0, 20.0}, Vec2{0.0, floor}, Vec2{right, floor}, Vec2{right, 20.0}},
                  values[Knob::friction]);
  for (int row = 0; row < rows; ++row) {
    const double first = row % 2 == 0 ? 0.5 : 1.0;
    for (double x = first; x < right; x += 0.5 * cell)
      bench.add(Disc{.type = b2_staticBody, .at = {x, -0.8 * row}, .radius = 0.09, .friction = values[Knob::friction]});
  }
  for (int k = 0; k < values.whole(Knob::count); ++k) {
    const int row = k / columns;
    const Vec2 corner{cell * (k % columns) + 0.1 + 0.08 * (k * 7 % 11), 0.3 + 0.35 * row};
    ribbon::CordDef def = level_ribbon(21, 0.05, 0.05, corner);
    def.mass_per_length = 0.0825;
    finish(def, values);
    bench.add(def);
  }
}

/// Returns the knobs of a scene with up to `most` cords.
std::vector<KnobRange> knobs(double most, double initial, double friction) {
  using Scale = KnobRange::Scale;
  return together(
      {{.knob = Knob::count, .min = 2.0, .max = most, .initial = initial, .scale = Scale::whole, .rebuilds = true},
       {Knob::stretch, 10.0, 1e4, 50.0, Scale::logarithmic},
       {Knob::bending, 1e-3, 1.0, 0.01, Scale::logarithmic},
       {Knob::friction, 0.0, 1.0, friction}},
      accuracy_knobs(0));
}

}  // namespace

Scene pile() {
  return {.name = "pile",
          .low = {-2.2, -0.15},
          .high = {2.2, 2.75},
          .knobs = knobs(24.0, 12.0, 0.4),
          .build = build_pile,
          .readings = readings_of_heap};
}

Scene strips() {
  return {.name = "strips",
          .low = {-0.3, -6.6},
          .high = {12.3, 2.0},
          .knobs = knobs(48.0, 24.0, 0.1),
          .build = build_strips,
          .readings = readings_of_heap};
}

}  // namespace game::lab
