// The hash of a coupling's state. Everything is named, one and all: what is new in a state does not compile until it is
// added here.

#include "ribbon/box2d/coupling_state.h"
#include "ribbon/box2d/state_hash.h"

namespace engine {
namespace {

void add(Hasher& hasher, const FixtureTouch& touch) {
  const auto& [fixture, impulse, most, point, normal] = touch;
  hasher.add(fixture);
  hasher.add(impulse);
  hasher.add(most);
  hasher.add(point);
  hasher.add(normal);
}

void add(Hasher& hasher, b2Vec2 v) {
  hasher.add(v.x);
  hasher.add(v.y);
}

/// What tells runs apart: the rest of a report follows from the same steps.
void add(Hasher& hasher, const ribbon::CordReport& report) {
  for (const int count : {report.stages, report.iterations, report.searches, report.fallbacks, report.energy_gains,
                          report.halvings, report.impacts, report.unlocked, report.unconverged}) {
    hasher.add(count);
  }
}

void add(Hasher& hasher, const ribbon::StepReport& report) {
  const auto& [fem_skipped, motion_limited, self_contacts, circle_contacts, tangled_columns, strained_bars, turned_over,
               energy_gains] = report;
  for (const int count : {fem_skipped, motion_limited, self_contacts, circle_contacts, tangled_columns, strained_bars,
                          turned_over, energy_gains}) {
    hasher.add(count);
  }
}

void add(Hasher& hasher, const CouplingState::Cord& cord) {
  const auto& [state, enabled, direct_report, direct_total, direct_error, report, total, touching] = cord;
  hasher.add(state.index());
  std::visit([&](const auto& of_solver) { add_to(hasher, of_solver); }, state);
  hasher.add(enabled);
  add(hasher, direct_report);
  add(hasher, direct_total);
  hasher.add(direct_error);
  add(hasher, report);
  add(hasher, total);
  hasher.add(touching.size());
  for (const FixtureTouch& touch : touching) add(hasher, touch);
}

void add(Hasher& hasher, const CouplingState::Grip& grip) {
  const auto& [id, cord, point, local_hand, next_hand, along, strength, lets_go, most_pull, climb_to, climb_speed, pull,
               slips, held_up] = grip.memory;
  for (const int number : {grip.body, id, cord, point}) hasher.add(number);
  add(hasher, local_hand);
  add(hasher, next_hand);
  for (const double number : {along, strength, most_pull, climb_to, climb_speed}) hasher.add(number);
  hasher.add(pull);
  hasher.add(lets_go);
  hasher.add(slips);
  hasher.add(held_up);
}

void add(Hasher& hasher, const CouplingState::Led& led) {
  const auto& [ahead, ahead_turning, position, velocity, turning, start, dt, pushed, expected_push] = led.memory;
  hasher.add(led.body);
  for (const ribbon::Vec2 v : {ahead, position, velocity, start, pushed, expected_push}) hasher.add(v);
  for (const double number : {ahead_turning, turning, dt}) hasher.add(number);
}

void add(Hasher& hasher, const CouplingState::Fixture& known) {
  const auto& [body, place, id, seen] = known;
  hasher.add(body);
  hasher.add(place);
  hasher.add(id);
  hasher.add(seen);
}

void add(Hasher& hasher, const CouplingState::Event& event) {
  const auto& [cord, begins, fixture, impulse, point, normal] = event;
  hasher.add(cord);
  hasher.add(begins);
  hasher.add(fixture);
  hasher.add(impulse);
  hasher.add(point);
  hasher.add(normal);
}

/// How many there are, and all of them: one empty list more must not look like another one's end.
template <typename T>
void add_all(Hasher& hasher, const std::vector<T>& values) {
  hasher.add(values.size());
  for (const T& value : values) {
    if constexpr (requires { hasher.add(value); }) {
      hasher.add(value);
    } else {
      add(hasher, value);
    }
  }
}

}  // namespace

void add_to(Hasher& hasher, const CouplingState& state) {
  const auto& [bodies, cords, grips, next_grip, led, fixtures, next_fixture, events] = state;
  hasher.add(bodies);
  add_all(hasher, cords);
  add_all(hasher, grips);
  hasher.add(next_grip);
  add_all(hasher, led);
  add_all(hasher, fixtures);
  hasher.add(next_fixture);
  add_all(hasher, events);
}

void add_to(Hasher& hasher, const ribbon::ThesisCord::State& state) {
  const auto& [positions, velocities, targets, kinds] = state;
  for (const auto* vectors : {&positions, &velocities, &targets}) add_all(hasher, *vectors);
  for (const ribbon::PointKind kind : kinds) hasher.add(static_cast<int>(kind));
}

void add_to(Hasher& hasher, const ribbon::Cord::State& state) {
  const auto& [positions, velocities, accelerations, targets, kinds, masses, loads, tensions, rest, rest_targets,
               rest_speeds, unlocked, holders, touches, touch_changed, ledger, balance, damping_apart, restart, rested,
               asleep, still_among] = state;
  for (const auto* vectors : {&positions, &velocities, &accelerations, &targets, &loads}) add_all(hasher, *vectors);
  for (const auto* numbers : {&masses, &tensions, &rest, &rest_targets, &rest_speeds}) add_all(hasher, *numbers);
  add_all(hasher, unlocked);
  for (const ribbon::PointKind kind : kinds) hasher.add(static_cast<int>(kind));
  hasher.add(holders.size());
  for (const auto& [point, velocity, turning, acceleration, angular_acceleration, grip, pull, slid] : holders) {
    hasher.add(point);
    hasher.add(velocity);
    hasher.add(turning);
    hasher.add(acceleration);
    hasher.add(angular_acceleration);
    hasher.add(grip);
    hasher.add(pull);
    hasher.add(slid);
  }
  hasher.add(touches.size());
  for (const auto& [other, feature, other_feature, force, stuck, impulse, point, normal] : touches) {
    hasher.add(static_cast<std::size_t>(other));
    hasher.add(feature);
    hasher.add(other_feature);
    for (const double number : {force, stuck, impulse}) hasher.add(number);
    hasher.add(point);
    hasher.add(normal);
  }
  hasher.add(static_cast<int>(touch_changed));
  hasher.add(ledger);
  hasher.add(balance);
  hasher.add(static_cast<int>(damping_apart));
  hasher.add(static_cast<int>(restart));
  hasher.add(rested);
  hasher.add(static_cast<int>(asleep));
  hasher.add(still_among);
}

}  // namespace engine
