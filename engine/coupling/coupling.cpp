#include "ribbon/box2d/coupling.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/cord_cutting.h"
#include "ribbon/box2d/coupling_parts.h"
#include "ribbon/box2d/gather_supports.h"
#include "ribbon/box2d/step_cords.h"
#include "ribbon/cord_sweep.h"

namespace ribbon::box2d {
namespace {

constexpr double max_reserved_cords = 1e6;

void check_unlocked(const b2World& world) {
  if (world.IsLocked()) throw CallError("world is locked; accepted is one that is not inside its Step");
}

void wake(const b2Fixture& fixture) { const_cast<b2Body*>(fixture.GetBody())->SetAwake(true); }

/// Wakes the bodies that touched a cord which was disabled or removed since the last step. They may be near other
/// cords.
void wake_what_touched_cords_that_are_gone(CouplingParts& parts) {
  if (!std::exchange(parts.may_have_left_bodies, false)) return;
  const auto wake_body = [&parts](const FixtureTouch& touch) {
    const FixtureIds::Known* const known = parts.fixtures.known(touch.fixture);
    if (known != nullptr && known->seen) wake(*known->seen_as.fixture);
  };
  for (const CoupledCord& cord : parts.cords.active()) {
    if (cord.enabled) continue;
    for (const FixtureTouch& touch : cord.touching) wake_body(touch);
  }
  for (const EndingTouch& ending : parts.touches.ending()) wake_body(ending.touch);
}

/// Returns a fixture that was near a cord in the last step and has moved away, but still exists; else null.
b2Fixture* find_if_it_left(std::uint64_t number, FixtureIds& fixtures, b2World& world) {
  FixtureIds::Known* const known = fixtures.missed(number);
  if (known == nullptr || known->exists) return nullptr;
  b2Fixture* const fixture = find_fixture(world.GetBodyList(), known->seen_as);
  known->exists = fixture != nullptr;
  return fixture;
}

/// Finds the pushes of bodies that hold nothing. What holds a cord and was pushed off it is drawn back; see GripTable.
void gather_pushes(CouplingParts& parts) {
  for (std::size_t b = 0; b < parts.bodies.entries.size(); ++b) {
    const TickBody& entry = parts.bodies.entries[b];
    if (!entry.holds) parts.carry.find_push(*entry.body, parts.bodies.rigid[b], parts.conditions.dt);
  }
}

/// Wakes sleeping bodies whose contact with a cord is over because the fixture has moved away, as Box2D does where one
/// of its contacts ends. `touch` is a contact of the last step.
void wake_if_it_left(const FixtureTouch& touch, FixtureIds& fixtures, b2World& world) {
  b2Fixture* const fixture = find_if_it_left(touch.fixture, fixtures, world);
  if (fixture != nullptr && !fixture->GetBody()->IsAwake()) fixture->GetBody()->SetAwake(true);
}

/// Finds the fixtures that touched a cord or were overlapped by one in the last step and are no longer near any.
void find_fixtures_that_left(CouplingParts& parts, b2World& world) {
  if (!parts.fixtures.misses_some()) return;
  for (const CoupledCord& cord : parts.cords.active()) {
    for (const FixtureTouch& touch : cord.touching) wake_if_it_left(touch, parts.fixtures, world);
    for (const std::uint64_t sensor : cord.sensing) find_if_it_left(sensor, parts.fixtures, world);
  }
  for (const EndingTouch& ending : parts.touches.ending()) wake_if_it_left(ending.touch, parts.fixtures, world);
  for (const SensorMemory& ending : parts.sensors.ending()) find_if_it_left(ending.fixture, parts.fixtures, world);
}

/// Gives a body the impulse of cords of the thesis's solver. The cord gets what single precision rounds off.
void push(const TickBody& entry, const RigidBody& rigid, CordTable& cords) {
  if (rigid.impulse == Vec2{} && rigid.angular_impulse == 0.0) return;
  b2Body& body = *entry.body;
  const Vec2 before = to_double(body.GetLinearVelocity());
  body.ApplyLinearImpulseToCenter(to_float(rigid.impulse), true);
  body.ApplyAngularImpulse(static_cast<float>(rigid.angular_impulse), true);
  const Vec2 given = (1.0 / rigid.inverse_mass) * (to_double(body.GetLinearVelocity()) - before);
  if (CoupledCord* const cord = cords.find(entry.thesis_cord)) cord->thesis().add_momentum(rigid.impulse - given);
}

/// Releases the grips that slipped off an end of their cord, and those that let go and were pulled with more than their
/// strength.
void release_lost(CouplingParts& parts) {
  for (std::size_t k = 0; k < parts.grips.all().size();) {
    const BodyGrip& grip = parts.grips.all()[k];
    if (grip.slipped_off || (grip.lets_go && length(parts.pull(grip)) > grip.most_pull)) {
      parts.release(grip.id);
    } else {
      ++k;
    }
  }
}

/// Unties the ties that are overloaded, the one with the largest factor first, and one of a cord in a tick.
void break_ties(CouplingParts& parts) {
  auto& overloaded = parts.overloaded_ties;
  overloaded.clear();
  for (const TieMemory& tie : std::as_const(parts.ties).all()) {
    if (!std::isfinite(tie.breaking_force)) continue;
    const double load = length(tie_force(tie, parts.cords, parts.conditions.gravity)) / tie.breaking_force;
    if (load > 1.0) overloaded.emplace_back(-load, tie.id);
  }
  std::sort(overloaded.begin(), overloaded.end());
  std::vector<CordId>& relieved = parts.relieved;
  relieved.clear();
  for (const auto& [load, id] : overloaded) {
    const TieMemory& tie = parts.ties.at(id);
    const auto is_relieved = [&](CordId cord) {
      return std::find(relieved.begin(), relieved.end(), cord) != relieved.end();
    };
    if (is_relieved(tie.place.cord) || is_relieved(tie.other.cord)) continue;
    relieved.push_back(tie.place.cord);
    relieved.push_back(tie.other.cord);
    parts.untie(id);
  }
}

}  // namespace

Coupling::Coupling() : parts_(std::make_unique<CouplingParts>()) {}
Coupling::Coupling(Coupling&& other) noexcept = default;
Coupling& Coupling::operator=(Coupling&& other) noexcept = default;
Coupling::~Coupling() = default;

CordId Coupling::add(Cord cord, const b2Filter& filter) {
  auto coupled = std::make_unique<CoupledCord>(std::move(cord), filter);
  check_without_pulleys(*coupled);
  return parts_->add(std::move(coupled));
}

CordId Coupling::add(ThesisCord cord, const b2Filter& filter) {
  return parts_->add(std::make_unique<CoupledCord>(std::move(cord), filter));
}

void Coupling::reserve(int cords, int points) {
  check_range("cords", cords, 0, max_reserved_cords);
  check_range("points", points, 2, 1e6);
  parts_->reserve(static_cast<std::size_t>(cords), points);
}

void Coupling::remove(CordId cord) { parts_->remove(cord); }

std::span<const CutEvent> Coupling::cut(Vec2 from, Vec2 to) {
  check_coordinates("from", from);
  check_coordinates("to", to);
  check_between_ticks(*parts_, "cut");
  const std::size_t before = parts_->cuts.events().size();
  cut_along(*parts_, from, to);
  return parts_->cuts.events().subspan(before);
}

std::span<const CordId> Coupling::cords() const { return parts_->cords.ids(); }

GripId Coupling::hold(b2Body& body, const GripDef& def) {
  CoupledCord& cord = parts_->cords.enabled(def.cord);
  check_unlocked(*body.GetWorld());
  const BodyGrip grip = parts_->grips.make(body, def, cord);
  parts_->enter(*body.GetWorld());
  parts_->forget_predecessor(body);
  parts_->cords.activate(cord);
  return parts_->grips.add(grip);
}

GripId Coupling::hold(CordId cord, int point, b2Body& body, b2Vec2 local_anchor) {
  GripDef def;
  def.cord = cord;
  def.point = point;
  def.local_anchor = local_anchor;
  return hold(body, def);
}

TieId Coupling::tie(const TieDef& def) {
  (void)parts_->cords.enabled(def.cord);
  (void)parts_->cords.enabled(def.other_cord);
  check_between_ticks(*parts_, "tie");
  const TieId id = parts_->ties.add(def, parts_->cords);
  for (const CordId cord : {def.cord, def.other_cord}) parts_->cords.at(cord).direct().wake();
  return id;
}

PulleyId Coupling::add_pulley(CordId cord, b2Body& body, const PulleyDef& def) {
  CoupledCord& coupled = parts_->cords.enabled(cord);
  (void)coupled.direct();  // refuses the other solver
  check_unlocked(*body.GetWorld());
  check_between_ticks(*parts_, "add_pulley");
  check_nothing_held(*parts_, coupled, def);
  parts_->cords.activate(coupled);
  const PulleyId id = parts_->pulleys.add(coupled, body, def);
  parts_->enter(*body.GetWorld());
  parts_->forget_predecessor(body);
  return id;
}

void Coupling::tick(b2World& world, double dt, int velocity_iterations, int position_iterations) {
  gather(world, dt);
  step();
  apply();
  world.Step(static_cast<float>(dt), velocity_iterations, position_iterations);
}

void Coupling::gather(b2World& world, double dt) {
  CouplingParts& parts = *parts_;
  check_unlocked(world);
  if (parts.phase == TickPhase::stepped) throw CallError("gather follows step; accepted is gather, step, apply");
  check_step(dt, to_double(world.GetGravity()));
  const bool repeats = std::exchange(parts.phase, TickPhase::between_ticks) == TickPhase::gathered;
  parts.conditions = {to_double(world.GetGravity()), dt, parts.medium, parts.medium_time};
  parts.bodies.clear();
  repeats ? parts.fixtures.repeat_tick() : parts.fixtures.begin_tick();
  parts.enter(world);
  if (!parts.finder.trusts_forget()) parts.grips.forget_gone(parts.finder);
  parts.grips.drop_unable();
  parts.pulleys.drop_unable(parts.finder, parts.finder.trusts_forget(), parts.cords);
  parts.gatherer.find_fixtures(world, parts.conditions, parts.cords, parts.fixtures, parts.parallel_for);
  wake_what_touched_cords_that_are_gone(parts);
  const auto index_of = [&parts](b2Body& body) { return parts.bodies.index_of(body, parts.carry, parts.conditions); };
  for (CoupledCord& cord : parts.cords.active()) {
    Gatherer::add_shapes_of(cord, parts.conditions, index_of, parts.listener);
  }
  const auto index_of_holder = [&](b2Body& body) {
    const int index = index_of(body);
    parts.bodies.entries[static_cast<std::size_t>(index)].holds = true;
    return index;
  };
  parts.grips.gather(parts.cords, dt, index_of_holder);
  parts.pulleys.gather(parts.cords, index_of_holder);
  gather_supports(parts);
  gather_pushes(parts);
  parts.ties.gather(parts.cords);
  const auto is_gathered = [&parts](const SeenBody& seen) {
    const b2Body* const body = parts.bodies.find(seen.body);
    return body != nullptr && seen.is(*body);
  };
  parts.carry.release_unless(is_gathered, parts.finder);
  find_fixtures_that_left(parts, world);
  parts.phase = TickPhase::gathered;
}

void Coupling::step() {
  CouplingParts& parts = *parts_;
  if (parts.phase != TickPhase::gathered) {
    throw CallError("step does not follow gather; accepted is gather, step, apply");
  }
  parts.phase = TickPhase::between_ticks;  // also if something throws
  parts.cuts.begin_step();
  parts.carry.begin_step();
  Gatherer::activate_changed(parts.cords);
  parts.sensors.find_events(parts.cords, parts.fixtures, parts.listener);
  step_thesis(parts);
  const bool any_asleep = step_direct(parts);
  parts.grips.follow(parts.cords, parts.conditions.gravity);
  parts.touches.find_events(parts.cords, parts.fixtures);
  parts.islands = parts.solver.islands() + static_cast<int>(parts.cords.resting().size());
  // What watches steps sees those of all cords.
  if (any_asleep && !parts.probe && parts.watcher == nullptr) {
    parts.cords.rest_if([&](CoupledCord& cord) {
      if (!Gatherer::may_rest(cord, parts.conditions)) return false;
      cord.resting_box = sweep_of(cord.direct()).box;
      return true;
    });
  }
  parts.phase = TickPhase::stepped;
}

void Coupling::apply() {
  CouplingParts& parts = *parts_;
  if (parts.phase != TickPhase::stepped) {
    throw CallError("apply does not follow step; accepted is gather, step, apply");
  }
  for (std::size_t b = 0; b < parts.bodies.entries.size(); ++b) {
    const TickBody& entry = parts.bodies.entries[b];
    const RigidBody& rigid = parts.bodies.rigid[b];
    if (entry.body == nullptr || rigid.inverse_mass == 0.0) continue;
    if (rigid.rests) {
      parts.carry.put_to_sleep(*entry.body, parts.conditions.dt);
    } else if (rigid.solved || (entry.holds && parts.grips.first_of(*entry.body) != nullptr)) {
      parts.carry.drive(*entry.body, rigid, entry.max_push, parts.conditions);
    } else {
      parts.carry.release(*entry.body);
      if (entry.thesis_cord >= 0) push(entry, rigid, parts.cords);
    }
  }
  release_lost(parts);
  break_ties(parts);
  break_overloaded(parts);
  parts.cuts.end_tick();
  if (parts.conditions.medium != nullptr) parts.medium_time += parts.conditions.dt;
  parts.phase = TickPhase::between_ticks;
}

void Coupling::use(const ParallelFor& parallel_for) {
  check(parallel_for);
  parts_->parallel_for = parallel_for;
  parts_->solver.use(parallel_for);
}

void Coupling::estimate_errors(bool wanted) {
  if (wanted == parts_->probe.has_value()) return;
  parts_->probe.reset();
  if (wanted) parts_->probe.emplace();
  parts_->cords.activate_if([](const CoupledCord&) { return true; });
  for (CoupledCord& cord : parts_->cords) cord.error = 0.0;
}

void Coupling::watch(StepWatcher* watcher) {
  parts_->watcher = watcher;
  parts_->cords.activate_if([](const CoupledCord&) { return true; });
}

void Coupling::set_medium(const Medium* medium) {
  parts_->medium = medium;
  parts_->cords.activate_if([](const CoupledCord&) { return true; });
}

void Coupling::listen(ContactListener* listener) { parts_->listener = listener; }
const b2Fixture* Coupling::fixture(std::uint64_t number) const { return parts_->fixtures.fixture(number); }

const b2Fixture* Coupling::fixture(std::uint64_t number, const b2World& world) const {
  const FixtureIds::Known* const known = parts_->fixtures.known(number);
  if (known == nullptr || !known->exists) return nullptr;
  return find_fixture(const_cast<b2Body*>(world.GetBodyList()), known->seen_as);
}

void Coupling::forget(const b2Body& body) {
  parts_->grips.forget(body);
  parts_->pulleys.forget(body, parts_->cords);
  parts_->carry.forget(body);
  parts_->bodies.forget(body);
  for (const b2Fixture* f = body.GetFixtureList(); f != nullptr; f = f->GetNext()) forget(*f);
}

void Coupling::forget(const b2Fixture& fixture) {
  parts_->fixtures.forget(fixture);
  parts_->touches.forget(fixture);
  parts_->sensors.forget(fixture);
  if (parts_->phase != TickPhase::gathered) return;
  for (CoupledCord& cord : parts_->cords.active()) {
    std::erase_if(cord.near_sensors, [&fixture](const NearShape& near) { return near.fixture == &fixture; });
  }
}

void Coupling::destroy(b2World& world, b2Body& body) {
  forget(body);
  world.DestroyBody(&body);
}

void Coupling::trust_forget(bool trusted) { parts_->finder.trust_forget(trusted); }

}  // namespace ribbon::box2d
