#include "tests/support/thesis_scenes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "ribbon/thesis/corrections.h"

namespace test_support {
namespace {

using ribbon::ThesisCord;
using ribbon::Vec2;

Vec2 middle(const ThesisCord& cord, int column) {
  Vec2 sum;
  for (int j = 0; j < cord.mesh().h; ++j)
    sum += cord.positions()[static_cast<std::size_t>(cord.mesh().index(column, j))];
  return (1.0 / cord.mesh().h) * sum;
}

double area_ratio(const ThesisCord& cord, const ribbon::Triangle& triangle) {
  const auto at = [&](int p) { return cord.positions()[static_cast<std::size_t>(p)]; };
  return ribbon::signed_area(at(triangle.a), at(triangle.b), at(triangle.c)) / triangle.rest_area;
}

}  // namespace

void PrintTo(const ThesisCondition& condition, std::ostream* out) { *out << condition.name; }

ribbon::ThesisDef thesis_def(const ThesisCondition& condition) {
  ribbon::ThesisDef def;
  def.w = condition.w;
  def.h = condition.h;
  def.spacing = 0.05;
  def.point_mass = 0.002;
  const double kappa = condition.printed_k / (1.0 - condition.printed_k);
  const double dt = frame_dt / 8;
  def.spring_stiffness = kappa * def.point_mass / (2.0 * dt * dt);
  def.bar_damping = 5.0 * def.point_mass / dt;  // β = 5
  def.drag = 1.0;
  def.self_collision = true;
  def.substeps = condition.substeps;
  return def;
}

ribbon::ThesisDef hanging(const ThesisCondition& condition) {
  ribbon::ThesisDef def = thesis_def(condition);
  const std::array<Vec2, 2> down = {Vec2{0.0, 0.0}, Vec2{0.0, -1.0}};
  def.positions = ribbon::lay_along(down, def.w, def.h, def.spacing);
  def.pins.resize(static_cast<std::size_t>(def.h));
  std::iota(def.pins.begin(), def.pins.end(), 0);
  return def;
}

double kinetic_energy(const ThesisCord& cord) {
  double sum = 0.0;
  for (const Vec2 v : cord.velocities()) sum += 0.5 * cord.def().point_mass * dot(v, v);
  return sum;
}

int inverted_triangles(const ThesisCord& cord) {
  const auto& triangles = cord.mesh().triangles;
  return static_cast<int>(std::count_if(triangles.begin(), triangles.end(),
                                        [&](const auto& triangle) { return !(area_ratio(cord, triangle) >= 0.0); }));
}

double length_ratio(const ThesisCord& cord) {
  double sum = 0.0;
  for (int i = 0; i + 1 < cord.mesh().w; ++i) sum += length(middle(cord, i + 1) - middle(cord, i));
  return sum / ((cord.mesh().w - 1) * cord.mesh().spacing);
}

double worst_stretch(const ThesisCord& cord) {
  double worst = 0.0;
  for (const auto& bar : cord.mesh().connections) {
    const Vec2 ab =
        cord.positions()[static_cast<std::size_t>(bar.b)] - cord.positions()[static_cast<std::size_t>(bar.a)];
    worst = std::max(worst, std::abs(length(ab) / bar.rest_length - 1.0));
  }
  return worst;
}

bool all_finite(const ThesisCord& cord) {
  const auto finite = [](Vec2 v) { return is_finite(v); };
  return std::all_of(cord.positions().begin(), cord.positions().end(), finite) &&
         std::all_of(cord.velocities().begin(), cord.velocities().end(), finite);
}

Vec2 centre_of_mass(const ThesisCord& cord) {
  Vec2 sum;
  for (const Vec2 p : cord.positions()) sum += p;
  return (1.0 / cord.mesh().size()) * sum;
}

Vec2 momentum(const ThesisCord& cord) {
  Vec2 sum;
  for (const Vec2 v : cord.velocities()) sum += cord.def().point_mass * v;
  return sum;
}

double fastest(const ThesisCord& cord) {
  double speed = 0.0;
  for (const Vec2 v : cord.velocities()) speed = std::max(speed, length(v));
  return speed;
}

}  // namespace test_support
