#include "tests/extremes/any_scene/world.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "ribbon/box2d/convert.h"
#include "ribbon/pulley.h"
#include "tests/support/slot.h"

namespace any_scene {

using ribbon::Vec2;
using ribbon::box2d::CordId;
using ribbon::box2d::to_double;
using ribbon::box2d::to_float;

namespace {

constexpr double closed_gap = 1e-3;    // m
constexpr double max_knot = 0.5;       // m, distance of what is tied
constexpr double least_motion = 1e-5;  // m in a tick; free fall from rest is 2.7 mm

using test_support::slot;

b2BodyType type_of(Motion motion) {
  constexpr b2BodyType types[] = {b2_staticBody, b2_dynamicBody, b2_kinematicBody};
  return types[static_cast<std::size_t>(motion)];
}

bool is_pressed(const b2Body& body) {
  for (const b2ContactEdge* edge = body.GetContactList(); edge != nullptr; edge = edge->next) {
    if (edge->contact->IsTouching() && edge->contact->GetManifold()->pointCount > 0) return true;
  }
  return false;
}

/// Returns the place at an arc of a path, or its last corner beyond its end. Sets `arrived` at the end.
Vec2 along(const std::vector<Vec2>& path, Vec2 start, double arc, bool& arrived) {
  arrived = false;
  Vec2 from = start;
  for (const Vec2 corner : path) {
    const double way = length(corner - from);
    if (way > 0.0 && arc <= way) return from + (arc / way) * (corner - from);
    arc -= way;
    from = corner;
  }
  arrived = true;
  return from;
}

}  // namespace

World::World(const Scene& scene) : scene_(scene), world_(to_float(scene.gravity)) {
  world_.SetAllowSleeping(scene.sleeping);
  for (const Solid& solid : scene.solids) add(solid);
  for (const SceneCord& cord : scene.cords) add(cord, scene.preset);
  for (const Wheel& wheel : scene.wheels) add(wheel);
  for (const Hold& hold : scene.holds) add(hold);
  drag_starts_.resize(scene.drags.size());
  pushed_.resize(scene.holds.size());
}

void World::add(const Solid& solid) {
  b2BodyDef def;
  def.type = type_of(solid.motion);
  def.position = to_float(solid.position);
  def.angle = static_cast<float>(solid.angle);
  def.linearVelocity = to_float(solid.velocity);
  def.angularVelocity = static_cast<float>(solid.angular_velocity);
  b2Body* body = world_.CreateBody(&def);
  b2CircleShape circle;
  b2PolygonShape box;
  b2EdgeShape edge;
  circle.m_radius = static_cast<float>(solid.half.x);
  box.SetAsBox(static_cast<float>(solid.half.x), static_cast<float>(solid.half.y));
  edge.SetTwoSided({-circle.m_radius, 0.0F}, {circle.m_radius, 0.0F});
  b2FixtureDef fixture;
  if (solid.shape == Shape::circle) fixture.shape = &circle;
  if (solid.shape == Shape::box) fixture.shape = &box;
  if (solid.shape == Shape::edge) fixture.shape = &edge;
  fixture.density = static_cast<float>(solid.density);
  fixture.friction = static_cast<float>(solid.friction);
  fixture.restitution = static_cast<float>(solid.restitution);
  const b2Fixture* const made = body->CreateFixture(&fixture);
  bodies_.push_back(body);
  if (solid.belt_speed == 0.0) return;
  belts_.speeds.emplace_back(made, solid.belt_speed);
  coupling_.listen(&belts_);
}

bool World::Belts::pre_solve(ribbon::box2d::CordId /*cord*/, const b2Fixture& fixture,
                             ribbon::box2d::Surface& surface) {
  for (const auto& [belt, speed] : speeds) {
    if (belt == &fixture) surface.tangent_speed = speed;
  }
  return true;
}

void World::add(const SceneCord& cord, Preset preset) {
  ribbon::CordDef def = cord.def;
  def.accuracy = accuracy_of(preset);
  if (cord.other_softness) def.accuracy.soft_contacts = !def.accuracy.soft_contacts;
  ribbon::Cord made(def);
  for (int p = 0; p < made.size() && cord.velocity != Vec2{}; ++p) {
    if (made.kind(p) == ribbon::PointKind::free) made.set_velocity(p, cord.velocity);
  }
  coupling_.add(std::move(made));
}

void World::add(const Wheel& wheel) {
  pulleys_.push_back(coupling_.add_pulley(wheel.cord, *bodies_[slot(wheel.solid)], wheel.def));
}

void World::add(const Hold& hold) {
  ribbon::box2d::GripDef def;
  def.cord = hold.cord;
  def.arc = hold.arc;
  def.row = hold.row;
  def.local_anchor = to_float(hold.local_anchor);
  def.strength = hold.strength;
  def.lets_go = hold.lets_go;
  grips_.push_back(coupling_.hold(*bodies_[slot(hold.solid)], def));
  if (hold.climb_to >= 0.0) coupling_.grip(grips_.back()).climb(hold.climb_to, hold.climb_speed);
}

bool World::drive(int number) {
  for (const Reel& reel : scene_.reels) {
    if (reel.from_tick == number && coupling_.cord(reel.cord).is_valid())
      coupling_.cord(reel.cord).direct().reel(reel.first, reel.last, reel.length, reel.speed);
  }
  for (std::size_t k = 0; k < scene_.drags.size(); ++k) {
    const Drag& drag = scene_.drags[k];
    if (number < drag.from_tick || !coupling_.cord(drag.cord).is_valid()) continue;
    if (number == drag.from_tick) drag_starts_[k] = coupling_.cord(drag.cord).positions()[slot(drag.point)];
    bool arrived = false;
    bool was_there = false;
    const double arc = drag.speed * dt * (number - drag.from_tick);
    along(drag.path, drag_starts_[k], arc, was_there);
    const Vec2 target = along(drag.path, drag_starts_[k], arc + drag.speed * dt, arrived);
    if (!was_there) {
      coupling_.cord(drag.cord).drag(drag.point, target);
    } else if (coupling_.cord(drag.cord).kind(drag.point) == ribbon::PointKind::operated) {
      coupling_.cord(drag.cord).free(drag.point);
    }
  }
  bool is_cut = false;
  for (const Cut& wanted : scene_.cuts) is_cut = (wanted.tick == number && cut(wanted)) || is_cut;
  for (const Knot& knot : scene_.knots) is_cut = (knot.tick == number && tie(knot)) || is_cut;
  return is_cut;
}

/// Ties what is no more than half a metre apart. Returns whether it tied or untied something.
bool World::tie(const Knot& knot) {
  std::erase_if(ties_, [this](ribbon::box2d::TieId id) { return !coupling_.tie(id).is_valid(); });
  if (knot.unties) {
    if (ties_.empty()) return false;
    return coupling_.tie(ties_[static_cast<std::size_t>(knot.cord * static_cast<double>(ties_.size()))]).untie();
  }
  const auto cords = coupling_.cords();
  if (cords.size() < 2) return false;
  const CordId id = cords[static_cast<std::size_t>(knot.cord * static_cast<double>(cords.size()))];
  const auto points = coupling_.cord(id).positions();
  const auto point = static_cast<std::size_t>(knot.place * static_cast<double>(points.size()));
  const auto nearest = coupling_.nearest_place(points[point], max_knot, {&id, 1});
  if (!nearest) return false;
  try {
    ties_.push_back(coupling_.tie({id, static_cast<int>(point), nearest->cord, nearest->point}));
  } catch (const ribbon::CallError&) {
    return false;  // they are tied there already
  }
  return true;
}

bool World::draws_together() const {
  return std::any_of(ties_.begin(), ties_.end(), [this](ribbon::box2d::TieId id) {
    return coupling_.tie(id).is_valid() && coupling_.tie(id).state().gap > 0.0;
  });
}

/// Returns whether a cord was cut.
bool World::cut(const Cut& cut) {
  const auto cords = coupling_.cords();
  if (cords.empty()) return false;
  const CordId id = cords[static_cast<std::size_t>(cut.cord * static_cast<double>(cords.size()))];
  ribbon::Cord& cord = coupling_.cord(id).direct();
  const int columns = cord.def().points;
  if (cut.weakens) {
    cord.set_breaking_force(static_cast<int>(cut.place * (columns - 1)), 0.0);
    return false;
  }
  if (cut.along && cord.def().rows > 2) {
    coupling_.cord(id).cut_along(1 + static_cast<int>(cut.place * (cord.def().rows - 2)));
    return true;
  }
  coupling_.cord(id).cut(cut.place * coupling_.cord(id).arc((columns - 1) * cord.def().rows));
  return true;
}

/// Broken cords have new ids, so cords are known by their place in the list.
void World::store_starts() {
  starts_.clear();
  for (const CordId id : coupling_.cords()) {
    const auto points = coupling_.cord(id).positions();
    starts_.emplace_back(points.begin(), points.end());
  }
}

void World::find_moved_share() {
  const auto cords = coupling_.cords();
  std::size_t all = 0;
  std::size_t moved = 0;
  for (std::size_t c = 0; c < std::min(cords.size(), starts_.size()); ++c) {
    const auto points = coupling_.cord(cords[c]).positions();
    for (std::size_t p = 0; p < std::min(points.size(), starts_[c].size()); ++p) {
      ++all;
      if (length(points[p] - starts_[c][p]) > least_motion) ++moved;
    }
  }
  moved_share_ = all > 0 ? static_cast<double>(moved) / static_cast<double>(all) : 0.0;
}

double World::tick() {
  store_starts();
  coupling_.gather(world_, dt);
  const auto begun = std::chrono::steady_clock::now();
  coupling_.step();
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begun;
  coupling_.apply();
  find_moved_share();
  const ribbon::box2d::CouplingState planned = coupling_.save(world_);
  const double before = energy_of_free_bodies(planned);
  world_.Step(static_cast<float>(dt), 8, 3);
  box2d_work_ += energy_of_free_bodies(planned) - before + work_on_moved_bodies(planned);
  update_pushed_bodies();
  return time.count();
}

bool World::has_broken() const {
  const auto events = coupling_.last_step().cut_events();
  return std::any_of(events.begin(), events.end(), [](const auto& event) { return event.broke; });
}

bool World::has_lost_a_cord() const {
  const auto events = coupling_.last_step().cut_events();
  return std::any_of(events.begin(), events.end(),
                     [](const auto& event) { return event.broke && !event.first && !event.second; });
}

Scene World::present_scene() const {
  Scene scene = scene_;
  scene.cords.clear();
  scene.holds.clear();
  scene.wheels.clear();
  const auto cords = coupling_.cords();
  // The ids of the solver are those of the coupling, with the highest bit.
  const auto solver_id = [](CordId id) { return (std::uint64_t{1} << 63U) + static_cast<std::uint64_t>(id); };
  std::vector<ribbon::Cord::State> states;
  for (const CordId id : cords) states.push_back(coupling_.cord(id).direct().save());
  for (std::size_t k = 0; k < cords.size(); ++k) {
    SceneCord cord{coupling_.cord(cords[k]).direct().def(), {}};
    cord.split = states[k].split;
    if (states[k].family != 0) cord.family = static_cast<int>(states[k].family - solver_id(0));
    for (std::size_t other = 0; other < cords.size(); ++other) {
      const bool joined =
          states[k].joined_first == solver_id(cords[other]) && states[other].joined_last == solver_id(cords[k]);
      if (joined) cord.cut_from = static_cast<int>(other);
    }
    scene.cords.push_back(std::move(cord));
  }
  const auto index_of = [&cords](CordId id) {
    return static_cast<int>(std::lower_bound(cords.begin(), cords.end(), id) - cords.begin());
  };
  for (std::size_t k = 0; k < grips_.size(); ++k) {
    if (!coupling_.grip(grips_[k]).is_valid()) continue;
    Hold hold = scene_.holds[k];
    hold.cord = index_of(coupling_.grip(grips_[k]).state().cord);
    scene.holds.push_back(hold);
  }
  for (std::size_t k = 0; k < pulleys_.size(); ++k) {
    if (!coupling_.pulley(pulleys_[k]).is_valid()) continue;
    const ribbon::box2d::PulleyState state = coupling_.pulley(pulleys_[k]).state();
    scene.wheels.push_back({index_of(state.cord), scene_.wheels[k].solid, state.def});
  }
  return scene;
}

Snapshot World::snapshot() const {
  Snapshot now;
  for (const CordId c : coupling_.cords()) {
    const ribbon::Cord& cord = coupling_.cord(c).direct();
    now.cords.push_back(outline(cord.def(), coupling_.cord(c).positions()));
    for (const ribbon::Pulley& pulley : pulleys_of(cord))
      now.cords.back().lay_on_wheel(pulley.def.before, pulley.def.after);
  }
  for (const b2Body* body : bodies_) {
    const b2Rot& turned = body->GetTransform().q;
    now.solids.push_back(
        {to_double(body->GetPosition()), static_cast<double>(turned.c), static_cast<double>(turned.s)});
    now.pressed.push_back(is_pressed(*body) ? 1 : 0);
  }
  for (const ribbon::box2d::TieId id : ties_) {
    if (coupling_.tie(id).is_valid()) now.ties.push_back(coupling_.tie(id).state().place);
  }
  return now;
}

std::vector<World::Reeving> World::reevings() const {
  std::vector<Reeving> all;
  for (std::size_t k = 0; k < pulleys_.size(); ++k) {
    const auto pulley = coupling_.pulley(pulleys_[k]);
    if (pulley.is_valid()) all.push_back({pulley.state(), is_pressed(*bodies_[slot(scene_.wheels[k].solid)])});
  }
  return all;
}

double World::fastest() const {
  double most = 0.0;
  for (const CordId c : coupling_.cords()) {
    for (const Vec2 v : coupling_.cord(c).direct().velocities()) most = std::max(most, length(v));
  }
  return most;
}

bool World::is_finite() const {
  for (const CordId c : coupling_.cords()) {
    for (const Vec2 x : coupling_.cord(c).positions()) {
      if (!ribbon::is_finite(x)) return false;
    }
    for (const Vec2 v : coupling_.cord(c).direct().velocities()) {
      if (!ribbon::is_finite(v)) return false;
    }
  }
  return std::all_of(bodies_.begin(), bodies_.end(), [](const b2Body* body) {
    return body->GetPosition().IsValid() && body->GetLinearVelocity().IsValid() &&
           std::isfinite(body->GetAngularVelocity());
  });
}

/// Returns whether a grip that may slip is at an end of its cord.
bool World::has_slipped_off(CordId id, double arc, const Hold& hold) const {
  if (std::isinf(hold.strength)) return false;
  const ribbon::Cord& cord = coupling_.cord(id).direct();
  double whole = 0.0;
  for (int i = 0; i + 1 < cord.def().points; ++i) whole += cord.rest_length(i);
  return arc <= 1e-6 * whole || arc >= (1.0 - 1e-6) * whole;
}

/// Returns the distance between hand and held place, m; 0 if released.
double World::gap(std::size_t hold) const {
  const auto grip = coupling_.grip(grips_[hold]);
  if (!grip.is_valid() || has_slipped_off(grip.state().cord, grip.state().arc, scene_.holds[hold])) return 0.0;
  const b2Body& body = *bodies_[slot(scene_.holds[hold].solid)];
  const Vec2 hand = to_double(body.GetWorldPoint(to_float(scene_.holds[hold].local_anchor)));
  return length(grip.state().place - hand);
}

void World::update_pushed_bodies() {
  for (std::size_t k = 0; k < grips_.size(); ++k) {
    if (is_pressed(*bodies_[slot(scene_.holds[k].solid)])) {
      pushed_[k] = 1;
    } else if (gap(k) < closed_gap) {
      pushed_[k] = 0;
    }
  }
}

World::Gaps World::grip_gaps() const {
  Gaps widest;
  for (std::size_t k = 0; k < grips_.size(); ++k) {
    double& of_kind = pushed_[k] != 0 ? widest.pressed : widest.free;
    of_kind = std::max(of_kind, gap(k));
  }
  return widest;
}

}  // namespace any_scene
