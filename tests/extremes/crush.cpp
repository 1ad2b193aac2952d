#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include "tests/extremes/balls.h"
#include "tests/extremes/table.h"

// Cords between circles that nothing stops, and circles that are born where a cord is. No gravity, nothing pinned.

namespace extremes {
namespace {

using ribbon::Vec2;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double dt = 1.0 / 60.0;
constexpr int links = 20;
constexpr double link = 0.05;  // m

enum class Kind : unsigned char { rope, bending, strip, ribbon };
constexpr Kind all_kinds[] = {Kind::rope, Kind::bending, Kind::strip, Kind::ribbon};

const char* name(Kind kind) {
  constexpr const char* names[] = {"rope", "bending rope", "ribbon of 2 rows", "ribbon of 3 rows"};
  return names[static_cast<std::size_t>(kind)];
}

/// 1 m and half a kilogramme, along +x from the origin.
ribbon::CordDef cord_of(Kind kind) {
  ribbon::CordDef def;
  def.points = links + 1;
  def.rows = kind == Kind::ribbon ? 3 : kind == Kind::strip ? 2 : 1;
  def.length = links * link;
  def.width = link * (def.rows - 1);
  def.radius = 0.01;
  def.mass_per_length = 0.5;
  def.damping = 0.05;
  def.stretch_stiffness = 1e4;
  if (kind == Kind::bending) def.bending_stiffness = 0.05;
  if (def.rows > 1) {
    ribbon::solid(2e5, 0.0, 0.1, def.width).apply_to(def);
    def.area_stiffness = 1.0;
  }
  return def;
}

/// m, from side to side.
double thickness(const Subject& cord, Kind kind) {
  if (cord.method() == Method::thesis) return link * (cord.rows() - 1);
  return cord_of(kind).width + 2.0 * cord_of(kind).radius;
}

double middle(const Subject& cord) { return 0.5 * (cord.positions()[static_cast<std::size_t>(cord.rows()) - 1].y); }

struct Figures {
  Worst speed, strain, inverted;
};

/// Two seconds in which its motion is taken away.
void take(Subject& cord, const Balls& balls, double speed, const std::string& setting, Figures& figures) {
  for (int k = 0; k < 120 && cord.is_finite(); ++k) {
    for (int p = 0; p < cord.columns() * cord.rows(); ++p) {
      cord.set_velocity(p, 0.9 * cord.velocities()[static_cast<std::size_t>(p)]);
    }
    cord.step(dt, {});
  }
  const bool finite = cord.is_finite() && balls.is_finite();
  figures.speed.take(finite ? speed : infinity, setting);
  figures.speed.add(cord.counts());
  figures.strain.take(finite ? cord.worst_strain() : infinity, setting);
  figures.inverted.take(cord.inverted(), setting);
}

/// Two circles come together at half a metre a second, to 5 % of the cord's thickness, wait and part.
void squeeze(Method method, Kind kind, double radius, Figures& figures) {
  Subject cord(method, cord_of(kind), dt);
  Balls balls;
  const double gap = 0.05 * thickness(cord, kind);
  const double apart = 0.5 * gap + radius;
  const Vec2 at{0.5 * links * link, middle(cord)};
  constexpr double speed = 0.5;  // m/s
  constexpr int coming = 30;     // ticks
  const Vec2 way{0.0, apart + coming * dt * speed};
  const int low = balls.add(at - way, radius, 0.0);
  const int high = balls.add(at + way, radius, 0.0);
  double fastest = 0.0;
  for (int k = 0; k < 3 * coming; ++k) {
    const double v = k < coming ? speed : k < 2 * coming ? 0.0 : -speed;
    balls.at(low).velocity = {0.0, v};
    balls.at(high).velocity = {0.0, -v};
    balls.step(cord, dt, {});
    fastest = std::max(fastest, cord.fastest());
  }
  for (int k = 0; k < 60; ++k) cord.step(dt, {});
  take(cord, balls, fastest, std::string(name(kind)) + ", radius " + std::to_string(radius), figures);
}

/// A ball of the cord's mass is there at once, and free: with its centre `inside` m above the cord's middle.
void bear(Method method, Kind kind, double radius, Vec2 center, const char* where, Figures& figures) {
  Subject cord(method, cord_of(kind), dt);
  Balls balls;
  balls.add(center, radius, 0.5);
  double fastest = 0.0;
  for (int k = 0; k < 120; ++k) {
    balls.step(cord, dt, {});
    fastest = std::max(fastest, cord.fastest());
  }
  char setting[96];
  std::snprintf(setting, sizeof setting, "%s, radius %g links, %s", name(kind), radius / link, where);
  take(cord, balls, fastest, setting, figures);
}

}  // namespace

std::vector<Row> run_crush(const Scope& scope) {
  std::vector<Row> rows;
  double done = 0.0;
  const auto report = [&](const Figures& figures) {
    rows.insert(rows.end(), {figures.speed.row(), figures.strain.row(), figures.inverted.row()});
    scope.progress(++done / 16.0);
  };
  const auto figures_of = [](const std::string& what, Method method) {
    return Figures{{what, "fastest point, m/s", method, 50.0},
                   {what, "strain in the end", method, 1e-3},
                   {what, "corners inside out", method, 0.0}};
  };
  const double middle_column = 0.5 * links * link;  // the middle one
  for (const Method method : all_methods) {
    Figures crushed = figures_of("crushed to 5 %", method);
    Figures born = figures_of("circle born on its surface", method);
    Figures inside = figures_of("circle born inside", method);
    Figures around = figures_of("cord born in a large circle", method);
    for (Worst* figure : {&around.speed, &around.strain, &around.inverted}) figure->let_fail();
    // Of some thousands of substeps, where a ball that comes out by and by gains more than the little that there is.
    crushed.speed.allow_unconverged(2);
    inside.speed.allow_unconverged(5);
    for (const Kind kind : all_kinds) {
      if (method == Method::thesis && kind < Kind::strip) continue;
      for (const double radius : {0.1, 0.02, 0.5}) {
        squeeze(method, kind, radius, crushed);
        if (!scope.full) break;
      }
      const double top = method == Method::thesis ? cord_of(kind).width : cord_of(kind).width + cord_of(kind).radius;
      for (const double ratio : {1e2, 1e3}) {
        if (!scope.full && method != Method::thesis) continue;  // slow, as it fails
        bear(method, kind, ratio * link, {middle_column, top + ratio * link - 0.05}, "5 cm deep", around);
      }
      for (const double ratio : {1e-4, 1e-2, 1.0}) {
        bear(method, kind, ratio * link, {middle_column, top + 0.8 * ratio * link}, "a fifth of it deep", born);
        bear(method, kind, ratio * link, {middle_column, 0.0}, "on a point", inside);
        bear(method, kind, ratio * link, {middle_column + 0.5 * link, 0.0}, "on an edge", inside);
        bear(method, kind, ratio * link, {middle_column + 0.3 * link, 0.4 * std::min(link, cord_of(kind).width)},
             "in a cell", inside);
      }
    }
    for (const Figures* figures : {&crushed, &born, &inside, &around}) {
      if (figures->speed.row().cases > 0) report(*figures);
    }
  }
  return rows;
}

}  // namespace extremes
