#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "tests/extremes/table.h"
#include "tests/support/constants.h"
#include "tests/support/dice.h"

// Starts that no motion reaches. No drive and no gravity: the only energy is that of the initial strain.

namespace extremes {
namespace {

using constants::dt;
using constants::infinity;
using ribbon::Vec2;
using test_support::Dice;
constexpr int ticks = 360;

enum class Start : unsigned char { random, point, collinear, reversed, reflected };
constexpr Start all_starts[] = {Start::random, Start::point, Start::collinear, Start::reversed, Start::reflected};

std::string_view name(Start start) {
  constexpr std::string_view names[] = {"random", "collapsed to a point", "collinear", "reversed", "reflected"};
  return names[static_cast<std::size_t>(start)];
}

enum class Kind : unsigned char { rope, bending_rope, strip, ribbon };
constexpr Kind all_kinds[] = {Kind::rope, Kind::bending_rope, Kind::strip, Kind::ribbon};

std::string_view name(Kind kind) {
  constexpr std::string_view names[] = {"rope", "bending rope", "ribbon of 2 rows", "ribbon of 3 rows"};
  return names[static_cast<std::size_t>(kind)];
}

/// Returns the start position of a point of the cord.
Vec2 started(Start start, Vec2 rest, double length, Dice& dice) {
  const Vec2 off{1e-3 * dice(), 1e-3 * dice()};
  switch (start) {
    case Start::random: return {dice() * length, dice() * length};
    case Start::point: return off;
    case Start::collinear: return {rest.x + off.x, 0.0};
    case Start::reversed: return Vec2{length - rest.x, rest.y} + off;
    case Start::reflected: return Vec2{rest.x, -rest.y} + off;
  }
  return {};
}

ribbon::CordDef cord_of(Kind kind, Start start, unsigned seed) {
  ribbon::CordDef def;
  def.points = 13;
  def.rows = kind == Kind::ribbon ? 3 : kind == Kind::strip ? 2 : 1;
  def.length = 0.6;
  def.width = 0.05 * (def.rows - 1);
  def.mass_per_length = 0.5;
  def.damping = 0.05;
  def.drag = 1.0;
  def.stretch_stiffness = 1e3;
  if (kind == Kind::bending_rope) def.bending_stiffness = 0.05;
  if (def.rows > 1) {
    ribbon::solid(2e5, 0.0, 0.1, def.width).apply_to(def);
    def.area_stiffness = 1.0;
  }
  Dice dice(seed);
  const ribbon::Cord rest(def);
  for (const Vec2 p : rest.positions()) def.positions.push_back(started(start, p, def.length, dice));
  return def;
}

/// The bounded figures, over all kinds of cord at one start.
struct Figures {
  WorstCase gain, speed, strain, inverted;
};

void run(Method method, Kind kind, Start start, unsigned seed, const std::string& setting, Figures& figures) {
  TestedCord cord(method, cord_of(kind, start, seed), dt);
  const double energy = cord.energy({});
  double gain = 0.0;
  double speed = 0.0;
  for (int k = 0; k < ticks && gain < infinity; ++k) {
    cord.step(dt, {});
    if (!cord.is_finite()) gain = infinity;
    gain = std::max(gain, cord.energy({}) / energy - 1.0);
    for (int p = 0; p < cord.columns() * cord.rows(); ++p) {
      const Vec2 v = cord.velocities()[static_cast<std::size_t>(p)];
      speed = std::max(speed, std::sqrt(0.5 * cord.mass(p) * dot(v, v) / energy));
    }
  }
  figures.gain.take(gain, setting, "gains energy");
  figures.speed.take(speed, setting, "gains energy");
  figures.strain.take(cord.worst_strain(), setting, cord.shape());
  figures.inverted.take(cord.inverted(), setting, cord.shape());
  for (WorstCase* figure : {&figures.gain, &figures.speed, &figures.strain, &figures.inverted})
    figure->add(cord.counts());
}

}  // namespace

std::vector<Row> run_starts(const Scope& scope) {
  std::vector<Row> rows;
  const unsigned seeds = scope.full ? 100 : 3;
  double done = 0.0;
  for (const Method method : all_methods) {
    for (const Start start : all_starts) {
      const std::string what(name(start));
      Figures figures{{what, "energy gained / start's", method, 1e-6},
                      {what, "speed / what it allows", method, 1.0 + 1e-6},
                      {what, "strain at the end", method, 1e-3},
                      {what, "corners inside out", method, 0.0}};
      for (const Kind kind : all_kinds) {
        if (method == Method::thesis && kind <= Kind::bending_rope) continue;  // these are the same strip
        for (unsigned seed = 0; seed < seeds; ++seed) {
          const std::string setting = std::string(name(kind)) + ", seed " + std::to_string(seed);
          if (scope.wants(setting)) run(method, kind, start, seed, setting, figures);
        }
      }
      rows.insert(rows.end(), {figures.gain.row(), figures.speed.row(), figures.strain.row(), figures.inverted.row()});
      scope.progress(++done / static_cast<double>(std::size(all_methods) * std::size(all_starts)));
    }
  }
  return rows;
}

}  // namespace extremes
