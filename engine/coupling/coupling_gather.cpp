// What the cords see of the world before a tick: who holds them, and what they may reach.

#include <algorithm>
#include <cmath>
#include <functional>
#include <variant>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/coupling.h"
#include "ribbon/box2d/coupling_shapes.h"

namespace engine {
namespace {

using ribbon::Box;
using ribbon::RigidBody;
using ribbon::Vec2;

constexpr double direct_reach = 4.0;  // times the way that a cord goes in a tick
constexpr double snap = 2.0;          // times the speed that all of the elastic energy gives all of a cord

/// m, that what goes at such a speed squared [m²/s²], and falls, goes in dt.
double way_of(double speed2, Vec2 gravity, double dt) { return std::sqrt(speed2) * dt + length(gravity) * dt * dt; }

/// What a cord is likely to reach in dt: the box of its points and of where they are driven to, grown by the way that
/// the fastest point goes in that time, and a fall, and by a spacing more for what pushes and pulls add.
Box reach_of(const ribbon::ThesisCord& cord, Vec2 gravity, double dt) {
  Box box{cord.positions()[0], cord.positions()[0]};
  double speed2 = 0.0;
  for (std::size_t p = 0; p < cord.positions().size(); ++p) {
    const Vec2 x = cord.positions()[p];
    box = joined(box, {x, x});
    if (cord.kind(static_cast<int>(p)) != ribbon::PointKind::free) {
      const Vec2 target = cord.target(static_cast<int>(p));
      box = joined(box, {target, target});
    }
    speed2 = std::max(speed2, dot(cord.velocities()[p], cord.velocities()[p]));
  }
  return widened(box, way_of(speed2, gravity, dt) + cord.mesh().spacing);
}

/// The direct solver looks as far itself, and further where that is not enough. Parts of a cord that lets go what it
/// has been stretched by are faster than it is now.
Box reach_of(const ribbon::Cord& cord, Vec2 gravity, double dt) {
  const ribbon::Cord::Sweep sweep = cord.sweep();
  const double snap2 = 2.0 * snap * snap * sweep.elastic / (cord.def().mass_per_length * cord.def().length);
  const double way = direct_reach * way_of(std::max(snap2, sweep.speed2), gravity, dt);
  return widened(sweep.box, way + cord.rest_length(0) + cord.def().radius);
}

RigidBody rigid_body(const b2Body& body, Vec2 gravity) {
  RigidBody rigid;
  rigid.position = to_double(body.GetWorldCenter());
  rigid.velocity = to_double(body.GetLinearVelocity());
  rigid.angular_velocity = static_cast<double>(body.GetAngularVelocity());
  if (body.GetType() != b2_dynamicBody) return rigid;
  const double mass = static_cast<double>(body.GetMass());
  // Box2D tells the inertia about the body's origin; Steiner's term takes it to the centre of mass.
  const Vec2 from_origin = to_double(body.GetLocalCenter());
  const double inertia = static_cast<double>(body.GetInertia()) - mass * dot(from_origin, from_origin);
  rigid.inverse_mass = 1.0 / mass;
  if (!body.IsFixedRotation() && inertia > 0.0) rigid.inverse_inertia = 1.0 / inertia;
  rigid.acceleration = static_cast<double>(body.GetGravityScale()) * gravity;
  rigid.awake = body.IsAwake();
  rigid.may_sleep = body.IsSleepingAllowed() && body.GetWorld()->GetAllowSleeping();
  return rigid;
}

}  // namespace

void Coupling::gather(b2World& world, double dt) {
  if (world.IsLocked()) throw ribbon::DefinitionError("world is locked; accepted is one that is not inside its Step");
  ribbon::check_step(dt, to_double(world.GetGravity()));
  gravity_ = to_double(world.GetGravity());
  dt_ = dt;
  gathered_.clear();
  rigid_.clear();
  body_places_.clear();
  fixture_ids_.begin_tick();
  enter(world);
  look_at_holders();
  look_around(world);
  number_new_fixtures(world);
  for (CoupledCord& coupled : cords_) meet(coupled);
  gather_grips();
  let_run_who_left();
  look_for_the_missing(world);
}

/// Finds what each cord may reach.
void Coupling::look_around(b2World& world) {
  looks_.clear();
  for (CoupledCord& coupled : cords_) {
    coupled.near.clear();
    coupled.reach = {};
    if (!coupled.enabled) continue;
    coupled.reach = std::visit([&](const auto& cord) { return reach_of(cord, gravity_, dt_); }, coupled.cord);
    const bool is_thesis = std::holds_alternative<ribbon::ThesisCord>(coupled.cord);
    looks_.push_back({coupled.reach, coupled.filter, is_thesis, &coupled.near});
  }
  near_finder_.find(world, looks_, gravity_, dt_, parallel_for_);
}

/// In the world's own order: it depends on when they were made, never on where they lie in memory or what is far away.
void Coupling::number_new_fixtures(const b2World& world) {
  new_fixtures_.clear();
  for (CoupledCord& coupled : cords_) {
    for (NearShape& shape : coupled.near) {
      shape.number = fixture_ids_.of(*shape.fixture);
      if (shape.number == 0) new_fixtures_.push_back(shape.fixture);
    }
  }
  if (new_fixtures_.empty()) return;
  // By address, to find them by.
  std::sort(new_fixtures_.begin(), new_fixtures_.end(), std::less<>());
  new_fixtures_.erase(std::unique(new_fixtures_.begin(), new_fixtures_.end()), new_fixtures_.end());
  const auto number_those_of = [this](const b2Body& body) {
    for (const b2Fixture* f = body.GetFixtureList(); f != nullptr; f = f->GetNext()) {
      if (std::binary_search(new_fixtures_.begin(), new_fixtures_.end(), f, std::less<>())) fixture_ids_.add(*f);
    }
  };
  const b2Body* const owner = new_fixtures_.front()->GetBody();
  const auto is_owners = [owner](const b2Fixture* fixture) { return fixture->GetBody() == owner; };
  if (new_fixtures_.size() == 1) {
    fixture_ids_.add(*new_fixtures_.front());
  } else if (std::all_of(new_fixtures_.begin(), new_fixtures_.end(), is_owners)) {
    number_those_of(*owner);
  } else {
    number_by_body(world, number_those_of);
  }
  for (CoupledCord& coupled : cords_) {
    for (NearShape& shape : coupled.near) {
      if (shape.number == 0) shape.number = fixture_ids_.of(*shape.fixture);
    }
  }
}

/// Those of several bodies.
template <typename Number>
void Coupling::number_by_body(const b2World& world, const Number& number_those_of) {
  new_bodies_.clear();
  for (const b2Fixture* fixture : new_fixtures_) new_bodies_.push_back(fixture->GetBody());
  std::sort(new_bodies_.begin(), new_bodies_.end(), std::less<>());
  new_bodies_.erase(std::unique(new_bodies_.begin(), new_bodies_.end()), new_bodies_.end());
  std::size_t left = new_bodies_.size();
  for (const b2Body* body = world.GetBodyList(); body != nullptr && left > 0; body = body->GetNext()) {
    if (!std::binary_search(new_bodies_.begin(), new_bodies_.end(), body, std::less<>())) continue;
    number_those_of(*body);
    --left;
  }
}

/// By the fixtures' numbers.
void Coupling::meet(CoupledCord& coupled) {
  coupled.circles.clear();
  coupled.segments.clear();
  coupled.grips.clear();
  coupled.grip_ids.clear();
  std::vector<NearShape>& near = coupled.near;
  std::sort(near.begin(), near.end(), [](const NearShape& a, const NearShape& b) {
    return a.number != b.number ? a.number < b.number : a.child < b.child;
  });
  const auto is_same = [](const NearShape& a, const NearShape& b) {
    return a.number == b.number && a.child == b.child;
  };
  near.erase(std::unique(near.begin(), near.end(), is_same), near.end());
  const bool is_thesis = std::holds_alternative<ribbon::ThesisCord>(coupled.cord);
  for (auto first = near.begin(); first != near.end();) {
    const auto last = std::find_if(first, near.end(), [&](const NearShape& s) { return s.number != first->number; });
    const int body = body_index(*first->fixture->GetBody());
    if (is_thesis) {
      meet_circle(coupled, *first->fixture, body);
    } else {
      add_shapes({first, last}, body, coupled.reach, coupled.circles, coupled.segments);
    }
    first = last;
  }
}

void Coupling::meet_circle(CoupledCord& coupled, const b2Fixture& fixture, int body) {
  const auto& circle = static_cast<const b2CircleShape&>(*fixture.GetShape());
  const b2Body& owner = *fixture.GetBody();
  const Vec2 center = to_double(owner.GetWorldPoint(circle.m_p));
  const auto radius = static_cast<double>(circle.m_radius);
  const auto speed = static_cast<double>(owner.GetLinearVelocityFromLocalPoint(circle.m_p).Length());
  const double margin = radius + speed * dt_ + length(gravity_) * dt_ * dt_;
  if (!overlap(box_around(center, center, margin), coupled.reach)) return;
  coupled.circles.push_back({body, center - to_double(owner.GetWorldCenter()), radius});
}

int Coupling::body_index(b2Body& body) {
  const int known = body_places_.find(&body);
  if (known >= 0) return known;
  const int place = static_cast<int>(gathered_.size());
  body_places_.set(&body, place);
  gathered_.push_back({&body, -1});
  RigidBody rigid = rigid_body(body, gravity_);
  if (LedBody* before = led(body)) {
    rigid.velocity += ahead(body, *before);
    rigid.acceleration += reaction(body, *before);
    rigid.angular_velocity += ahead_turning(body, *before);
    // What single precision has lost of where it was led to.
    if (length(rigid.position - before->position) <= single_rounding(rigid.position)) rigid.position = before->position;
  }
  rigid_.push_back(rigid);
  return place;
}

}  // namespace engine
