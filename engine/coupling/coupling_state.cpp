// Saving, checking and restoring the state of a Coupling.

#include "ribbon/box2d/coupling_state.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/coupling.h"
#include "ribbon/box2d/coupling_parts.h"

namespace ribbon::box2d {
namespace {

constexpr double most = std::numeric_limits<double>::max();
constexpr double most_single = 1e30;  // limit of values that become single precision
constexpr double most_ids = 1e9;      // of cords or grips that were ever added
constexpr double most_number = 1e12;  // limit of fixture numbers: ids of their corners must fit into 63 bits

/// Writes the bodies of a world in the order of creation.
void list_bodies(b2World& world, std::vector<b2Body*>& bodies) {
  bodies.resize(static_cast<std::size_t>(world.GetBodyCount()));
  auto at = bodies.rbegin();
  for (b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) *at++ = body;
}

int fixture_count(const b2Body& body) {
  int count = 0;
  for (const b2Fixture* f = body.GetFixtureList(); f != nullptr; f = f->GetNext()) ++count;
  return count;
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
                 carry.expected_delta_v},
                most_single);
  check_range("state.carries.angular_carry", carry.angular_carry, -CarryState::max_carry, CarryState::max_carry);
  check_range("state.carries.angular_velocity", carry.angular_velocity, -most_single, most_single);
  check_range("state.carries.dt", carry.dt, 0.0, 1.0);
}

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

void check_cord(const CouplingState::Cord& from, const CoupledCord& cord, const CouplingState& state) {
  if (from.state.index() != cord.cord.index()) {
    throw DefinitionError("state of cord " + std::to_string(cord.id) + " is of another solver; accepted is " +
                          std::string(solver_name(cord.solver())));
  }
  if (cord.is_direct()) {
    cord.direct().check_state(std::get<Cord::State>(from.state));
  } else {
    cord.thesis().check_state(std::get<ThesisCord::State>(from.state));
  }
  check_range("state.cords.error", from.error, 0.0, most);
  check_touches("state.cords.touching", from.touching, state.next_fixture);
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
      check_range("state.ties.point", place.point, 0, cord.direct().size() - 1.0);
    }
    if (!(tie.breaking_force > 0.0)) refuse("state.ties.breaking_force", tie.breaking_force, "above 0");
  }
  try {
    check_loops(state.ties);
  } catch (const CallError& error) {
    throw DefinitionError(std::string("state.ties: ") + error.what());
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
  check_carries(state, bodies);
  check_events(state);
  check_cuts(state);
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
    if (const CarryState* const found = parts.carry.find(*body)) state.carries.push_back({place, *found});
    save_fixtures(*body, place, parts.fixtures, state);
  }
  std::sort(state.grips.begin(), state.grips.end(),
            [](const auto& a, const auto& b) { return a.memory.id < b.memory.id; });
  std::reverse(state.carries.begin(), state.carries.end());
  std::sort(state.fixtures.begin(), state.fixtures.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
}

void save_events(const CouplingParts& parts, CouplingState& state) {
  for (const TouchEvent& event : parts.touches.events()) {
    const bool is_saved_fixture = std::any_of(state.fixtures.begin(), state.fixtures.end(),
                                              [&event](const auto& saved) { return saved.id == event.number; });
    state.events.push_back(
        {event.cord, event.begins, is_saved_fixture ? event.number : 0, event.impulse, event.point, event.normal});
  }
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
  parts.carry.clear();
  for (const State::Carry& carry : state.carries) parts.carry.restore(body_at(carry.body), carry.memory);
  restore_fixtures(state, bodies, parts.fixtures);
  restore_events(state, parts);
  parts.finder.enter(world);
}

}  // namespace ribbon::box2d
