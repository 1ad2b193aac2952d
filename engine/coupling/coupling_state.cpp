// Saving and restoring the state of a Coupling.

#include "ribbon/box2d/coupling_state.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/coupling.h"
#include "ribbon/box2d/coupling_parts.h"
#include "ribbon/box2d/coupling_state_check.h"

namespace ribbon::box2d {
namespace {

/// Writes the bodies of a world in the order of creation.
void list_bodies(b2World& world, std::vector<b2Body*>& bodies) {
  bodies.resize(static_cast<std::size_t>(world.GetBodyCount()));
  auto at = bodies.rbegin();
  for (b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) *at++ = body;
}

/// Returns the fixture of a body with a place, 0 … fixture_count − 1, in the order of creation.
const b2Fixture& fixture_at(const b2Body& body, int place) {
  const b2Fixture* fixture = body.GetFixtureList();
  for (int behind = fixture_count(body) - 1 - place; behind > 0; --behind) fixture = fixture->GetNext();
  return *fixture;
}

/// The bodies that a coupling knows, with a few others: most bodies of a large world are skipped by one look.
class LikelyBodies {
 public:
  explicit LikelyBodies(const CouplingParts& parts) {
    for (const BodyGrip& grip : parts.grips.all()) add(grip.seen.body);
    for (const BodyPulley& pulley : parts.pulleys.all()) add(pulley.seen.body);
    parts.carry.visit_addresses([this](const b2Body* body) { add(body); });
    for (const FixtureIds::Known& known : parts.fixtures.all()) add(known.seen_as.owner.body);
  }
  bool contain(const b2Body& body) const { return ((words_[word(&body)] >> bit(&body)) & 1U) != 0; }

 private:
  static std::uint64_t mixed(const b2Body* body) {
    return static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(body)) * 0x9e3779b97f4a7c15U;
  }
  static std::size_t word(const b2Body* body) { return static_cast<std::size_t>(mixed(body) >> 58U); }
  static std::uint64_t bit(const b2Body* body) { return (mixed(body) >> 52U) & 63U; }
  void add(const b2Body* body) { words_[word(body)] |= std::uint64_t{1} << bit(body); }

  std::array<std::uint64_t, 64> words_{};
};

/// Returns whether a saved cord is the one that the coupling has with its id.
bool is_same(const CouplingState::Cord& saved, const CoupledCord& cord) {
  if (saved.origin.def == nullptr || saved.origin.def == cord.def) return true;
  return cord.is_direct() && saved.origin == cord.origin();
}

/// Returns the saved cords that the coupling does not have, as they were added. Throws DefinitionError for one that
/// cannot be added.
std::vector<CoupledCord> missing_cords(const CouplingState& state, const CordTable& cords) {
  std::vector<CoupledCord> missing;
  for (const CouplingState::Cord& saved : state.cords) {
    const CoupledCord* const cord = cords.find(saved.id);
    if (cord != nullptr && is_same(saved, *cord)) continue;
    if (saved.id >= state.next_cord) continue;  // refused later
    if (saved.origin.def == nullptr || !std::holds_alternative<Cord::State>(saved.state)) {
      throw DefinitionError(
          "state has cord " + std::to_string(saved.id) +
          ", which the coupling does not have; accepted is a state of the same cords or with their definitions");
    }
    CoupledCord added(Cord(*saved.origin.def), saved.origin.filter);
    added.id = saved.id;
    added.def = saved.origin.def;
    added.user_data = saved.origin.user_data;
    missing.push_back(std::move(added));
  }
  return missing;
}

void save_cord(const CoupledCord& coupled, CouplingState::Cord& saved) {
  saved.id = coupled.id;
  std::visit(
      [&saved](const auto& of_solver) {
        using State = typename std::decay_t<decltype(of_solver)>::State;
        if (!std::holds_alternative<State>(saved.state)) saved.state.emplace<State>();
        of_solver.save(std::get<State>(saved.state));
      },
      coupled.cord);
  saved.enabled = coupled.enabled;
  saved.island_report = coupled.island_report;
  saved.island_total = coupled.island_total;
  saved.error = coupled.error;
  saved.thesis_report = coupled.thesis_report;
  saved.thesis_total = coupled.thesis_total;
  saved.touching = coupled.touching;
  saved.sensing = coupled.sensing;
  if (saved.origin.def != coupled.def) saved.origin.def = coupled.def;  // counts references only if it must
  saved.origin.filter = coupled.filter;
  saved.origin.user_data = coupled.user_data;
}

void restore_cord(const CouplingState::Cord& from, CoupledCord& to) {
  if (to.is_direct()) {
    to.direct().restore(std::get<Cord::State>(from.state));
  } else {
    to.thesis().restore(std::get<ThesisCord::State>(from.state));
  }
  to.enabled = from.enabled;
  to.report = {};
  to.island_report = from.island_report;
  to.island_total = from.island_total;
  to.error = from.error;
  to.thesis_report = from.thesis_report;
  to.thesis_total = from.thesis_total;
  to.touching = from.touching;
  to.sensing = from.sensing;
  to.clear_surroundings();
}

/// Adds the missing cords and removes those that the state does not have.
void exchange_cords(const CouplingState& state, std::vector<CoupledCord> missing, CordTable& cords) {
  for (CoupledCord& cord : missing) cords.put(std::move(cord));
  std::vector<CordId> extra;
  auto saved = state.cords.begin();
  for (const CordId id : cords.ids()) {
    if (saved != state.cords.end() && saved->id == id) {
      ++saved;
    } else {
      extra.push_back(id);
    }
  }
  for (const CordId id : extra) cords.remove(id);
}

/// Saves the numbers of the fixtures of a body that have one.
void save_fixtures(const b2Body& body, int body_place, const FixtureIds& fixtures, CouplingState& state) {
  int place = fixture_count(body);
  for (const b2Fixture* fixture = body.GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext()) {
    --place;
    const auto* known = fixtures.find(*fixture);
    if (known != nullptr) state.fixtures.push_back({body_place, place, known->id, known->seen});
  }
}

/// Saves what refers to bodies: grips, carries and fixture numbers. Bodies are named by their place in the order of
/// creation, so the newest comes first here.
void save_by_body(const CouplingParts& parts, const b2World& world, CouplingState& state) {
  const LikelyBodies likely(parts);
  int place = state.bodies;
  for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
    --place;
    if (!likely.contain(*body)) continue;
    for (const BodyGrip& grip : parts.grips.all()) {
      if (grip.seen.is(*body)) state.grips.push_back({place, grip});
    }
    for (const BodyPulley& pulley : parts.pulleys.all()) {
      if (pulley.seen.is(*body)) state.pulleys.push_back({place, pulley});
    }
    if (const CarryState* const found = parts.carry.find(*body)) state.carries.push_back({place, *found});
    save_fixtures(*body, place, parts.fixtures, state);
  }
  std::sort(state.grips.begin(), state.grips.end(),
            [](const auto& a, const auto& b) { return a.memory.id < b.memory.id; });
  std::sort(state.pulleys.begin(), state.pulleys.end(),
            [](const auto& a, const auto& b) { return a.memory.id < b.memory.id; });
  std::reverse(state.carries.begin(), state.carries.end());
  std::sort(state.fixtures.begin(), state.fixtures.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
}

void save_events(const CouplingParts& parts, CouplingState& state) {
  const auto saved_number = [&state](std::uint64_t number) {
    const bool is_saved = std::any_of(state.fixtures.begin(), state.fixtures.end(),
                                      [number](const auto& saved) { return saved.id == number; });
    return is_saved ? number : 0;
  };
  for (const TouchEvent& event : parts.touches.events()) {
    state.events.push_back(
        {event.cord, event.begins, saved_number(event.number), event.impulse, event.point, event.normal});
  }
  state.sensor_events.clear();
  for (const SensorEvent& event : parts.sensors.events()) {
    state.sensor_events.push_back({event.cord, event.begins, saved_number(event.number)});
  }
  const auto ending_sensors = parts.sensors.ending();
  state.ending_sensors.assign(ending_sensors.begin(), ending_sensors.end());
  const auto ending = parts.touches.ending();
  state.ending.assign(ending.begin(), ending.end());
  const auto cuts = parts.cuts.events();
  state.cuts.assign(cuts.begin(), cuts.end());
  state.old_cuts = parts.cuts.old();
}

void restore_fixtures(const CouplingState& state, const std::vector<b2Body*>& bodies, FixtureIds& fixtures) {
  fixtures.clear(state.next_fixture);
  for (const CouplingState::Fixture& fixture : state.fixtures) {
    const b2Body& body = *bodies[static_cast<std::size_t>(fixture.body)];
    fixtures.restore({SeenFixture(fixture_at(body, fixture.place)), fixture.id, fixture.seen});
  }
}

void restore_events(const CouplingState& state, CouplingParts& parts) {
  parts.touches.restore(state.ending);
  for (const CouplingState::Event& event : state.events) {
    const b2Fixture* const fixture = parts.fixtures.fixture(event.fixture);
    parts.touches.restore({event.cord, event.begins, fixture, event.impulse, event.point, event.normal,
                           fixture != nullptr ? event.fixture : 0});
  }
  parts.sensors.restore(state.ending_sensors);
  for (const SensorMemory& event : state.sensor_events) {
    const b2Fixture* const fixture = parts.fixtures.fixture(event.fixture);
    parts.sensors.restore({event.cord, event.begins, fixture, fixture != nullptr ? event.fixture : 0});
  }
  parts.cuts.restore(state.cuts, state.old_cuts);
}

}  // namespace

bool CordOrigin::operator==(const CordOrigin& other) const {
  const bool same_filter = filter.categoryBits == other.filter.categoryBits &&
                           filter.maskBits == other.filter.maskBits && filter.groupIndex == other.filter.groupIndex;
  if (!same_filter || (def == nullptr) != (other.def == nullptr)) return false;
  return def == other.def || *def == *other.def;
}

CouplingState Coupling::save(const b2World& world) const {
  State state;
  save(world, state);
  return state;
}

void Coupling::save(const b2World& world, State& state) const {
  state.bodies = world.GetBodyCount();
  state.next_cord = parts_->cords.next();
  state.next_grip = parts_->grips.next();
  state.next_fixture = parts_->fixtures.next();
  state.cords.resize(static_cast<std::size_t>(parts_->cords.size()));
  auto saved = state.cords.begin();
  for (const CoupledCord& cord : std::as_const(parts_->cords)) save_cord(cord, *saved++);
  state.grips.clear();
  state.carries.clear();
  state.fixtures.clear();
  state.events.clear();
  const auto ties = std::as_const(parts_->ties).all();
  state.ties.assign(ties.begin(), ties.end());
  state.next_tie = parts_->ties.next();
  state.pulleys.clear();
  state.next_pulley = parts_->pulleys.next();
  state.medium_time = parts_->medium_time;
  save_by_body(*parts_, world, state);
  save_events(*parts_, state);
}

void Coupling::restore(const State& state, b2World& world) {
  if (world.IsLocked()) throw CallError("world is locked; accepted is one that is not inside its Step");
  CouplingParts& parts = *parts_;
  const std::vector<b2Body*>& bodies = parts.restore_memory.bodies;
  list_bodies(world, parts.restore_memory.bodies);
  std::vector<CoupledCord> missing = missing_cords(state, parts.cords);
  check_state(state, parts.restore_memory, parts.cords, missing);
  const auto body_at = [&bodies](int place) -> b2Body& { return *bodies[static_cast<std::size_t>(place)]; };

  parts.cords.activate_if([](const CoupledCord&) { return true; });
  exchange_cords(state, std::move(missing), parts.cords);
  auto saved = state.cords.begin();
  for (CoupledCord& cord : parts.cords) restore_cord(*saved++, cord);
  parts.cords.continue_from(state.next_cord);
  parts.phase = TickPhase::between_ticks;
  parts.may_have_left_bodies = true;
  parts.bodies.clear();
  parts.grips.clear(state.next_grip);
  for (const State::Grip& grip : state.grips) parts.grips.restore(grip.memory, body_at(grip.body));
  parts.ties.restore(state.ties, state.next_tie);
  parts.pulleys.clear(state.next_pulley);
  for (const State::Pulley& pulley : state.pulleys) parts.pulleys.restore(pulley.memory, body_at(pulley.body));
  parts.medium_time = state.medium_time;
  parts.carry.clear();
  for (const State::Carry& carry : state.carries) parts.carry.restore(body_at(carry.body), carry.memory);
  restore_fixtures(state, bodies, parts.fixtures);
  restore_events(state, parts);
  parts.finder.enter(world);
}

}  // namespace ribbon::box2d
