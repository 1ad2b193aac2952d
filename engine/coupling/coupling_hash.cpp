// The hash of a coupling's state. Structured bindings name every field, so a new field does not compile until it is
// added here.

#include "ribbon/box2d/coupling_state.h"
#include "ribbon/box2d/state_hash.h"

namespace ribbon::box2d {
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

/// Adds the counts that differ if two runs differ.
void add(Hasher& hasher, const IslandReport& report) {
  for (const int count : {report.stages, report.iterations, report.searches, report.fallbacks, report.energy_gains,
                          report.halvings, report.impacts, report.unlocked, report.unconverged}) {
    hasher.add(count);
  }
}

void add(Hasher& hasher, const StepReport& report) {
  const auto& [fem_skipped, motion_limited, self_contacts, circle_contacts, tangled_columns, strained_bars, turned_over,
               energy_gains] = report;
  for (const int count : {fem_skipped, motion_limited, self_contacts, circle_contacts, tangled_columns, strained_bars,
                          turned_over, energy_gains}) {
    hasher.add(count);
  }
}

void add(Hasher& hasher, const CouplingState::Cord& cord) {
  const auto& [id, state, enabled, island_report, island_total, error, thesis_report, thesis_total, touching, origin,
               sensing] = cord;
  (void)origin;
  (void)id;  // see add_ids
  hasher.add(state.index());
  std::visit([&](const auto& of_solver) { add_to(hasher, of_solver); }, state);
  hasher.add(enabled);
  add(hasher, island_report);
  add(hasher, island_total);
  hasher.add(error);
  add(hasher, thesis_report);
  add(hasher, thesis_total);
  hasher.add(touching.size());
  for (const FixtureTouch& touch : touching) add(hasher, touch);
  if (sensing.empty()) return;  // as in golden hashes
  hasher.add(sensing.size());
  for (const std::uint64_t number : sensing) hasher.add(number);
}

void add(Hasher& hasher, const CouplingState::Grip& grip) {
  const auto& [id, cord, point, local_anchor, next_anchor, along, strength, lets_go, most_pull, climb_to, climb_speed,
               pull, slips, blocked] = grip.memory;
  for (const int number : {grip.body, id, cord, point}) hasher.add(number);
  add(hasher, local_anchor);
  add(hasher, next_anchor);
  for (const double number : {along, strength, most_pull, climb_to, climb_speed}) hasher.add(number);
  hasher.add(pull);
  hasher.add(lets_go);
  hasher.add(slips);
  hasher.add(blocked);
}

void add(Hasher& hasher, const CouplingState::Carry& carried) {
  const auto& [carry, angular_carry, position, velocity, angular_velocity, start, start_velocity, dt, contact_delta_v,
               expected_delta_v, support_delta_v] = carried.memory;
  hasher.add(carried.body);
  for (const Vec2 v : {carry, position, velocity, start, start_velocity, contact_delta_v, expected_delta_v}) {
    hasher.add(v);
  }
  for (const double number : {angular_carry, angular_velocity, dt}) hasher.add(number);
  if (support_delta_v != Vec2{}) hasher.add(support_delta_v);  // so worlds without supports keep the hashes they had
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

void add(Hasher& hasher, const EndingTouch& ending) {
  const auto& [cord, touch] = ending;
  hasher.add(cord);
  add(hasher, touch);
}

void add(Hasher& hasher, const SensorMemory& memory) {
  const auto& [cord, begins, fixture] = memory;
  hasher.add(cord);
  hasher.add(begins);
  hasher.add(fixture);
}

void add(Hasher& hasher, const CutEvent& event) {
  const auto& [cord, arc, first, second, broke, tension, row] = event;
  hasher.add(cord);
  hasher.add(arc);
  for (const auto& piece : {first, second}) hasher.add(piece.value_or(-1));
  hasher.add(broke ? 1 : 0);
  hasher.add(tension);
  if (row > 0) hasher.add(row);
}

void add(Hasher& hasher, const PulleyMemory& pulley) {
  const auto& [id, cord, index, local_anchor] = pulley;
  for (const int number : {id, cord, index}) hasher.add(number);
  add(hasher, local_anchor);
}

void add(Hasher& hasher, const TieMemory& tie) {
  const auto& [id, place, other, breaking_force] = tie;
  for (const int number : {id, place.cord, place.point, other.cord, other.point}) hasher.add(number);
  hasher.add(breaking_force);
}

/// Adds the number of values too, so that lists with different boundaries have different hashes.
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

/// Adds the ids of the cords and the contacts that are about to end. As long as no cord has been removed they follow
/// from the number of cords and are left out: so the hash is that of versions without ids.
void add_ids(Hasher& hasher, const CouplingState& state) {
  CordId expected = 0;
  bool is_removed = false;
  for (const CouplingState::Cord& cord : state.cords) is_removed = is_removed || cord.id != expected++;
  if (!is_removed && state.next_cord == expected && state.ending.empty()) return;
  for (const CouplingState::Cord& cord : state.cords) hasher.add(cord.id);
  hasher.add(state.next_cord);
  add_all(hasher, state.ending);
}

}  // namespace

void add_to(Hasher& hasher, const CouplingState& state) {
  const auto& [bodies, next_cord, cords, grips, next_grip, ties, next_tie, pulleys, next_pulley, carries, fixtures,
               next_fixture, events, ending, cuts, old_cuts, sensor_events, ending_sensors, medium_time] = state;
  hasher.add(bodies);
  add_all(hasher, cords);
  add_all(hasher, grips);
  hasher.add(next_grip);
  add_all(hasher, carries);
  add_all(hasher, fixtures);
  hasher.add(next_fixture);
  add_all(hasher, events);
  (void)next_cord;
  (void)ending;
  add_ids(hasher, state);
  // Golden hashes are without pulleys, sensors, a medium, ties and cuts:
  if (next_pulley > 1) {
    hasher.add(pulleys.size());
    for (const CouplingState::Pulley& pulley : pulleys) {
      hasher.add(pulley.body);
      add(hasher, pulley.memory);
    }
    hasher.add(next_pulley);
  }
  if (!sensor_events.empty() || !ending_sensors.empty()) {
    add_all(hasher, sensor_events);
    add_all(hasher, ending_sensors);
  }
  if (medium_time > 0.0) hasher.add(medium_time);
  if (next_tie > 1) {
    add_all(hasher, ties);
    hasher.add(next_tie);
  }
  if (cuts.empty()) return;
  add_all(hasher, cuts);
  hasher.add(old_cuts);
}

void add_to(Hasher& hasher, const ThesisCord::State& state) {
  const auto& [positions, velocities, targets, kinds] = state;
  for (const auto* vectors : {&positions, &velocities, &targets}) add_all(hasher, *vectors);
  for (const PointKind kind : kinds) hasher.add(static_cast<int>(kind));
}

namespace {

void add(Hasher& hasher, const PulleyDef& def) {
  const auto& [center, radius, counterclockwise, turns, before, after, inertia, friction, motor_speed, motor_torque] =
      def;
  hasher.add(center);
  for (const double number : {radius, inertia, friction, motor_speed, motor_torque}) hasher.add(number);
  for (const int number : {static_cast<int>(counterclockwise), turns, before, after}) hasher.add(number);
}

void add(Hasher& hasher, const Pulley& pulley) {
  const auto& [def, lead, arc, arrival, departure, speed, acceleration, angle, turning, tension_before, tension_after,
               slip_sign, blocked, kept, motor_sign] = pulley;
  add(hasher, def);
  for (const Vec2 vector : {arrival, departure}) hasher.add(vector);
  for (const double number : {lead, arc, speed, acceleration, angle, turning, tension_before, tension_after, slip_sign,
                              blocked, motor_sign}) {
    hasher.add(number);
  }
  hasher.add(static_cast<int>(kept));
}

void add(Hasher& hasher, const Cord::Holder& holder) {
  const auto& [point, velocity, turning, acceleration, angular_acceleration, grip, pull, slid, slips] = holder;
  hasher.add(point);
  hasher.add(velocity);
  hasher.add(turning);
  hasher.add(acceleration);
  hasher.add(angular_acceleration);
  hasher.add(grip);
  hasher.add(pull);
  hasher.add(slid);
  if (slips != (slid != 0.0)) hasher.add(slips);  // most slips are told by how far it slid
}

void add(Hasher& hasher, const Touch& touch) {
  const auto& [other, feature, other_feature, force, stuck, impulse, point, normal, push] = touch;
  hasher.add(other);
  hasher.add(feature);
  hasher.add(other_feature);
  for (const double number : {force, stuck, impulse}) hasher.add(number);
  hasher.add(point);
  hasher.add(normal);
  if (!(push == Vec2{})) hasher.add(push);  // only where it is recorded
}

}  // namespace

void add_to(Hasher& hasher, const Cord::State& state) {
  const auto& [positions, velocities, accelerations, targets, kinds, masses, loads, medium_forces, tensions, rest,
               rest_targets, rest_speeds, breaking_forces, pulleys, unlocked, family, joined_first, joined_last, split,
               holders, touches, touch_changed, depenetration_share, newton_pause, regainable_energy, energy_drift,
               damping_excluded, restart, rest_time, asleep, surroundings_hash] = state;
  for (const auto* vectors : {&positions, &velocities, &accelerations, &targets, &loads}) add_all(hasher, *vectors);
  for (const auto* numbers : {&masses, &tensions, &rest, &rest_targets, &rest_speeds}) add_all(hasher, *numbers);
  add_all(hasher, unlocked);
  // Only where they are used, so that golden hashes stay:
  if (!breaking_forces.empty()) add_all(hasher, breaking_forces);
  if (depenetration_share < 1.0) hasher.add(depenetration_share);
  if (newton_pause > 0) hasher.add(newton_pause);
  for (const Pulley& pulley : pulleys) add(hasher, pulley);
  if (!medium_forces.empty()) add_all(hasher, medium_forces);
  // Ids as they are: as a std::size_t they lose their upper half where that has 32 bits, as in WebAssembly.
  for (const std::uint64_t joined : {family, joined_first, joined_last}) {
    if (joined != 0) hasher.add(joined);
  }
  if (split) hasher.add(1);
  for (const PointKind kind : kinds) hasher.add(static_cast<int>(kind));
  hasher.add(holders.size());
  for (const Cord::Holder& holder : holders) add(hasher, holder);
  hasher.add(touches.size());
  for (const Touch& touch : touches) add(hasher, touch);
  hasher.add(static_cast<int>(touch_changed));
  hasher.add(regainable_energy);
  hasher.add(energy_drift);
  hasher.add(static_cast<int>(damping_excluded));
  hasher.add(static_cast<int>(restart));
  hasher.add(rest_time);
  hasher.add(static_cast<int>(asleep));
  hasher.add(surroundings_hash);
}

}  // namespace ribbon::box2d
