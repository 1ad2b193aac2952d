// What the cords see of the world before a tick: who holds them, and what they may reach.

#include <algorithm>
#include <cmath>
#include <variant>

#include "engine/convert.h"
#include "engine/coupling.h"
#include "engine/coupling_shapes.h"

namespace engine {
namespace {

using ribbon::Box;
using ribbon::RigidBody;
using ribbon::Vec2;

constexpr double direct_reach = 4.0;  // times the way that a cord goes in a tick
constexpr double snap = 2.0;          // times the speed that all of the elastic energy gives all of a cord

bool is_small(float number) { return std::abs(number) <= 1e9F; }  // false for what is none

/// Whether its numbers are such that a cord can meet it.
bool is_sound(const b2Body& body) {
  return is_small(body.GetPosition().x) && is_small(body.GetPosition().y) && is_small(body.GetAngle()) &&
         is_small(body.GetLinearVelocity().x) && is_small(body.GetLinearVelocity().y) &&
         is_small(body.GetAngularVelocity()) && is_small(body.GetWorldCenter().x) &&
         is_small(body.GetWorldCenter().y) && is_small(body.GetGravityScale());
}

bool is_sound(const b2Fixture& fixture) {
  for (int child = 0; child < fixture.GetShape()->GetChildCount(); ++child) {
    const b2AABB& box = fixture.GetAABB(child);
    for (const float x : {box.lowerBound.x, box.lowerBound.y, box.upperBound.x, box.upperBound.y}) {
      if (!is_small(x)) return false;
    }
  }
  return true;
}

bool has_mass(const b2Body& body) { return body.GetMass() > 0.0F; }

/// Box2D's own rule (b2ContactFilter::ShouldCollide).
bool should_collide(const b2Filter& a, const b2Filter& b) {
  if (a.groupIndex == b.groupIndex && a.groupIndex != 0) return a.groupIndex > 0;
  return (a.maskBits & b.categoryBits) != 0 && (a.categoryBits & b.maskBits) != 0;
}

/// m²/s², of parts of a cord that lets go what it has been stretched by.
double elastic_speed2(const ribbon::ThesisCord& /*cord*/) { return 0.0; }
double elastic_speed2(const ribbon::Cord& cord) {
  if (cord.is_asleep()) return 0.0;
  return 2.0 * snap * snap * cord.energy({}).elastic / (cord.def().mass_per_length * cord.def().length);
}

/// What a cord is likely to reach in dt: the box of its points and of where they are driven to, grown by `times` the
/// way that the fastest point goes in that time, and a fall, and by a margin.
template <typename Cord>
Box reach_of(const Cord& cord, Vec2 gravity, double dt, double times, double margin) {
  Box box{cord.positions()[0], cord.positions()[0]};
  double speed2 = elastic_speed2(cord);
  for (std::size_t p = 0; p < cord.positions().size(); ++p) {
    const Vec2 x = cord.positions()[p];
    box.low = {std::min(box.low.x, x.x), std::min(box.low.y, x.y)};
    box.high = {std::max(box.high.x, x.x), std::max(box.high.y, x.y)};
    if (cord.kind(static_cast<int>(p)) != ribbon::PointKind::free) {
      const Vec2 target = cord.target(static_cast<int>(p));
      box.low = {std::min(box.low.x, target.x), std::min(box.low.y, target.y)};
      box.high = {std::max(box.high.x, target.x), std::max(box.high.y, target.y)};
    }
    speed2 = std::max(speed2, dot(cord.velocities()[p], cord.velocities()[p]));
  }
  const double way = times * (std::sqrt(speed2) * dt + length(gravity) * dt * dt) + margin;
  return {box.low - Vec2{way, way}, box.high + Vec2{way, way}};
}

/// A spacing more for what pushes and pulls add.
Box reach_of(const ribbon::ThesisCord& cord, Vec2 gravity, double dt) {
  return reach_of(cord, gravity, dt, 1.0, cord.mesh().spacing);
}

/// The direct solver looks as far itself, and further where that is not enough.
Box reach_of(const ribbon::Cord& cord, Vec2 gravity, double dt) {
  return reach_of(cord, gravity, dt, direct_reach, cord.rest_length(0) + cord.def().radius);
}

/// The box that a circle sweeps in dt.
Box reach_of(Vec2 center, double radius, double speed, Vec2 gravity, double dt) {
  const double margin = radius + speed * dt + length(gravity) * dt * dt;
  return {center - Vec2{margin, margin}, center + Vec2{margin, margin}};
}

/// m, the furthest that a part of a fixture is from its body's centre of mass, at the most.
float extent(const b2Fixture& fixture) {
  b2AABB box;
  const b2Transform here(b2Vec2_zero, b2Rot(0.0F));
  float most = 0.0F;
  for (int child = 0; child < fixture.GetShape()->GetChildCount(); ++child) {
    fixture.GetShape()->ComputeAABB(&box, here, child);
    const b2Vec2 center = fixture.GetBody()->GetLocalCenter();
    most = std::max({most, (box.lowerBound - center).Length(), (box.upperBound - center).Length()});
  }
  return most;
}

Box box_of(const b2Fixture& fixture, int child) {
  const b2AABB& box = fixture.GetAABB(child);
  return {to_double(box.lowerBound), to_double(box.upperBound)};
}

/// Around all of it.
Box box_of(const b2Fixture& fixture) {
  Box all = box_of(fixture, 0);
  for (int child = 1; child < fixture.GetShape()->GetChildCount(); ++child) all = joined(all, box_of(fixture, child));
  return all;
}

bool is_near(const b2Fixture& fixture, const Box& reach) {
  for (int child = 0; child < fixture.GetShape()->GetChildCount(); ++child) {
    if (overlap(box_of(fixture, child), reach)) return true;
  }
  return false;
}

RigidBody rigid_body(const b2Body& body, b2Vec2 gravity) {
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
  rigid.acceleration = static_cast<double>(body.GetGravityScale()) * to_double(gravity);
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
  for (CoupledCord& coupled : cords_) {
    coupled.circles.clear();
    coupled.segments.clear();
    coupled.grips.clear();
    coupled.reach = {};
    if (!coupled.enabled) continue;
    coupled.reach = std::visit([&](const auto& cord) { return reach_of(cord, gravity_, dt); }, coupled.cord);
  }
  fixture_ids_.begin_tick();
  drop_what_is_gone_from(world);
  drop_disabled_holders();
  // In the world's own order: it depends on when bodies were made, never on where they lie in memory.
  for (b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
    gather_body(*body, world.GetGravity(), dt);
  }
  look_for_the_missing(world);
}

/// Fixtures that were near a cord and are not any more. A body that was carried by one and is asleep wakes, as where a
/// contact of Box2D ends.
void Coupling::look_for_the_missing(b2World& world) {
  if (!fixture_ids_.misses_some()) return;
  for (b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
    for (const b2Fixture* fixture = body->GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext()) {
      const std::uint64_t missed = fixture_ids_.find_missed(*fixture);
      if (missed != 0 && !body->IsAwake() && is_touching(missed)) body->SetAwake(true);
    }
  }
}

bool Coupling::is_touching(std::uint64_t fixture) const {
  return std::any_of(cords_.begin(), cords_.end(), [fixture](const CoupledCord& coupled) {
    return std::any_of(coupled.touching.begin(), coupled.touching.end(),
                       [fixture](const FixtureTouch& touch) { return touch.fixture == fixture; });
  });
}

void Coupling::drop_disabled_holders() {
  const auto is_disabled = [](const Holder& holder) { return !holder.body->IsEnabled(); };
  holders_.erase(std::remove_if(holders_.begin(), holders_.end(), is_disabled), holders_.end());
}

void Coupling::gather_body(b2Body& body, b2Vec2 gravity, double dt) {
  if (!is_sound(body)) {
    drop(body);
    return;
  }
  if (!body.IsEnabled() || (body.GetType() == b2_dynamicBody && !has_mass(body))) return;
  for (const b2Fixture* fixture = body.GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext()) {
    if (!fixture->IsSensor() && is_sound(*fixture)) gather_fixture(body, *fixture, gravity, dt);
  }
  gather_grips(body, gravity);
  if (LedBody* found = led(body); found != nullptr && (gathered_.empty() || gathered_.back().body != &body))
    let_run(body);
}

void Coupling::gather_fixture(b2Body& body, const b2Fixture& fixture, b2Vec2 gravity, double dt) {
  const b2Shape& shape = *fixture.GetShape();
  if (shape.GetChildCount() < 1) return;
  const bool is_circle = fixture.GetType() == b2Shape::e_circle;
  const Vec2 center_of_mass = to_double(body.GetWorldCenter());
  Box swept;
  if (is_circle) {
    const auto& circle = static_cast<const b2CircleShape&>(shape);
    swept = reach_of(to_double(body.GetWorldPoint(circle.m_p)), static_cast<double>(circle.m_radius),
                     static_cast<double>(body.GetLinearVelocityFromLocalPoint(circle.m_p).Length()), gravity_, dt);
  }
  const double speed =
      static_cast<double>(body.GetLinearVelocity().Length() + std::abs(body.GetAngularVelocity()) * extent(fixture));
  const double way = direct_reach * (speed * dt + length(gravity_) * dt * dt);
  const Box all = widened(box_of(fixture), way);
  for (CoupledCord& coupled : cords_) {
    const bool is_thesis = std::holds_alternative<ribbon::ThesisCord>(coupled.cord);
    if (!coupled.enabled || !overlap(is_thesis ? swept : all, coupled.reach)) continue;
    if (!should_collide(fixture.GetFilterData(), coupled.filter)) continue;
    if (is_thesis) {
      if (!is_circle) continue;
      const auto& circle = static_cast<const b2CircleShape&>(shape);
      coupled.circles.push_back({body_index(body, gravity), to_double(body.GetWorldPoint(circle.m_p)) - center_of_mass,
                                 static_cast<double>(circle.m_radius)});
      continue;
    }
    const Box reach{coupled.reach.low - Vec2{way, way}, coupled.reach.high + Vec2{way, way}};
    if (!is_near(fixture, reach)) continue;
    add_shape(fixture, body_index(body, gravity), fixture_ids_.of(fixture), reach, coupled.circles, coupled.segments);
  }
}

int Coupling::body_index(b2Body& body, b2Vec2 gravity) {
  if (gathered_.empty() || gathered_.back().body != &body) {
    gathered_.push_back({&body, -1});
    RigidBody rigid = rigid_body(body, gravity);
    if (LedBody* before = led(body)) {
      rigid.velocity += ahead(body, *before);
      rigid.acceleration += reaction(body, *before);
      rigid.angular_velocity += ahead_turning(body, *before);
      // What single precision has lost of where it was led to.
      if (length(rigid.position - before->position) <= single_rounding(rigid.position))
        rigid.position = before->position;
    }
    rigid_.push_back(rigid);
  }
  return static_cast<int>(gathered_.size()) - 1;
}

}  // namespace engine
