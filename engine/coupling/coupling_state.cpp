// A coupling's state: taken, looked at, and taken up again.

#include "ribbon/box2d/coupling_state.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/coupling.h"

namespace engine {
namespace {

using ribbon::DefinitionError;
using ribbon::Vec2;

constexpr double most = std::numeric_limits<double>::max();
constexpr double most_single = 1e30;  // of what becomes single precision
constexpr double most_number = 1e12;  // of fixtures, so that numbers of their corners fit into 63 bits

std::vector<b2Body*> bodies_of(b2Body* newest) {
  std::vector<b2Body*> bodies;
  for (b2Body* body = newest; body != nullptr; body = body->GetNext()) bodies.push_back(body);
  std::reverse(bodies.begin(), bodies.end());
  return bodies;
}

std::vector<const b2Fixture*> fixtures_of(const b2Body& body) {
  std::vector<const b2Fixture*> fixtures;
  for (const b2Fixture* f = body.GetFixtureList(); f != nullptr; f = f->GetNext()) fixtures.push_back(f);
  std::reverse(fixtures.begin(), fixtures.end());
  return fixtures;
}

void check_vectors(const char* field, std::initializer_list<Vec2> vectors, double limit) {
  for (const Vec2 v : vectors) {
    ribbon::check_range(field, v.x, -limit, limit);
    ribbon::check_range(field, v.y, -limit, limit);
  }
}

void check_body(const char* field, int body, const std::vector<b2Body*>& bodies) {
  ribbon::check_range(field, body, 0, static_cast<double>(bodies.size()) - 1.0);
}

/// That a list rises by `key`.
template <typename List, typename Key>
void check_order(const char* field, const List& list, Key key) {
  const auto falls = [&](const auto& a, const auto& b) { return !(key(a) < key(b)); };
  if (std::adjacent_find(list.begin(), list.end(), falls) == list.end()) return;
  throw DefinitionError(std::string(field) + " are out of order, or some are there twice; accepted are rising numbers");
}

void check_fixtures(const CouplingState& state, const std::vector<b2Body*>& bodies) {
  ribbon::check_range("state.next_fixture", static_cast<double>(state.next_fixture), 1, most_number);
  check_order("state.fixtures", state.fixtures, [](const auto& known) { return known.id; });
  std::vector<std::pair<int, int>> places;
  for (const CouplingState::Fixture& known : state.fixtures) {
    ribbon::check_range("state.fixtures.id", static_cast<double>(known.id), 1,
                        static_cast<double>(state.next_fixture) - 1.0);
    check_body("state.fixtures.body", known.body, bodies);
    const auto count = fixtures_of(*bodies[static_cast<std::size_t>(known.body)]).size();
    ribbon::check_range("state.fixtures.place", known.place, 0, static_cast<double>(count) - 1.0);
    places.emplace_back(known.body, known.place);
  }
  std::sort(places.begin(), places.end());
  check_order("state.fixtures.place", places, [](const auto& place) { return place; });
}

void check_touches(const std::vector<FixtureTouch>& touches, std::uint64_t next) {
  check_order("state.cords.touching", touches, [](const FixtureTouch& touch) { return touch.fixture; });
  for (const FixtureTouch& touch : touches) {
    ribbon::check_range("state.cords.touching.fixture", static_cast<double>(touch.fixture), 1,
                        static_cast<double>(next) - 1.0);
    ribbon::check_range("state.cords.touching.impulse", touch.impulse, -most, most);
    ribbon::check_range("state.cords.touching.most", touch.most, -most, most);
    check_vectors("state.cords.touching", {touch.point, touch.normal}, most);
  }
}

void check_memory(const GripMemory& grip, const CordShape& shape, bool is_direct) {
  ribbon::check_range("state.grips.point", grip.point, 0, shape.columns * shape.rows - 1);
  ribbon::check_coordinates("state.grips.local_hand", to_double(grip.local_hand));
  ribbon::check_coordinates("state.grips.next_hand", to_double(grip.next_hand));
  const bool between = is_direct && grip.point / shape.rows + 1 < shape.columns;
  ribbon::check_range("state.grips.along", grip.along, 0.0, between ? 1.0 : 0.0);
  if (!(grip.strength >= 0.0)) ribbon::refuse("state.grips.strength", grip.strength, "0 or more");
  if (!(grip.most_pull >= 0.0)) ribbon::refuse("state.grips.most_pull", grip.most_pull, "0 or more");
  ribbon::check_range("state.grips.climb_to", grip.climb_to, -1.0, is_direct ? shape.columns - 1.0 : -1.0);
  ribbon::check_range("state.grips.climb_speed", grip.climb_speed, 0.0, most);
  check_vectors("state.grips.pull", {grip.pull}, most);
}

void check_memory(const LedMemory& led) {
  check_vectors("state.led.ahead", {led.ahead}, LedMemory::most_ahead);
  check_vectors("state.led", {led.position, led.velocity, led.start, led.pushed, led.expected_push}, most_single);
  ribbon::check_range("state.led.ahead_turning", led.ahead_turning, -LedMemory::most_ahead, LedMemory::most_ahead);
  ribbon::check_range("state.led.turning", led.turning, -most_single, most_single);
  ribbon::check_range("state.led.dt", led.dt, 0.0, 1.0);
}

}  // namespace

CouplingState Coupling::save(const b2World& world) const {
  State state;
  state.bodies = world.GetBodyCount();
  state.next_grip = next_grip_;
  state.next_fixture = fixture_ids_.next();
  for (const CoupledCord& coupled : cords_) {
    State::Cord cord;
    std::visit([&](const auto& of_solver) { cord.state = of_solver.save(); }, coupled.cord);
    cord.enabled = coupled.enabled;
    cord.direct_report = coupled.direct_report;
    cord.direct_total = coupled.direct_total;
    cord.direct_error = coupled.direct_error;
    cord.report = coupled.report;
    cord.total = coupled.total;
    cord.touching = coupled.touching;
    state.cords.push_back(std::move(cord));
  }
  std::vector<int> places(holders_.size(), -1);
  int body_place = state.bodies;
  for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
    --body_place;
    for (std::size_t k = 0; k < holders_.size(); ++k) {
      if (holders_[k].seen.is(*body)) places[k] = body_place;
    }
    if (const LedBody* found = led(*body)) state.led.push_back({body_place, *found});
    int place = 0;
    for (const b2Fixture* fixture : fixtures_of(*body)) {
      const auto* known = fixture_ids_.find(*fixture);
      if (known != nullptr) state.fixtures.push_back({body_place, place, known->id, known->seen});
      ++place;
    }
  }
  for (std::size_t k = 0; k < holders_.size(); ++k) {
    if (places[k] >= 0) state.grips.push_back({places[k], holders_[k]});
  }
  std::reverse(state.led.begin(), state.led.end());
  std::sort(state.fixtures.begin(), state.fixtures.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  for (const TouchEvent& event : touch_events_) {
    const bool is_kept_fixture = std::any_of(state.fixtures.begin(), state.fixtures.end(),
                                             [&event](const auto& kept) { return kept.id == event.number; });
    state.events.push_back(
        {event.cord, event.begins, is_kept_fixture ? event.number : 0, event.impulse, event.point, event.normal});
  }
  return state;
}

void Coupling::check_state(const State& state, const std::vector<b2Body*>& bodies) const {
  if (state.cords.size() != cords_.size()) {
    throw DefinitionError("state is of " + std::to_string(state.cords.size()) + " cords; accepted is one of " +
                          std::to_string(size()));
  }
  if (state.bodies != static_cast<int>(bodies.size())) {
    throw DefinitionError("state is of a world of " + std::to_string(state.bodies) + " bodies; accepted is one of " +
                          std::to_string(bodies.size()));
  }
  check_fixtures(state, bodies);
  for (CordIndex c = 0; c < size(); ++c) {
    const State::Cord& cord = state.cords[at(c)];
    if (cord.state.index() != cords_[at(c)].cord.index()) {
      throw DefinitionError("state of cord " + std::to_string(c) + " is of another solver; accepted is " +
                            std::string(solver_name(solver(c))));
    }
    if (solver(c) == Solver::direct) {
      this->cord(c).check_state(std::get<ribbon::Cord::State>(cord.state));
    } else {
      thesis_cord(c).check_state(std::get<ribbon::ThesisCord::State>(cord.state));
    }
    ribbon::check_range("state.cords.direct_error", cord.direct_error, 0.0, most);
    check_touches(cord.touching, state.next_fixture);
  }
  ribbon::check_range("state.next_grip", state.next_grip, 1, std::numeric_limits<int>::max());
  std::vector<int> numbers;
  for (const State::Grip& grip : state.grips) {
    check_body("state.grips.body", grip.body, bodies);
    ribbon::check_range("state.grips.cord", grip.memory.cord, 0, size() - 1);
    if (!state.cords[at(grip.memory.cord)].enabled) {
      throw DefinitionError("state.grips.cord is " + std::to_string(grip.memory.cord) +
                            ", which is switched off; accepted is one that is enabled");
    }
    ribbon::check_range("state.grips.id", grip.memory.id, 1, state.next_grip - 1);
    check_memory(grip.memory, shape(grip.memory.cord), solver(grip.memory.cord) == Solver::direct);
    numbers.push_back(grip.memory.id);
  }
  check_order("state.grips.id", numbers, [](int id) { return id; });
  check_order("state.led.body", state.led, [](const State::Led& led) { return led.body; });
  for (const State::Led& led : state.led) {
    check_body("state.led.body", led.body, bodies);
    check_memory(led.memory);
  }
  for (const State::Event& event : state.events) {
    ribbon::check_range("state.events.cord", event.cord, 0, size() - 1);
    ribbon::check_range("state.events.fixture", static_cast<double>(event.fixture), 0,
                        static_cast<double>(state.next_fixture) - 1.0);
    ribbon::check_range("state.events.impulse", event.impulse, -most, most);
    check_vectors("state.events", {event.point, event.normal}, most);
  }
}

void Coupling::restore(const State& state, b2World& world) {
  if (world.IsLocked()) throw DefinitionError("world is locked; accepted is one that is not inside its Step");
  const std::vector<b2Body*> bodies = bodies_of(world.GetBodyList());
  check_state(state, bodies);

  for (std::size_t c = 0; c < cords_.size(); ++c) {
    const State::Cord& from = state.cords[c];
    CoupledCord& to = cords_[c];
    if (auto* direct = std::get_if<ribbon::Cord>(&to.cord)) {
      direct->restore(std::get<ribbon::Cord::State>(from.state));
    } else {
      std::get<ribbon::ThesisCord>(to.cord).restore(std::get<ribbon::ThesisCord::State>(from.state));
    }
    to.enabled = from.enabled;
    to.direct_report = from.direct_report;
    to.direct_total = from.direct_total;
    to.direct_error = from.direct_error;
    to.report = from.report;
    to.total = from.total;
    to.touching = from.touching;
    to.circles.clear();
    to.segments.clear();
    to.grips.clear();
    to.grip_ids.clear();
  }
  gathered_.clear();
  rigid_.clear();
  body_places_.clear();

  holders_.clear();
  for (const State::Grip& grip : state.grips) {
    b2Body* const body = bodies[at(grip.body)];
    holders_.push_back({grip.memory, body, SeenBody(*body)});
  }
  next_grip_ = state.next_grip;
  led_.clear();
  for (const State::Led& led : state.led) {
    b2Body& body = *bodies[at(led.body)];
    led_.insert(led_place(body), {led.memory, &body, SeenBody(body)});
  }
  std::vector<FixtureIds::Known> known;
  for (const State::Fixture& fixture : state.fixtures) {
    const b2Fixture* const known_fixture = fixtures_of(*bodies[at(fixture.body)])[at(fixture.place)];
    known.push_back({SeenFixture(*known_fixture), fixture.id, fixture.seen});
  }
  fixture_ids_.restore(std::move(known), state.next_fixture);
  touch_events_.clear();
  for (const State::Event& event : state.events) {
    const b2Fixture* const fixture = fixture_ids_.fixture(event.fixture);
    touch_events_.push_back({event.cord, event.begins, fixture, event.impulse, event.point, event.normal,
                             fixture != nullptr ? event.fixture : 0});
  }
  world_ = &world;
}

}  // namespace engine
