#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "tests/extremes/balls.h"
#include "tests/extremes/table.h"
#include "tests/support/constants.h"

// Cords between kinematic circles, and circles that appear inside a cord. No gravity, no pins.

namespace extremes {
namespace {

using constants::dt;
using constants::infinity;
using ribbon::Vec2;
constexpr int links = 20;
constexpr double link = 0.05;  // m

enum class Kind : unsigned char { rope, bending, strip, ribbon };
constexpr Kind all_kinds[] = {Kind::rope, Kind::bending, Kind::strip, Kind::ribbon};

const char* name(Kind kind) {
  constexpr const char* names[] = {"rope", "bending rope", "ribbon of 2 rows", "ribbon of 3 rows"};
  return names[static_cast<std::size_t>(kind)];
}

/// Returns a cord of 1 m and 0.5 kg along +x from the origin.
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

/// Returns the thickness of the cord, m.
double thickness(const TestedCord& cord, Kind kind) {
  if (cord.method() == Method::thesis) return link * (cord.rows() - 1);
  return cord_of(kind).width + 2.0 * cord_of(kind).radius;
}

double middle(const TestedCord& cord) { return 0.5 * (cord.positions()[static_cast<std::size_t>(cord.rows()) - 1].y); }

struct Figures {
  WorstCase speed, strain, inverted;
  std::array<WorstCase*, 3> all() { return {&speed, &strain, &inverted}; }
};

/// Damps the motion for two seconds, then takes the figures.
void take(TestedCord& cord, const Balls& balls, double speed, const std::string& setting, Figures& figures) {
  for (int k = 0; k < 120 && cord.is_finite(); ++k) {
    for (int p = 0; p < cord.columns() * cord.rows(); ++p) {
      cord.set_velocity(p, 0.9 * cord.velocities()[static_cast<std::size_t>(p)]);
    }
    cord.step(dt, {});
  }
  const bool finite = cord.is_finite() && balls.is_finite();
  figures.speed.take(finite ? speed : infinity, setting, "thrown");
  figures.strain.take(finite ? cord.worst_strain() : infinity, setting, cord.shape());
  figures.inverted.take(cord.inverted(), setting, cord.shape());
  for (WorstCase* figure : figures.all()) figure->add(cord.counts());
}

/// Two circles approach at 0.5 m/s until the gap is 5 % of the cord's thickness, wait and part.
void squeeze(Method method, Kind kind, double radius, const std::string& setting, Figures& figures) {
  TestedCord cord(method, cord_of(kind), dt);
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
  take(cord, balls, fastest, setting, figures);
}

/// A free ball of the cord's mass appears inside it.
void create_inside(Method method, Kind kind, double radius, Vec2 center, const std::string& setting, Figures& figures) {
  TestedCord cord(method, cord_of(kind), dt);
  Balls balls;
  balls.add(center, radius, 0.5);
  double fastest = 0.0;
  for (int k = 0; k < 120; ++k) {
    balls.step(cord, dt, {});
    fastest = std::max(fastest, cord.fastest());
  }
  take(cord, balls, fastest, setting, figures);
}

std::string text(Kind kind, double radius, const char* where) {
  char setting[96];
  std::snprintf(setting, sizeof setting, "%s, radius %g links%s", name(kind), radius / link, where);
  return setting;
}

/// The rows of one method, over all kinds of cord.
struct Rows {
  Figures crushed, at_surface, inside, around;
};

void run(Method method, Kind kind, const Scope& scope, Rows& rows) {
  for (const double radius : {0.1, 0.02, 0.5}) {
    const std::string setting = text(kind, radius, "");
    if (scope.wants(setting)) squeeze(method, kind, radius, setting, rows.crushed);
    if (!scope.full) break;
  }
  const auto create = [&](double ratio, Vec2 center, const char* where, Figures& figures) {
    const std::string setting = text(kind, ratio * link, where);
    if (scope.wants(setting)) create_inside(method, kind, ratio * link, center, setting, figures);
  };
  const double x = 0.5 * links * link;  // position of the middle column
  const double width = cord_of(kind).width;
  const double top = method == Method::thesis ? width : width + cord_of(kind).radius;
  for (const double ratio : {10.0, 1e2, 1e3}) {
    create(ratio, {x, top + ratio * link - 0.001}, ", 1 mm deep", rows.around);
    create(ratio, {x, top + ratio * link - 0.05}, ", 5 cm deep", rows.around);
  }
  for (const double ratio : {1e-4, 1e-2, 1.0}) {
    create(ratio, {x, top + 0.8 * ratio * link}, ", a fifth of it deep", rows.at_surface);
    create(ratio, {x, 0.0}, ", on a point", rows.inside);
    create(ratio, {x + 0.5 * link, 0.0}, ", on an edge", rows.inside);
    create(ratio, {x + 0.3 * link, 0.4 * std::min(link, width)}, ", in a cell", rows.inside);
  }
}

}  // namespace

std::vector<Row> run_crush(const Scope& scope) {
  std::vector<Row> table;
  double done = 0.0;
  const auto figures_of = [](const std::string& what, Method method) {
    return Figures{{what, "fastest point, m/s", method, 10.0},
                   {what, "strain at the end", method, 1e-3},
                   {what, "inverted corners", method, 0.0}};
  };
  for (const Method method : all_methods) {
    Rows rows{figures_of("crushed to 5 %", method), figures_of("circle created on its surface", method),
              figures_of("circle created inside", method), figures_of("cord created in a large circle", method)};
    for (const Kind kind : all_kinds) {
      if (method == Method::thesis && kind < Kind::strip) continue;
      run(method, kind, scope, rows);
      scope.progress(++done / 14.0);
    }
    for (Figures* figures : {&rows.crushed, &rows.at_surface, &rows.inside, &rows.around}) {
      for (const WorstCase* figure : figures->all()) table.push_back(figure->row());
    }
  }
  return table;
}

}  // namespace extremes
