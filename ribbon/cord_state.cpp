#include <algorithm>
#include <array>
#include <limits>
#include <string>

#include "ribbon/cord.h"
#include "ribbon/elastic/elasticity.h"

// Saving and restoring the state of a cord.

namespace ribbon {
namespace {

constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::min();

void check_all(const char* field, std::span<const double> values, double low, double high) {
  for (const double value : values) check_range(field, value, low, high);
}

void check_vectors(const char* field, std::span<const Vec2> values) {
  for (const Vec2 value : values) {
    check_range(field, value.x, -largest, largest);
    check_range(field, value.y, -largest, largest);
  }
}

}  // namespace

Cord::State Cord::save() const {
  State state;
  save(state);
  return state;
}

void Cord::save(State& state) const {
  const std::span<const char> unlocked = elasticity_->unlocked();
  state.positions = positions_;
  state.velocities = velocities_;
  state.accelerations = accelerations_;
  state.targets = targets_;
  state.kinds = kinds_;
  state.masses = masses_;
  state.loads = loads_;
  state.tensions = tensions_;
  state.rest = rest_lengths_;
  state.rest_targets = reel_targets_;
  state.rest_speeds = reel_speeds_;
  state.unlocked.assign(unlocked.begin(), unlocked.end());
  state.holders = holders_;
  state.touches.reserve(touches_.capacity());
  state.touches = touches_;
  state.touch_changed = contacts_changed_;
  state.ledger = regainable_energy_;
  state.balance = energy_drift_;
  state.damping_apart = damping_excluded_;
  state.restart = restart_;
  state.rested = rest_time_;
  state.asleep = asleep_;
  state.still_among = rest_surroundings_hash_;
}

void Cord::check_sizes(const State& state) const {
  const std::size_t n = count();
  const auto is_optional = [](std::size_t size, std::size_t wanted) { return size == wanted || size == 0; };
  if (state.positions.size() != n || state.velocities.size() != n || state.accelerations.size() != n ||
      state.targets.size() != n || state.kinds.size() != n || state.masses.size() != n ||
      !is_optional(state.loads.size(), n) || state.tensions.size() != tensions_.size() ||
      state.rest.size() != rest_lengths_.size() || !is_optional(state.rest_targets.size(), rest_lengths_.size()) ||
      state.rest_speeds.size() != state.rest_targets.size() ||
      state.unlocked.size() != elasticity_->unlocked().size()) {
    throw DefinitionError("state is of another cord; accepted is one of " + std::to_string(def_.points) + " x " +
                          std::to_string(def_.rows) + " points with the same terms");
  }
}

void Cord::check_state(const State& state) const {
  check_sizes(state);
  check_vectors("state.positions", state.positions);
  check_vectors("state.velocities", state.velocities);
  check_vectors("state.accelerations", state.accelerations);
  check_vectors("state.targets", state.targets);
  check_vectors("state.loads", state.loads);
  check_all("state.masses", state.masses, smallest, largest);
  check_all("state.tensions", state.tensions, -largest, largest);
  check_all("state.rest", state.rest, smallest, largest);
  check_all("state.rest_targets", state.rest_targets, smallest, largest);
  check_all("state.rest_speeds", state.rest_speeds, 0.0, largest);
  check_range("state.ledger", state.ledger, -largest, largest);
  check_range("state.balance", state.balance, -largest, largest);
  check_range("state.rested", state.rested, state.asleep ? time_to_sleep : 0.0, def_.allow_sleep ? time_to_sleep : 0.0);
  for (const PointKind kind : state.kinds) check_range("state.kinds", static_cast<int>(kind), 0, 2);
  for (const Holder& holder : state.holders) {
    check_range("state.holders.point", holder.point, 0, size() - 1);
    check_vectors("state.holders", std::array{holder.velocity, holder.acceleration, holder.pull});
    check_all("state.holders", std::array{holder.turning, holder.angular_acceleration, holder.slid}, -largest, largest);
  }
  for (const Touch& touch : state.touches) {
    check_vectors("state.touches", std::array{touch.point, touch.normal});
    check_all("state.touches", std::array{touch.force, touch.stuck, touch.impulse}, -largest, largest);
  }
}

void Cord::restore(const State& state) {
  check_state(state);
  sweep_.reset();
  positions_ = state.positions;
  velocities_ = state.velocities;
  accelerations_ = state.accelerations;
  targets_ = state.targets;
  kinds_ = state.kinds;
  masses_ = state.masses;
  loads_ = state.loads;
  tensions_ = state.tensions;
  rest_lengths_ = state.rest;
  reel_targets_ = state.rest_targets;
  reel_start_ = state.rest_targets;
  reel_end_ = state.rest_targets;
  reel_speeds_ = state.rest_speeds;
  std::copy(state.unlocked.begin(), state.unlocked.end(), elasticity_->unlocked().begin());
  holders_ = state.holders;
  touches_ = state.touches;
  contacts_changed_ = state.touch_changed;
  regainable_energy_ = state.ledger;
  energy_drift_ = state.balance;
  damping_excluded_ = state.damping_apart;
  restart_ = state.restart;
  rest_time_ = state.rested;
  asleep_ = state.asleep;
  rest_surroundings_hash_ = state.still_among;
  elasticity_->set_rest_lengths(rest_lengths_);
}

}  // namespace ribbon
