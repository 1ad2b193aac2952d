#include "tests/extremes/tested_cord.h"

#include <algorithm>
#include <cmath>

#include "ribbon/cord_forces.h"
#include "ribbon/elastic/cell.h"
#include "tests/support/slot.h"
#include "tests/support/thesis_scenes.h"

namespace extremes {
namespace {

using ribbon::Vec2;
using test_support::slot;

/// Returns the second row of a rope, which the thesis's method needs, one link to its right.
std::vector<Vec2> with_second_row(const std::vector<Vec2>& line, double spacing) {
  std::vector<Vec2> both;
  for (std::size_t p = 0; p < line.size(); ++p) {
    const Vec2 along = line[std::min(p + 1, line.size() - 1)] - line[p > 0 ? p - 1 : 0];
    const double size = length(along);
    both.push_back(line[p]);
    both.push_back(line[p] + (size > 0.0 ? (-spacing / size) * perp(along) : Vec2{0.0, -spacing}));
  }
  return both;
}

ribbon::ThesisDef thesis_of(const ribbon::CordDef& def, double dt) {
  ribbon::ThesisDef thesis;
  thesis.w = def.points;
  thesis.h = std::max(def.rows, 2);
  thesis.spacing = def.length / (def.points - 1);
  thesis.point_mass = def.mass_per_length * def.length / (thesis.w * thesis.h);
  const double inverse_substep = thesis.substeps / dt;
  // κ = k/(1 − k) of Ks = κ·m/(2δ²) is 1 if a substep corrects half of the error.
  const double stiffest = 0.5 * thesis.point_mass * inverse_substep * inverse_substep;
  thesis.spring_stiffness = std::clamp(def.stretch_stiffness / (thesis.spacing * thesis.h), 0.0, stiffest);
  thesis.bar_damping = thesis.point_mass * inverse_substep;
  thesis.drag = def.drag;
  thesis.self_collision = def.self_contact;
  const int copies = thesis.h / def.rows;
  thesis.positions = copies == 1 ? def.positions : with_second_row(def.positions, thesis.spacing);
  for (const int pin : def.pins) {
    for (int k = 0; k < copies; ++k) thesis.pins.push_back(copies * pin + k);
  }
  return thesis;
}

std::vector<Vec2> laid_out(const ribbon::CordDef& def) {
  if (!def.positions.empty()) return def.positions;
  const ribbon::Cord cord(def);
  return {cord.positions().begin(), cord.positions().end()};
}

}  // namespace

std::string_view name(Method method) {
  constexpr std::string_view names[] = {"fast", "balanced", "accurate", "thesis"};
  return names[static_cast<std::size_t>(method)];
}

/// The work is unlimited: random scenes measure what limited work leaves unsolved.
ribbon::Accuracy accuracy_of(Method method) {
  ribbon::Accuracy accuracy = method == Method::fast       ? ribbon::Accuracy::fast()
                              : method == Method::accurate ? ribbon::Accuracy::accurate()
                                                           : ribbon::Accuracy::balanced();
  accuracy.max_work = 1'000'000;
  return accuracy;
}

Counts& Counts::operator+=(const Counts& other) {
  steps += other.steps;
  direct += other.direct;
  thesis += other.thesis;
  return *this;
}

TestedCord::TestedCord(Method method, ribbon::CordDef def, double dt)
    : method_(method), columns_(def.points), rows_(def.rows), cell_{def.length / (def.points - 1), 0.0} {
  def.positions = laid_out(def);
  if (method == Method::thesis) {
    thesis_.emplace(thesis_of(def, dt));
    rows_ = thesis_->def().h;
    cell_.y = cell_.x;
    return;
  }
  if (rows_ > 1) cell_.y = def.width / (rows_ - 1);
  def.accuracy = accuracy_of(method);
  direct_.emplace(def);
}

void TestedCord::attach_load(double mass) {
  for (int j = 0; j < rows_ && mass > 0.0; ++j) {
    const int point = index(columns_ - 1, j);
    const double share = rows_ == 1 ? 1.0 : (j == 0 || j == rows_ - 1 ? 0.5 : 1.0) / (rows_ - 1);
    if (direct_) {
      direct_->attach_mass(point, share * mass);
      continue;
    }
    ribbon::RigidBody body;
    body.position = positions()[slot(point)];
    body.inverse_mass = 1.0 / (share * mass);
    loads_.push_back({body, point});
  }
}

void TestedCord::operate(int point, Vec2 target) {
  direct_ ? direct_->operate(point, target) : thesis_->operate(point, target);
}

void TestedCord::release(int point) { direct_ ? direct_->release(point) : thesis_->release(point); }

void TestedCord::set_velocity(int point, Vec2 velocity) {
  direct_ ? direct_->set_velocity(point, velocity) : thesis_->set_velocity(point, velocity);
}

void TestedCord::stop() {
  for (int p = 0; p < columns_ * rows_; ++p) set_velocity(p, {});
  for (Load& load : loads_) load.body.velocity = {};
}

void TestedCord::step(double dt, Vec2 gravity, const ribbon::Surroundings& surroundings) {
  ++counts_.steps;
  if (direct_) {
    counts_.direct += direct_->step(dt, gravity, surroundings);
  } else {
    step_thesis(dt, gravity, surroundings);
  }
}

/// The loads follow the existing bodies.
void TestedCord::step_thesis(double dt, Vec2 gravity, const ribbon::Surroundings& surroundings) {
  bodies_.assign(surroundings.bodies.begin(), surroundings.bodies.end());
  grips_.assign(surroundings.grips.begin(), surroundings.grips.end());
  for (Load& load : loads_) {
    load.body.acceleration = gravity;
    grips_.push_back({load.point, static_cast<int>(bodies_.size()), {}});
    bodies_.push_back(load.body);
  }
  counts_.thesis += thesis_->step(dt, gravity, {bodies_, surroundings.circles, grips_});
  std::copy_n(bodies_.begin(), surroundings.bodies.size(), surroundings.bodies.begin());
  for (std::size_t k = 0; k < loads_.size(); ++k) {
    ribbon::RigidBody& body = loads_[k].body;
    const ribbon::RigidBody& after = bodies_[surroundings.bodies.size() + k];
    body.position += after.moved;
    body.velocity += dt * gravity + after.inverse_mass * after.impulse;
  }
}

std::span<const Vec2> TestedCord::positions() const { return direct_ ? direct_->positions() : thesis_->positions(); }
std::span<const Vec2> TestedCord::velocities() const { return direct_ ? direct_->velocities() : thesis_->velocities(); }

double TestedCord::mass(int point) const { return direct_ ? direct_->mass(point) : thesis_->def().point_mass; }

double TestedCord::total_mass() const {
  double sum = 0.0;
  for (int p = 0; p < columns_ * rows_; ++p) sum += mass(p);
  for (const Load& load : loads_) sum += 1.0 / load.body.inverse_mass;
  return sum;
}

double TestedCord::energy(Vec2 gravity) const {
  if (direct_) return energy_of(*direct_, gravity).total();
  double sum = test_support::kinetic_energy(*thesis_);
  const auto x = positions();
  for (const Vec2 p : x) sum -= thesis_->def().point_mass * dot(gravity, p);
  for (const auto& bar : thesis_->mesh().connections) {
    const double stretch = ribbon::length(x[slot(bar.b)] - x[slot(bar.a)]) - bar.rest_length;
    sum += 0.5 * thesis_->def().spring_stiffness * stretch * stretch;
  }
  for (const Load& load : loads_) {
    sum +=
        (0.5 * dot(load.body.velocity, load.body.velocity) - dot(gravity, load.body.position)) / load.body.inverse_mass;
  }
  return sum;
}

bool TestedCord::is_finite() const {
  const auto all = [](std::span<const Vec2> values) {
    return std::all_of(values.begin(), values.end(), [](Vec2 v) { return ribbon::is_finite(v); });
  };
  return all(positions()) && all(velocities());
}

double TestedCord::fastest() const {
  double most = 0.0;
  for (const Vec2 v : velocities()) most = std::max(most, ribbon::length(v));
  return most;
}

double TestedCord::length() const {
  Vec2 sum;
  for (int j = 0; j < rows_; ++j) sum += positions()[slot(index(columns_ - 1, j))] - positions()[slot(j)];
  return ribbon::length((1.0 / rows_) * sum);
}

/// Ratios of links, or of sides and diagonals of cells, to their rest lengths.
TestedCord::Lengths TestedCord::lengths() const {
  Lengths lengths;
  const auto x = positions();
  const auto take = [&](int a, int b, double rest) {
    const double ratio = ribbon::length(x[slot(b)] - x[slot(a)]) / rest;
    if (!(ratio >= lengths.shortest)) lengths.shortest = ratio;
    if (!(ratio <= lengths.longest)) lengths.longest = ratio;
  };
  if (thesis_) {
    for (const auto& bar : thesis_->mesh().connections) take(bar.a, bar.b, bar.rest_length);
    return lengths;
  }
  for (int i = 0; i < columns_; ++i) {
    for (int j = 0; j < rows_; ++j) {
      for (const auto& [di, dj] : {std::pair{1, 0}, {0, 1}, {1, 1}}) {
        if (i + di >= columns_ || j + dj >= rows_) continue;
        take(index(i, j), index(i + di, j + dj), ribbon::length({di * cell_.x, dj * cell_.y}));
      }
    }
  }
  return lengths;
}

double TestedCord::worst_strain(bool may_be_slack) const {
  const Lengths ratio = lengths();
  return may_be_slack ? ratio.longest - 1.0 : std::max(ratio.longest - 1.0, 1.0 - ratio.shortest);
}

std::string_view TestedCord::shape() const {
  if (inverted() > 0) return "inside out";
  const Lengths ratio = lengths();
  return 1.0 - ratio.shortest > ratio.longest - 1.0 ? "collapsed" : "stretched";
}

int TestedCord::inverted() const {
  if (thesis_) return test_support::inverted_triangles(*thesis_);
  int count = 0;
  const auto x = positions();
  for (int i = 0; i + 1 < columns_; ++i) {
    for (int j = 0; j + 1 < rows_; ++j) {
      const ribbon::Corners corners{x[slot(index(i, j))], x[slot(index(i, j + 1))], x[slot(index(i + 1, j))],
                                    x[slot(index(i + 1, j + 1))]};
      for (const double area : doubled_corner_areas(corners)) count += area <= 0.0 ? 1 : 0;
    }
  }
  return count;
}

}  // namespace extremes
