#include <algorithm>
#include <cmath>
#include <string>

#include "ribbon/geometry/rotation.h"
#include "tests/extremes/balls.h"
#include "tests/extremes/table.h"
#include "tests/support/constants.h"

// The same motion far from the origin and in a rotated world.

namespace extremes {
namespace {

using constants::dt;
using constants::infinity;
using ribbon::Vec2;

struct Place {
  Vec2 origin;
  Vec2 turn{1.0, 0.0};  ///< a rotation, as a complex number
  Vec2 at(Vec2 p) const { return origin + times(turn, p); }
  Vec2 back(Vec2 p) const { return times({turn.x, -turn.y}, p - origin); }
};

enum class Kind : unsigned char { rope, elastic, ribbon };
constexpr Kind all_kinds[] = {Kind::rope, Kind::elastic, Kind::ribbon};

const char* name(Kind kind) {
  constexpr const char* names[] = {"rope", "elastic rope", "ribbon"};
  return names[static_cast<std::size_t>(kind)];
}

/// Swings a cord with a load from the horizontal. A free ball without gravity is in its path.
std::vector<Vec2> motion(Method method, Kind kind, const Place& place, bool with_ball, Counts& counts) {
  ribbon::CordDef def;
  def.points = 21;
  def.rows = kind == Kind::ribbon ? 3 : 1;
  def.length = 2.0;
  def.width = 0.1 * (def.rows - 1);
  def.mass_per_length = 0.5;
  def.friction = 0.3;
  if (kind == Kind::elastic) def.stretch_stiffness = 1e4;
  if (kind == Kind::ribbon) ribbon::solid(1e6, 0.0, 0.1, def.width).apply_to(def);
  for (int i = 0; i < def.points; ++i) {
    for (int j = 0; j < def.rows; ++j) def.positions.push_back(place.at({0.1 * i, 0.1 * j}));
  }
  for (int j = 0; j < def.rows; ++j) def.pins.push_back(j);
  TestedCord cord(method, def, dt);
  cord.attach_load(1.0);
  Balls balls;
  if (with_ball) balls.add(place.at({1.0, -0.3}), 0.15, 0.5);
  const Vec2 gravity = times(place.turn, {0.0, -9.81});
  std::vector<Vec2> path;
  for (int k = 0; k < 60; ++k) {
    with_ball ? balls.step(cord, dt, gravity) : cord.step(dt, gravity);
    for (const Vec2 p : cord.positions()) path.push_back(place.back(p));
  }
  counts += cord.counts();
  return path;
}

double furthest(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  double worst = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const double off = length(a[k] - b[k]);
    worst = std::max(worst, std::isfinite(off) ? off : infinity);
  }
  return worst;
}

}  // namespace

std::vector<Row> run_places(const Scope& scope) {
  std::vector<Row> rows;
  double done = 0.0;
  for (const Method method : all_methods) {
    for (const bool with_ball : {false, true}) {
      const std::string suffix = with_ball ? ", with a ball" : "";
      WorstCase far("10 km away" + suffix, "deviation, m", method, 1e-6);
      WorstCase turned("turned world" + suffix, "deviation, m", method, 1e-6);
      for (const Kind kind : all_kinds) {
        if ((method == Method::thesis && kind == Kind::elastic) || !scope.wants(name(kind))) continue;
        Counts counts;
        const std::vector<Vec2> here = motion(method, kind, {}, with_ball, counts);
        for (const Vec2 origin : {Vec2{1e4, 0.0}, {-6e3, 8e3}}) {
          far.take(furthest(here, motion(method, kind, {origin}, with_ball, counts)), name(kind), "moves differently");
        }
        for (const double angle : {0.3, 1.5707963267948966, 2.5}) {
          turned.take(furthest(here, motion(method, kind, {{}, ribbon::rotation(angle)}, with_ball, counts)),
                      std::string(name(kind)) + ", by " + std::to_string(angle) + " rad", "moves differently");
        }
        for (WorstCase* figure : {&far, &turned}) figure->add(counts);
      }
      rows.insert(rows.end(), {far.row(), turned.row()});
      scope.progress(++done / 8.0);
    }
  }
  return rows;
}

}  // namespace extremes
