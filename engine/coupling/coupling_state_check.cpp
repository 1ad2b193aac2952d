#include "ribbon/box2d/coupling_state_check.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "ribbon/box2d/convert.h"

namespace ribbon::box2d {
namespace {

constexpr double most = std::numeric_limits<double>::max();
constexpr double most_single = 1e30;  // limit of values that become single precision
constexpr double most_ids = 1e9;      // of cords or grips that were ever added
constexpr double most_time = 1e12;    // s
constexpr double most_number = 1e12;  // limit of fixture numbers: ids of their corners must fit into 63 bits

void check_vectors(const char* field, std::initializer_list<Vec2> vectors, double limit) {
  for (const Vec2 v : vectors) {
    check_range(field, v.x, -limit, limit);
    check_range(field, v.y, -limit, limit);
  }
}

void check_body(const char* field, int body, const std::vector<b2Body*>& bodies) {
  check_range(field, body, 0, static_cast<double>(bodies.size()) - 1.0);
}

/// Throws DefinitionError unless a list is ascending by `key`.
template <typename List, typename Key>
void check_order(const char* field, const List& list, Key key) {
  const auto falls = [&](const auto& a, const auto& b) { return !(key(a) < key(b)); };
  if (std::adjacent_find(list.begin(), list.end(), falls) == list.end()) return;
  throw DefinitionError(std::string(field) + " are out of order, or some are there twice; accepted are rising numbers");
}

void check_fixtures(const CouplingState& state, const std::vector<b2Body*>& bodies,
                    std::vector<std::pair<int, int>>& places) {
  check_range("state.next_fixture", static_cast<double>(state.next_fixture), 1, most_number);
  check_order("state.fixtures", state.fixtures, [](const auto& known) { return known.id; });
  places.clear();
  for (const CouplingState::Fixture& known : state.fixtures) {
    check_range("state.fixtures.id", static_cast<double>(known.id), 1, static_cast<double>(state.next_fixture) - 1.0);
    check_body("state.fixtures.body", known.body, bodies);
    const int count = fixture_count(*bodies[static_cast<std::size_t>(known.body)]);
    check_range("state.fixtures.place", known.place, 0, count - 1);
    places.emplace_back(known.body, known.place);
  }
  std::sort(places.begin(), places.end());
  check_order("state.fixtures.place", places, [](const auto& place) { return place; });
}

/// Throws DefinitionError unless a number is `low` or more and that of a fixture.
void check_number(const char* field, std::uint64_t number, int low, const CouplingState& state) {
  check_range(field, static_cast<double>(number), low, static_cast<double>(state.next_fixture) - 1.0);
}

void check_touch(const char* field, const FixtureTouch& touch, std::uint64_t next) {
  const auto check = [field](const char* part, double value, double low, double high) {
    if (!(value >= low && value <= high)) check_range((std::string(field) + part).c_str(), value, low, high);
  };
  check(".fixture", static_cast<double>(touch.fixture), 1, static_cast<double>(next) - 1.0);
  check(".impulse", touch.impulse, -most, most);
  check(".most", touch.most, -most, most);
  check_vectors(field, {touch.point, touch.normal}, most);
}

void check_touches(const char* field, const std::vector<FixtureTouch>& touches, std::uint64_t next) {
  check_order(field, touches, [](const FixtureTouch& touch) { return touch.fixture; });
  for (const FixtureTouch& touch : touches) check_touch(field, touch, next);
}

void check_memory(const GripMemory& grip, const CordShape& shape, bool is_direct) {
  check_range("state.grips.point", grip.point, 0, shape.columns * shape.rows - 1);
  check_coordinates("state.grips.local_anchor", to_double(grip.local_anchor));
  check_coordinates("state.grips.next_anchor", to_double(grip.next_anchor));
  const bool between = is_direct && grip.point / shape.rows + 1 < shape.columns;
  check_range("state.grips.along", grip.along, 0.0, between ? 1.0 : 0.0);
  if (!(grip.strength >= 0.0)) refuse("state.grips.strength", grip.strength, "0 or more");
  if (!(grip.most_pull >= 0.0)) refuse("state.grips.most_pull", grip.most_pull, "0 or more");
  check_range("state.grips.climb_to", grip.climb_to, -1.0, is_direct ? shape.columns - 1.0 : -1.0);
  check_range("state.grips.climb_speed", grip.climb_speed, 0.0, most);
  check_vectors("state.grips.pull", {grip.pull}, most);
}

void check_memory(const CarryState& carry) {
  check_vectors("state.carries.carry", {carry.carry}, CarryState::max_carry);
  check_vectors("state.carries",
                {carry.position, carry.velocity, carry.start, carry.start_velocity, carry.contact_delta_v,
                 carry.expected_delta_v, carry.support_delta_v},
                most_single);
  check_range("state.carries.angular_carry", carry.angular_carry, -CarryState::max_carry, CarryState::max_carry);
  check_range("state.carries.angular_velocity", carry.angular_velocity, -most_single, most_single);
  check_range("state.carries.dt", carry.dt, 0.0, 1.0);
}

void check_cord(const CouplingState::Cord& from, const CoupledCord& cord, const CouplingState& state) {
  if (from.state.index() != cord.cord.index()) {
    throw DefinitionError("state of cord " + std::to_string(cord.id) + " is of another solver; accepted is " +
                          std::string(solver_name(cord.solver())));
  }
  if (cord.is_direct()) {
    ribbon::check_state(cord.direct(), std::get<Cord::State>(from.state));
  } else {
    cord.thesis().check_state(std::get<ThesisCord::State>(from.state));
  }
  check_range("state.cords.error", from.error, 0.0, most);
  check_touches("state.cords.touching", from.touching, state.next_fixture);
  check_order("state.cords.sensing", from.sensing, [](std::uint64_t number) { return number; });
  for (const std::uint64_t number : from.sensing) check_number("state.cords.sensing", number, 1, state);
}

/// Returns the cord that a saved one is restored to: a missing one, or that of the coupling.
const CoupledCord& restored_to(CordId id, const CordTable& cords, const std::vector<CoupledCord>& missing) {
  const auto found =
      std::find_if(missing.begin(), missing.end(), [id](const CoupledCord& cord) { return cord.id == id; });
  return found != missing.end() ? *found : cords.at(id);
}

void check_cords(const CouplingState& state, const CordTable& cords, const std::vector<CoupledCord>& missing) {
  check_range("state.next_cord", state.next_cord, 0, most_ids);
  check_order("state.cords.id", state.cords, [](const CouplingState::Cord& cord) { return cord.id; });
  for (const CouplingState::Cord& from : state.cords) {
    check_range("state.cords.id", from.id, 0, state.next_cord - 1);
    check_cord(from, restored_to(from.id, cords, missing), state);
  }
}

void check_enabled(const char* field, CordId id, const CouplingState& state) {
  const auto found = std::lower_bound(state.cords.begin(), state.cords.end(), id,
                                      [](const CouplingState::Cord& cord, CordId wanted) { return cord.id < wanted; });
  if (found != state.cords.end() && found->id == id && found->enabled) return;
  throw DefinitionError(std::string(field) + " is " + std::to_string(id) + "; accepted is the id of an enabled cord");
}

void check_grips(const CouplingState& state, const std::vector<b2Body*>& bodies, const CordTable& cords,
                 const std::vector<CoupledCord>& missing) {
  check_range("state.next_grip", state.next_grip, 1, most_ids);
  for (const CouplingState::Grip& grip : state.grips) {
    check_body("state.grips.body", grip.body, bodies);
    check_enabled("state.grips.cord", grip.memory.cord, state);
    check_range("state.grips.id", grip.memory.id, 1, state.next_grip - 1);
    const CoupledCord& cord = restored_to(grip.memory.cord, cords, missing);
    check_memory(grip.memory, cord.shape(), cord.is_direct());
  }
  check_order("state.grips.id", state.grips, [](const CouplingState::Grip& grip) { return grip.memory.id; });
}

/// Ties are checked as new ones are. `cords` has those of the state.
void check_ties(const CouplingState& state, const CordTable& cords, const std::vector<CoupledCord>& missing) {
  check_range("state.next_tie", state.next_tie, 1, most_ids);
  check_order("state.ties.id", state.ties, [](const TieMemory& tie) { return tie.id; });
  for (const TieMemory& tie : state.ties) {
    check_range("state.ties.id", tie.id, 1, state.next_tie - 1);
    for (const TiePlace& place : {tie.place, tie.other}) {
      check_enabled("state.ties.cord", place.cord, state);
      const CoupledCord& cord = restored_to(place.cord, cords, missing);
      if (!cord.is_direct()) {
        throw DefinitionError("state.ties.cord is " + std::to_string(place.cord) +
                              ", a cord of the thesis solver; accepted is one of the direct solver");
      }
      check_range("state.ties.point", place.point, 0, cord.direct().size() - 1.0);
    }
    if (!(tie.breaking_force > 0.0)) refuse("state.ties.breaking_force", tie.breaking_force, "above 0");
  }
  try {
    check_connections(state.ties);
  } catch (const CallError& error) {
    throw DefinitionError(std::string("state.ties: ") + error.what());
  }
}

/// The pulleys of each cord are those of its state, each once.
void check_pulleys(const CouplingState& state, const std::vector<b2Body*>& bodies) {
  check_range("state.next_pulley", state.next_pulley, 1, most_ids);
  check_order("state.pulleys.id", state.pulleys, [](const CouplingState::Pulley& pulley) { return pulley.memory.id; });
  std::vector<std::pair<CordId, int>> listed;
  for (const CouplingState::Pulley& pulley : state.pulleys) {
    check_body("state.pulleys.body", pulley.body, bodies);
    check_range("state.pulleys.id", pulley.memory.id, 1, state.next_pulley - 1);
    check_enabled("state.pulleys.cord", pulley.memory.cord, state);
    check_coordinates("state.pulleys.local_anchor", to_double(pulley.memory.local_anchor));
    listed.emplace_back(pulley.memory.cord, pulley.memory.index);
  }
  std::vector<std::pair<CordId, int>> wanted;
  for (const CouplingState::Cord& cord : state.cords) {
    const auto* const direct = std::get_if<Cord::State>(&cord.state);
    const int count = direct == nullptr ? 0 : static_cast<int>(direct->pulleys.size());
    for (int index = 0; index < count; ++index) wanted.emplace_back(cord.id, index);
  }
  std::sort(listed.begin(), listed.end());
  if (listed != wanted) {
    throw DefinitionError("state.pulleys are not those of its cords; accepted is one for each pulley of a cord");
  }
}

void check_carries(const CouplingState& state, const std::vector<b2Body*>& bodies) {
  check_order("state.carries.body", state.carries, [](const CouplingState::Carry& carry) { return carry.body; });
  for (const CouplingState::Carry& carry : state.carries) {
    check_body("state.carries.body", carry.body, bodies);
    check_memory(carry.memory);
  }
}

void check_events(const CouplingState& state) {
  for (const CouplingState::Event& event : state.events) {
    check_range("state.events.cord", event.cord, 0, state.next_cord - 1);
    check_range("state.events.fixture", static_cast<double>(event.fixture), 0,
                static_cast<double>(state.next_fixture) - 1.0);
    check_range("state.events.impulse", event.impulse, -most, most);
    check_vectors("state.events", {event.point, event.normal}, most);
  }
  check_order("state.ending", state.ending,
              [](const EndingTouch& ending) { return std::pair(ending.cord, ending.touch.fixture); });
  for (const EndingTouch& ending : state.ending) {
    check_range("state.ending.cord", ending.cord, 0, state.next_cord - 1);
    check_touch("state.ending.touch", ending.touch, state.next_fixture);
  }
}

void check_sensor_events(const CouplingState& state) {
  for (const SensorMemory& event : state.sensor_events) {
    check_range("state.sensor_events.cord", event.cord, 0, state.next_cord - 1);
    check_number("state.sensor_events.fixture", event.fixture, 0, state);
  }
  check_order("state.ending_sensors", state.ending_sensors,
              [](const SensorMemory& ending) { return std::pair(ending.cord, ending.fixture); });
  for (const SensorMemory& ending : state.ending_sensors) {
    check_range("state.ending_sensors.cord", ending.cord, 0, state.next_cord - 1);
    check_number("state.ending_sensors.fixture", ending.fixture, 1, state);
  }
}

void check_cuts(const CouplingState& state) {
  for (const CutEvent& event : state.cuts) {
    check_range("state.cuts.cord", event.cord, 0, state.next_cord - 1);
    for (const auto& piece : {event.first, event.second}) {
      if (piece) check_range("state.cuts.piece", *piece, 0, state.next_cord - 1);
    }
    check_range("state.cuts.arc", event.arc, 0.0, most);
    check_range("state.cuts.tension", event.tension, 0.0, most);
  }
  check_range("state.old_cuts", static_cast<double>(state.old_cuts), 0, static_cast<double>(state.cuts.size()));
}

}  // namespace

int fixture_count(const b2Body& body) {
  int count = 0;
  for (const b2Fixture* f = body.GetFixtureList(); f != nullptr; f = f->GetNext()) ++count;
  return count;
}

void check_state(const CouplingState& state, RestoreMemory& memory, const CordTable& cords,
                 const std::vector<CoupledCord>& missing) {
  const std::vector<b2Body*>& bodies = memory.bodies;
  if (state.bodies != static_cast<int>(bodies.size())) {
    throw DefinitionError("state is of a world of " + std::to_string(state.bodies) + " bodies; accepted is one of " +
                          std::to_string(bodies.size()));
  }
  check_fixtures(state, bodies, memory.places);
  check_cords(state, cords, missing);
  check_grips(state, bodies, cords, missing);
  check_ties(state, cords, missing);
  check_pulleys(state, bodies);
  check_carries(state, bodies);
  check_events(state);
  check_sensor_events(state);
  check_cuts(state);
  check_range("state.medium_time", state.medium_time, 0.0, most_time);
}

}  // namespace ribbon::box2d
