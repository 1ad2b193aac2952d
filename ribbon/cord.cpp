#include "ribbon/cord.h"

#include <algorithm>
#include <utility>

#include "ribbon/island/island.h"
#include "ribbon/linear/index.h"
#include "ribbon/pulley.h"
#include "ribbon/system/cord_parts.h"

namespace ribbon {
namespace {

constexpr std::size_t initial_grips = 4;

const CordDef& checked(const CordDef& def) {
  check(def);
  return def;
}

void check_point(const CordParts& cord, int point) {
  check_range("point", point, 0, static_cast<double>(cord.size()) - 1.0);
}

void set_target(CordParts& cord, int point, Vec2 target, PointKind kind) {
  check_point(cord, point);
  check_coordinates("target", target);
  for (const Pulley& pulley : cord.state.pulleys) {
    if (point <= pulley.def.before || point >= pulley.def.after) continue;
    throw CallError("point " + std::to_string(point) + " is on a wheel, between points " +
                    std::to_string(pulley.def.before) + " and " + std::to_string(pulley.def.after) +
                    "; accepted is one off the wheels");
  }
  cord.state.targets[at(point)] = target;
  cord.state.kinds[at(point)] = kind;
  cord.disturb();
}

}  // namespace

Cord::Cord(const CordDef& def)
    : parts_(std::make_unique<CordParts>(checked(def))), island_(std::make_unique<Island>()) {
  reserve(initial_grips);
}

Cord::Cord(std::unique_ptr<CordParts> parts) : parts_(std::move(parts)) {}

Cord::Cord(Cord&& other) noexcept = default;
Cord& Cord::operator=(Cord&& other) noexcept = default;
Cord::~Cord() = default;

double Cord::breaking_force(int link) const {
  check_range("link", link, 0, parts_->def.points - 2);
  const std::vector<double>& forces = parts_->state.breaking_forces;
  return forces.empty() ? parts_->def.breaking_force : forces[at(link)];
}

void check_axles(const Cord& cord, const Surroundings& surroundings) {
  if (surroundings.axles.size() == pulleys_of(cord).size()) return;
  throw DefinitionError("axles are " + std::to_string(surroundings.axles.size()) +
                        "; accepted is one for each of the " + std::to_string(pulleys_of(cord).size()) +
                        " pulleys of the cord");
}

IslandReport Cord::step(double dt, Vec2 gravity, const Surroundings& surroundings) {
  check_step(dt, gravity);
  check_bodies(surroundings.bodies);
  check_surroundings(surroundings, surroundings.bodies.size(), size(), parts_->def.rows);
  check_axles(*this, surroundings);
  if (!island_) {
    island_ = std::make_unique<Island>();
    reserve(std::max(initial_grips, parts_->state.holders.capacity()));
  }
  const IslandCord alone{this, surroundings};
  CordReport report;
  return island_->step({&alone, 1}, {}, surroundings.bodies, dt, gravity, {&report, 1});
}

const CordDef& Cord::def() const { return parts_->def; }
int Cord::size() const { return parts_->def.points * parts_->def.rows; }
int Cord::index(int i, int j) const { return i * parts_->def.rows + j; }
std::span<const Vec2> Cord::positions() const { return parts_->state.positions; }
std::span<const Vec2> Cord::velocities() const { return parts_->state.velocities; }
std::span<const double> Cord::tensions() const { return parts_->state.tensions; }
PointKind Cord::kind(int point) const { return parts_->state.kinds[at(point)]; }
Vec2 Cord::target(int point) const { return parts_->state.targets[at(point)]; }
double Cord::mass(int point) const { return parts_->state.masses[at(point)]; }
double Cord::rest_length(int i) const { return parts_->state.rest[at(i)]; }
bool Cord::is_asleep() const { return parts_->state.asleep; }
void Cord::wake() { parts_->wake(); }
std::span<const Touch> Cord::touches() const { return parts_->state.touches; }
std::span<const Cord::Holder> Cord::holders() const { return parts_->state.holders; }

void Cord::attach_mass(int point, double mass) {
  check_point(*parts_, point);
  check_range("attached mass", mass, 0.0, 1e12);
  parts_->state.masses[at(point)] = parts_->own_masses[at(point)] + parts_->mass_by_ring(at(point)) + mass;
  parts_->disturb();
}

void Cord::set_load(int point, Vec2 force) {
  check_point(*parts_, point);
  check_coordinates("load", force);
  parts_->state.loads.resize(parts_->size());
  parts_->state.loads[at(point)] = force;
  parts_->disturb();
}

void Cord::constrain(int point, Vec2 target) { set_target(*parts_, point, target, PointKind::constrained); }

void Cord::operate(int point, Vec2 target) { set_target(*parts_, point, target, PointKind::operated); }

void Cord::release(int point) {
  check_point(*parts_, point);
  parts_->state.kinds[at(point)] = PointKind::free;
  parts_->disturb();
}

void Cord::set_velocity(int point, Vec2 velocity) {
  check_point(*parts_, point);
  check_coordinates("velocity", velocity);
  parts_->exclude_damping();
  parts_->state.velocities[at(point)] = velocity;
  parts_->disturb();
}

void Cord::set_accuracy(const Accuracy& accuracy) {
  check(accuracy);
  if (accuracy.integrator != parts_->def.accuracy.integrator)
    parts_->state.restart = true;  // its accelerations have another order
  parts_->def.accuracy = accuracy;
}

void Cord::set_breaking_force(int link, double force) {
  check_range("link", link, 0, parts_->def.points - 2);
  if (!(force >= 0.0)) refuse("breaking force", force, "0 up to infinity");
  parts_->state.breaking_forces.resize(parts_->state.rest.size(), parts_->def.breaking_force);
  parts_->state.breaking_forces[at(link)] = force;
  parts_->wake();
}

void Cord::reel(int first, int last, double length, double speed) {
  check_range("first", first, 0, parts_->def.points - 2);
  check_range("last", last, first + 1, parts_->def.points - 1);
  const double initial = parts_->def.length * (last - first) / (parts_->def.points - 1);
  check_range("length", length, 1e-3 * initial, 1e3 * initial);
  if (!(speed > 0.0)) refuse("speed", speed, "above 0, up to 1e+06");
  check_range("speed", speed, 0.0, 1e6);

  double current = 0.0;
  for (std::size_t e = at(first); e < at(last); ++e) current += parts_->state.rest[e];
  const double link = parts_->def.length / (parts_->def.points - 1);
  for (std::size_t e = at(first); e < at(last); ++e) {
    // The range is a millionth wider, because the sum is rounded.
    check_range("length of a reeled link", parts_->state.rest[e] * (length / current), 0.999999e-3 * link,
                1.000001e3 * link);
  }
  if (parts_->state.rest_targets.empty()) {
    parts_->state.rest_targets = parts_->state.rest;
    parts_->rest_start = parts_->state.rest;
    parts_->rest_end = parts_->state.rest;
    parts_->state.rest_speeds.resize(parts_->state.rest.size());
  }
  for (std::size_t e = at(first); e < at(last); ++e) {
    parts_->state.rest_targets[e] = parts_->state.rest[e] * (length / current);
    parts_->state.rest_speeds[e] = speed * (parts_->state.rest[e] / current);
  }
  parts_->disturb();
}

void Cord::reserve(std::size_t grips) {
  parts_->state.holders.reserve(grips);
  if (island_) island_->reserve(*parts_, grips);
}

void Cord::free_solver() { island_.reset(); }

}  // namespace ribbon
