#include "ribbon/cord.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "ribbon/island/island.h"
#include "ribbon/system/cord_parts.h"

namespace ribbon {
namespace {

constexpr std::size_t usual_grips = 4;

const CordDef& checked(const CordDef& def) {
  check(def);
  return def;
}

}  // namespace

CordReport& CordReport::operator+=(const CordReport& other) {
  stages += other.stages;
  iterations += other.iterations;
  searches += other.searches;
  fallbacks += other.fallbacks;
  energy_gains += other.energy_gains;
  halvings += other.halvings;
  impacts += other.impacts;
  posed += other.posed;
  cuts += other.cuts;
  unlocked += other.unlocked;
  unconverged += other.unconverged;
  work += other.work;
  position_error = std::max(position_error, other.position_error);
  force_error = std::max(force_error, other.force_error);
  return *this;
}

Cord::Cord(const CordDef& def)
    : parts_(std::make_unique<CordParts>(checked(def))), island_(std::make_unique<Island>()) {
  reserve(usual_grips);
}

Cord::Cord(Cord&& other) noexcept = default;
Cord& Cord::operator=(Cord&& other) noexcept = default;
Cord::~Cord() = default;

CordReport Cord::step(double dt, Vec2 gravity, const Surroundings& surroundings) {
  check_step(dt, gravity);
  check_bodies(surroundings.bodies);
  check_met(surroundings, surroundings.bodies.size(), size(), parts_->def.rows);
  const IslandCord alone{this, surroundings};
  return island_->step({&alone, 1}, surroundings.bodies, dt, gravity);
}

const CordDef& Cord::def() const { return parts_->def; }
int Cord::size() const { return parts_->def.points * parts_->def.rows; }
int Cord::index(int i, int j) const { return i * parts_->def.rows + j; }
std::span<const Vec2> Cord::positions() const { return parts_->state.positions; }
std::span<const Vec2> Cord::velocities() const { return parts_->state.velocities; }
std::span<const double> Cord::tensions() const { return parts_->state.tensions; }
PointKind Cord::kind(int point) const { return parts_->state.kinds[slot(point)]; }
Vec2 Cord::target(int point) const { return parts_->state.targets[slot(point)]; }
double Cord::mass(int point) const { return parts_->state.masses[slot(point)]; }
double Cord::rest_length(int i) const { return parts_->state.rest[slot(i)]; }
Cord::Energy Cord::energy(Vec2 gravity) const { return parts_->energy(gravity); }
Cord::Sweep Cord::sweep() const { return parts_->sweep ? *parts_->sweep : parts_->find_sweep(); }
void Cord::remember_sweep() {
  if (!parts_->sweep) parts_->sweep = parts_->find_sweep();
}
bool Cord::remembers_sweep() const { return parts_->sweep.has_value(); }
bool Cord::is_asleep() const { return parts_->state.asleep; }
void Cord::wake() { parts_->wake(); }
std::span<const Touch> Cord::touches() const { return parts_->state.touches; }
std::span<const Cord::Holder> Cord::holders() const { return parts_->state.holders; }

void Cord::check_point(int point) const { check_range("point", point, 0, size() - 1); }

void Cord::attach_mass(int point, double mass) {
  check_point(point);
  check_range("attached mass", mass, 0.0, 1e12);
  parts_->state.masses[slot(point)] = parts_->own_masses[slot(point)] + mass;
  parts_->disturb();
}

void Cord::set_load(int point, Vec2 force) {
  check_point(point);
  check_coordinates("load", force);
  parts_->state.loads.resize(parts_->size());
  parts_->state.loads[slot(point)] = force;
  parts_->disturb();
}

void Cord::set_target(int point, Vec2 target, PointKind kind) {
  check_point(point);
  check_coordinates("target", target);
  parts_->state.targets[slot(point)] = target;
  parts_->state.kinds[slot(point)] = kind;
  parts_->disturb();
}

void Cord::constrain(int point, Vec2 target) { set_target(point, target, PointKind::constrained); }

void Cord::operate(int point, Vec2 target) { set_target(point, target, PointKind::operated); }

void Cord::release(int point) {
  check_point(point);
  parts_->state.kinds[slot(point)] = PointKind::free;
  parts_->disturb();
}

void Cord::set_velocity(int point, Vec2 velocity) {
  check_point(point);
  check_coordinates("velocity", velocity);
  parts_->exclude_damping();
  parts_->state.velocities[slot(point)] = velocity;
  parts_->disturb();
}

void Cord::set_accuracy(const Accuracy& accuracy) {
  check(accuracy);
  if (accuracy.integrator != parts_->def.accuracy.integrator)
    parts_->state.restart = true;  // implicit Euler's are those of another order
  parts_->def.accuracy = accuracy;
}

void Cord::reel(int first, int last, double length, double speed) {
  check_range("first", first, 0, parts_->def.points - 2);
  check_range("last", last, first + 1, parts_->def.points - 1);
  const double made = parts_->def.length * (last - first) / (parts_->def.points - 1);
  check_range("length", length, 1e-3 * made, 1e3 * made);
  if (!(speed > 0.0)) refuse("speed", speed, "above 0, up to 1e+06");
  check_range("speed", speed, 0.0, 1e6);

  double now = 0.0;
  for (std::size_t e = slot(first); e < slot(last); ++e) now += parts_->state.rest[e];
  const double link = parts_->def.length / (parts_->def.points - 1);
  for (std::size_t e = slot(first); e < slot(last); ++e) {
    // A millionth more, for sums that round.
    check_range("length of a reeled link", parts_->state.rest[e] * (length / now), 0.999999e-3 * link,
                1.000001e3 * link);
  }
  if (parts_->state.rest_targets.empty()) {
    parts_->state.rest_targets = parts_->state.rest;
    parts_->rest_start = parts_->state.rest;
    parts_->rest_end = parts_->state.rest;
    parts_->state.rest_speeds.resize(parts_->state.rest.size());
  }
  for (std::size_t e = slot(first); e < slot(last); ++e) {
    parts_->state.rest_targets[e] = parts_->state.rest[e] * (length / now);
    parts_->state.rest_speeds[e] = speed * (parts_->state.rest[e] / now);
  }
  parts_->disturb();
}

void Cord::reserve(std::size_t grips) {
  parts_->state.holders.reserve(grips);
  island_->reserve(*parts_, grips);
}

Cord::State Cord::save() const {
  State state;
  save(state);
  return state;
}

void Cord::save(State& state) const {
  const std::span<const char> unlocked = parts_->elasticity->unlocked();
  state.touches.reserve(parts_->state.touches.capacity());
  state = parts_->state;
  state.unlocked.assign(unlocked.begin(), unlocked.end());
}

void Cord::check_state(const State& state) const {
  const std::size_t n = parts_->size();
  const auto is_optional = [](std::size_t size, std::size_t wanted) { return size == wanted || size == 0; };
  if (state.positions.size() != n || state.velocities.size() != n || state.accelerations.size() != n ||
      state.targets.size() != n || state.kinds.size() != n || state.masses.size() != n ||
      !is_optional(state.loads.size(), n) || state.tensions.size() != parts_->state.tensions.size() ||
      state.rest.size() != parts_->state.rest.size() ||
      !is_optional(state.rest_targets.size(), parts_->state.rest.size()) ||
      state.rest_speeds.size() != state.rest_targets.size() ||
      state.unlocked.size() != parts_->elasticity->unlocked().size()) {
    throw DefinitionError("state is of another cord; accepted is one of " + std::to_string(parts_->def.points) + " x " +
                          std::to_string(parts_->def.rows) + " points with the same terms");
  }
  constexpr double anything = std::numeric_limits<double>::max();
  constexpr double something = std::numeric_limits<double>::min();
  const auto check_all = [](const char* field, std::span<const double> values, double low, double high) {
    for (const double value : values) check_range(field, value, low, high);
  };
  const auto check_vectors = [](const char* field, std::span<const Vec2> values) {
    for (const Vec2 value : values) {
      check_range(field, value.x, -anything, anything);
      check_range(field, value.y, -anything, anything);
    }
  };
  check_vectors("state.positions", state.positions);
  check_vectors("state.velocities", state.velocities);
  check_vectors("state.accelerations", state.accelerations);
  check_vectors("state.targets", state.targets);
  check_vectors("state.loads", state.loads);
  check_all("state.masses", state.masses, something, anything);
  check_all("state.tensions", state.tensions, -anything, anything);
  check_all("state.rest", state.rest, something, anything);
  check_all("state.rest_targets", state.rest_targets, something, anything);
  check_all("state.rest_speeds", state.rest_speeds, 0.0, anything);
  check_range("state.regainable_energy", state.regainable_energy, -anything, anything);
  check_range("state.energy_drift", state.energy_drift, -anything, anything);
  check_range("state.rest_time", state.rest_time, state.asleep ? time_to_sleep : 0.0,
              parts_->def.allow_sleep ? time_to_sleep : 0.0);
  for (const PointKind kind : state.kinds) check_range("state.kinds", static_cast<int>(kind), 0, 2);
  for (const Holder& holder : state.holders) {
    check_range("state.holders.point", holder.point, 0, size() - 1);
    check_vectors("state.holders", std::array{holder.velocity, holder.acceleration, holder.pull});
    check_all("state.holders", std::array{holder.turning, holder.angular_acceleration, holder.slid}, -anything,
              anything);
  }
  for (const Touch& touch : state.touches) {
    check_vectors("state.touches", std::array{touch.point, touch.normal});
    check_all("state.touches", std::array{touch.force, touch.stuck, touch.impulse}, -anything, anything);
  }
}

void Cord::restore(const State& state) {
  check_state(state);
  CordParts& parts = *parts_;
  parts.sweep.reset();
  parts.state = state;
  parts.state.unlocked.clear();
  parts.rest_start = state.rest_targets;
  parts.rest_end = state.rest_targets;
  std::copy(state.unlocked.begin(), state.unlocked.end(), parts.elasticity->unlocked().begin());
  parts.elasticity->set_rest_lengths(state.rest);
}

}  // namespace ribbon
