#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "ribbon/cord.h"
#include "ribbon/system/cord_parts.h"

// Saving and restoring the state of a cord.

namespace ribbon {
namespace {

constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::min();

// Both look at all values without a branch first: a state has thousands, and the call of check_range costs more than
// the comparison.

void check_all(const char* field, std::span<const double> values, double low, double high) {
  std::int64_t refused = 0;
  for (const double value : values) refused += value >= low && value <= high ? 0 : 1;
  if (refused == 0) return;
  for (const double value : values) check_range(field, value, low, high);
}

void check_vectors(const char* field, std::span<const Vec2> values) {
  std::int64_t refused = 0;
  for (const Vec2 value : values) {
    refused += std::abs(value.x) <= largest && std::abs(value.y) <= largest ? 0 : 1;
  }
  if (refused == 0) return;
  for (const Vec2 value : values) {
    check_range(field, value.x, -largest, largest);
    check_range(field, value.y, -largest, largest);
  }
}

void check_sizes(const Cord::State& state, const CordParts& cord) {
  const std::size_t n = cord.size();
  const Cord::State& own = cord.state;
  const auto is_optional = [](std::size_t size, std::size_t wanted) { return size == wanted || size == 0; };
  if (state.positions.size() != n || state.velocities.size() != n || state.accelerations.size() != n ||
      state.targets.size() != n || state.kinds.size() != n || state.masses.size() != n ||
      !is_optional(state.loads.size(), n) || !is_optional(state.medium_forces.size(), n) ||
      state.tensions.size() != own.tensions.size() || state.rest.size() != own.rest.size() ||
      !is_optional(state.rest_targets.size(), own.rest.size()) ||
      state.rest_speeds.size() != state.rest_targets.size() ||
      !is_optional(state.breaking_forces.size(), own.rest.size()) ||
      state.unlocked.size() != cord.elasticity->unlocked().size()) {
    throw DefinitionError("state is of another cord; accepted is one of " + std::to_string(cord.def.points) + " x " +
                          std::to_string(cord.def.rows) + " points with the same terms");
  }
}

void check_pulleys(const Cord::State& state, const CordParts& cord) {
  if (state.pulleys.empty()) return;
  if (cord.def.rows > 1 || cord.def.bending_stiffness > 0.0) {
    throw DefinitionError("state.pulleys are of another cord; accepted are ones of a rope without bending stiffness");
  }
  int first = 0;
  for (const Pulley& pulley : state.pulleys) {
    check(pulley.def, cord.def.points);
    check_range("state.pulleys.before", pulley.def.before, first, cord.def.points - 2);
    first = pulley.def.after;
    check_vectors("state.pulleys", std::array{pulley.arrival, pulley.departure});
    check_all("state.pulleys",
              std::array{pulley.lead, pulley.arc, pulley.speed, pulley.acceleration, pulley.angle, pulley.turning,
                         pulley.tension_before, pulley.tension_after},
              -largest, largest);
    check_all("state.pulleys", std::array{pulley.slip_sign, pulley.motor_sign, pulley.blocked}, -1.0, 1.0);
  }
}

}  // namespace

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

void check_state(const Cord& cord, const Cord::State& state) {
  const CordParts& parts = cord.parts();
  check_sizes(state, parts);
  check_vectors("state.positions", state.positions);
  check_vectors("state.velocities", state.velocities);
  check_vectors("state.accelerations", state.accelerations);
  check_vectors("state.targets", state.targets);
  check_vectors("state.loads", state.loads);
  check_vectors("state.medium_forces", state.medium_forces);
  check_all("state.masses", state.masses, smallest, largest);
  check_all("state.tensions", state.tensions, -largest, largest);
  check_all("state.rest", state.rest, smallest, largest);
  check_all("state.rest_targets", state.rest_targets, smallest, largest);
  check_all("state.rest_speeds", state.rest_speeds, 0.0, largest);
  check_all("state.breaking_forces", state.breaking_forces, 0.0, std::numeric_limits<double>::infinity());
  check_range("state.depenetration_share", state.depenetration_share, smallest, 1.0);
  check_range("state.newton_pause", state.newton_pause, 0, CordParts::max_newton_pause);
  check_range("state.regainable_energy", state.regainable_energy, -largest, largest);
  check_range("state.energy_drift", state.energy_drift, -largest, largest);
  check_range("state.rest_time", state.rest_time, state.asleep ? Cord::time_to_sleep : 0.0,
              parts.def.allow_sleep ? Cord::time_to_sleep : 0.0);
  check_pulleys(state, parts);
  for (const PointKind kind : state.kinds) {
    if (kind > PointKind::constrained) check_range("state.kinds", static_cast<int>(kind), 0, 2);
  }
  for (const Cord::Holder& holder : state.holders) {
    check_range("state.holders.point", holder.point, 0, cord.size() - 1);
    check_vectors("state.holders", std::array{holder.velocity, holder.acceleration, holder.pull});
    check_all("state.holders", std::array{holder.turning, holder.angular_acceleration, holder.slid}, -largest, largest);
  }
  for (const Touch& touch : state.touches) {
    check_vectors("state.touches", std::array{touch.point, touch.normal});
    check_all("state.touches", std::array{touch.force, touch.stuck, touch.impulse, touch.push.x, touch.push.y},
              -largest, largest);
  }
}

void Cord::restore(const State& state) {
  check_state(*this, state);
  CordParts& parts = *parts_;
  parts.sweep.reset();
  parts.state = state;
  parts.state.unlocked.clear();
  parts.rest_start = state.rest_targets;
  parts.rest_end = state.rest_targets;
  parts.leave_out_links_on_wheels();
  std::copy(state.unlocked.begin(), state.unlocked.end(), parts.elasticity->unlocked().begin());
  parts.elasticity->set_rest_lengths(state.rest);
}

}  // namespace ribbon
