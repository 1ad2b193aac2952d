#include "ribbon/box2d/gatherer.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <variant>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/fixture_shapes.h"
#include "ribbon/cord_sweep.h"

namespace ribbon::box2d {
namespace {

/// What is out of range, or not a number, counts as the nearest value in it, as with fixtures.
double within(double value, double max) { return value > 0.0 ? std::min(value, max) : 0.0; }

constexpr double max_tangent_speed = 1e4;  // m/s

template <typename Shape>
void set_surface(const Surface& surface, std::span<Shape> shapes) {
  const double speed =
      within(surface.tangent_speed, max_tangent_speed) - within(-surface.tangent_speed, max_tangent_speed);
  for (Shape& shape : shapes) {
    shape.friction = within(surface.friction, 10.0);
    shape.restitution = within(surface.restitution, 1.0);
    shape.tangent_speed = speed;
  }
}

constexpr double direct_margin = 4.0;  // multiples of the distance that a cord of the direct solver moves in a tick
constexpr double snap = 2.0;  // multiples of the speed of the whole cord if it had all of its elastic energy as kinetic

/// Returns the distance that something moves in dt that falls and has a speed of √speed2, m.
double distance_in_tick(double speed2, Vec2 gravity, double dt) {
  return std::sqrt(speed2) * dt + length(gravity) * dt * dt;
}

/// Returns a box in which a cord stays in a tick in most cases: it contains the points and their targets, with a margin
/// for the speed of the fastest point, for the fall, and of one spacing for what forces add.
Box swept_aabb(const ThesisCord& cord, const StepConditions& conditions) {
  const auto& [gravity, dt, medium, time] = conditions;
  (void)medium;
  (void)time;
  Box box{cord.positions()[0], cord.positions()[0]};
  double speed2 = 0.0;
  for (std::size_t p = 0; p < cord.positions().size(); ++p) {
    const Vec2 x = cord.positions()[p];
    box = joined(box, {x, x});
    if (cord.kind(static_cast<int>(p)) != PointKind::free) {
      const Vec2 target = cord.target(static_cast<int>(p));
      box = joined(box, {target, target});
    }
    speed2 = std::max(speed2, dot(cord.velocities()[p], cord.velocities()[p]));
  }
  return widened(box, distance_in_tick(speed2, gravity, dt) + cord.mesh().spacing);
}

/// The same for the direct solver, which bounds motions itself. A cord that is stretched may become faster than it is
/// now.
Box swept_aabb(const Cord& cord, const StepConditions& conditions) {
  const auto& [gravity, dt, medium, time] = conditions;
  const CordSweep sweep = sweep_of(cord);
  const double snap2 = 2.0 * snap * snap * sweep.elastic / (cord.def().mass_per_length * cord.def().length);
  const Vec2 fall = cord.def().gravity_scale * gravity;
  double distance = direct_margin * distance_in_tick(std::max(snap2, sweep.speed2), fall, dt);
  if (medium != nullptr) distance += direct_margin * dt * medium_delta_v(cord, *medium, time, dt, gravity);
  return widened(sweep.box, distance + sweep.link + cord.def().radius);
}

/// Adds a circle fixture to a cord of the thesis's solver, if it may reach it.
void add_circle(CoupledCord& cord, const b2Fixture& fixture, int body, const StepConditions& conditions) {
  const auto& circle = static_cast<const b2CircleShape&>(*fixture.GetShape());
  const b2Body& owner = *fixture.GetBody();
  const double dt = conditions.dt;
  const Vec2 center = to_double(owner.GetWorldPoint(circle.m_p));
  const auto radius = static_cast<double>(circle.m_radius);
  const auto speed = static_cast<double>(owner.GetLinearVelocityFromLocalPoint(circle.m_p).Length());
  const double margin = radius + speed * dt + length(conditions.gravity) * dt * dt;
  if (!overlap(box_around(center, center, margin), cord.swept_aabb)) return;
  cord.circles.push_back({body, center - to_double(owner.GetWorldCenter()), radius});
}

/// Sorts fixtures by number and child, and removes duplicates.
void sort(std::vector<NearShape>& near) {
  std::sort(near.begin(), near.end(), [](const NearShape& a, const NearShape& b) {
    return a.number != b.number ? a.number < b.number : a.child < b.child;
  });
  const auto is_same = [](const NearShape& a, const NearShape& b) {
    return a.number == b.number && a.child == b.child;
  };
  near.erase(std::unique(near.begin(), near.end(), is_same), near.end());
}

/// Sorts by address, for lookup only, and removes duplicates.
template <typename T>
void sort_addresses(std::vector<const T*>& addresses) {
  std::sort(addresses.begin(), addresses.end(), std::less<>());
  addresses.erase(std::unique(addresses.begin(), addresses.end()), addresses.end());
}

template <typename T>
bool contains(const std::vector<const T*>& addresses, const T* address) {
  return std::binary_search(addresses.begin(), addresses.end(), address, std::less<>());
}

}  // namespace

void Gatherer::reserve(std::size_t fixtures, std::size_t cords) {
  near_finder_.reserve(fixtures, cords);
  queries_.reserve(cords);
  new_fixtures_.reserve(fixtures);
  new_bodies_.reserve(fixtures);
}

/// A resting cord becomes active if it was changed, if gravity or the length of the tick was, and if a fixture has come
/// near it.
void Gatherer::find_fixtures(b2World& world, const StepConditions& conditions, CordTable& cords, FixtureIds& fixtures,
                             const ParallelFor& parallel_for) {
  const bool same_conditions = conditions.gravity == conditions_.gravity && conditions.dt == conditions_.dt;
  conditions_ = conditions;
  if (!same_conditions) cords.activate_if([](const CoupledCord&) { return true; });
  activate_changed(cords);
  load_resting_queries(cords);
  visit_fetched(cords.active(), CordMemory::surroundings, [&](CoupledCord& cord) {
    cord.near.clear();
    cord.near_sensors.clear();
    cord.clear_surroundings();
    cord.swept_aabb = {};
    if (!cord.enabled) return;
    cord.swept_aabb = std::visit([&](const auto& of_solver) { return swept_aabb(of_solver, conditions); }, cord.cord);
    queries_.push_back({cord.swept_aabb, cord.filter, !cord.is_direct(), false, &cord.near, &cord.near_sensors});
  });
  try {
    near_finder_.find(world, queries_, conditions.gravity, conditions.dt, parallel_for);
  } catch (...) {  // of the user's ParallelFor: what was found is cleared for active cords only
    cords.activate_if([](const CoupledCord&) { return true; });
    throw;
  }
  cords.activate_if([](const CoupledCord& cord) { return !cord.near.empty() || !cord.near_sensors.empty(); });
  number_new_fixtures(world, cords, fixtures);
  for (CoupledCord& cord : cords.active()) {
    if (!cord.near_sensors.empty()) sort(cord.near_sensors);
  }
}

void Gatherer::activate_changed(CordTable& cords) {
  const auto is_changed = [](const CoupledCord& coupled) {
    const Cord& cord = coupled.direct();
    return !cord.is_asleep() || !remembers_sweep(cord) || !(sweep_of(cord).box == coupled.resting_box);
  };
  bool any = false;
  visit_fetched(cords.resting(), CordMemory::surroundings,
                [&](const CoupledCord& cord) { any = any || is_changed(cord); });
  if (any) cords.activate_if(is_changed);
}

bool Gatherer::may_rest(const CoupledCord& cord, const StepConditions& conditions) {
  if (cord.island_report != IslandReport{}) return false;  // it is awake; this report is at hand, the cord may be far
  if (!cord.enabled || !cord.is_direct() || !cord.direct().is_asleep() || meets_cords(cord.direct())) return false;
  if (conditions.medium != nullptr && feels_medium(cord.direct().def())) return false;  // it may change
  if (!cord.near.empty() || !cord.grips.empty() || cord.tied || !cord.touching.empty() || !cord.touching_before.empty())
    return false;
  if (!cord.near_sensors.empty() || !cord.sensing.empty()) return false;
  return swept_aabb(cord.direct(), conditions) == cord.swept_aabb;
}

void Gatherer::load_resting_queries(CordTable& cords) {
  if (resting_version_ != cords.resting_version()) {
    resting_count_ = 0;
    queries_.clear();
    for (CoupledCord& cord : cords.resting()) {
      queries_.push_back({cord.swept_aabb, cord.filter, !cord.is_direct(), true, &cord.near, &cord.near_sensors});
    }
    resting_count_ = queries_.size();
    resting_version_ = cords.resting_version();
  }
  queries_.resize(resting_count_);
}

void Gatherer::number_new_fixtures(const b2World& world, CordTable& cords, FixtureIds& fixtures) {
  new_fixtures_.clear();
  const auto for_each_shape = [&cords](auto&& visit) {
    for (CoupledCord& cord : cords.active()) {
      for (NearShape& shape : cord.near) visit(shape);
      for (NearShape& shape : cord.near_sensors) visit(shape);
    }
  };
  for_each_shape([&](NearShape& shape) {
    shape.number = fixtures.of(*shape.fixture);
    if (shape.number == 0) new_fixtures_.push_back(shape.fixture);
  });
  if (new_fixtures_.empty()) return;
  number_in_order(world, fixtures);
  for_each_shape([&](NearShape& shape) {
    if (shape.number == 0) shape.number = fixtures.of(*shape.fixture);
  });
}

/// Numbers several new fixtures in the order of the world's lists, which depends on when they were created, and neither
/// on addresses nor on what is far away. The bodies of the world are walked through only if several have new fixtures.
void Gatherer::number_in_order(const b2World& world, FixtureIds& fixtures) {
  sort_addresses(new_fixtures_);
  new_bodies_.clear();
  for (const b2Fixture* fixture : new_fixtures_) new_bodies_.push_back(fixture->GetBody());
  sort_addresses(new_bodies_);
  if (new_bodies_.size() == 1) return number_fixtures_of(*new_bodies_.front(), fixtures);
  std::size_t left = new_bodies_.size();
  for (const b2Body* body = world.GetBodyList(); body != nullptr && left > 0; body = body->GetNext()) {
    if (!contains(new_bodies_, body)) continue;
    number_fixtures_of(*body, fixtures);
    --left;
  }
}

void Gatherer::number_fixtures_of(const b2Body& body, FixtureIds& fixtures) const {
  for (const b2Fixture* f = body.GetFixtureList(); f != nullptr; f = f->GetNext()) {
    if (contains(new_fixtures_, f)) fixtures.add(*f);
  }
}

void Gatherer::add_shapes_of(CoupledCord& cord, const StepConditions& conditions,
                             const std::function<int(b2Body&)>& index_of, ContactListener* listener) {
  std::vector<NearShape>& near = cord.near;
  sort(near);
  for (auto first = near.begin(); first != near.end();) {
    const auto last = std::find_if(first, near.end(), [&](const NearShape& s) { return s.number != first->number; });
    const std::span<const NearShape> parts(&*first, static_cast<std::size_t>(last - first));
    const b2Fixture& fixture = *first->fixture;
    first = last;
    Surface surface{static_cast<double>(fixture.GetFriction()), static_cast<double>(fixture.GetRestitution())};
    if (listener != nullptr && !listener->pre_solve(cord.id, fixture, surface)) continue;
    const int body = index_of(*parts.front().fixture->GetBody());
    if (!cord.is_direct()) {
      add_circle(cord, fixture, body, conditions);
      continue;
    }
    const std::size_t circles = cord.circles.size();
    const std::size_t segments = cord.segments.size();
    add_shapes(parts, body, cord.swept_aabb, cord.circles, cord.segments);
    if (listener == nullptr) continue;
    set_surface(surface, std::span(cord.circles).subspan(circles));
    set_surface(surface, std::span(cord.segments).subspan(segments));
  }
}

}  // namespace ribbon::box2d
