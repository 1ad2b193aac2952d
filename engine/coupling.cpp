#include "engine/coupling.h"

#include <algorithm>
#include <string>
#include <utility>

#include "engine/convert.h"

namespace engine {
namespace {

using ribbon::Box;
using ribbon::RigidBody;
using ribbon::Vec2;

// Room that every cord has from the start, so that the first circle to come near takes no memory.
constexpr std::size_t usual_bodies = 64;
constexpr std::size_t usual_grips = 8;

bool has_mass(const b2Body& body) { return body.GetMass() > 0.0F; }

/// Box2D's own rule (b2ContactFilter::ShouldCollide).
bool should_collide(const b2Filter& a, const b2Filter& b) {
  if (a.groupIndex == b.groupIndex && a.groupIndex != 0) return a.groupIndex > 0;
  return (a.maskBits & b.categoryBits) != 0 && (a.categoryBits & b.maskBits) != 0;
}

/// What a cord is likely to reach in dt: the box of its points and of where they are driven to, grown by the way the
/// fastest point and a fall go in that time, and by a spacing for what pushes and pulls add.
Box reach_of(const ribbon::ThesisCord& cord, Vec2 gravity, double dt) {
  Box box{cord.positions()[0], cord.positions()[0]};
  double speed2 = 0.0;
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
  const double margin = std::sqrt(speed2) * dt + length(gravity) * dt * dt + cord.mesh().spacing;
  return {box.low - Vec2{margin, margin}, box.high + Vec2{margin, margin}};
}

/// The box that a circle sweeps in dt.
Box reach_of(Vec2 center, double radius, double speed, Vec2 gravity, double dt) {
  const double margin = radius + speed * dt + length(gravity) * dt * dt;
  return {center - Vec2{margin, margin}, center + Vec2{margin, margin}};
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
  return rigid;
}

}  // namespace

CordIndex Coupling::add(ribbon::ThesisCord cord, const b2Filter& filter) {
  cord.reserve(usual_bodies, usual_bodies, usual_grips);
  return add(CoupledCord{std::move(cord), filter, {}, {}, {}, {}, {}, {}});
}

CordIndex Coupling::add(ribbon::Cord cord) {
  cord.reserve(usual_grips);
  b2Filter none;
  none.maskBits = 0;
  return add(CoupledCord{std::move(cord), none, {}, {}, {}, {}, {}, {}});
}

CordIndex Coupling::add(CoupledCord coupled) {
  cords_.push_back(std::move(coupled));
  cords_.back().circles.reserve(usual_bodies);
  cords_.back().grips.reserve(usual_grips);
  gathered_.reserve(usual_bodies);
  rigid_.reserve(usual_bodies);
  return size() - 1;
}

void Coupling::gather(b2World& world, double dt) {
  gravity_ = to_double(world.GetGravity());
  dt_ = dt;
  gathered_.clear();
  rigid_.clear();
  for (CoupledCord& coupled : cords_) {
    if (const auto* thesis = std::get_if<ribbon::ThesisCord>(&coupled.cord)) {
      coupled.reach = reach_of(*thesis, gravity_, dt);
    }
    coupled.circles.clear();
    coupled.grips.clear();
  }
  drop_holders_gone_from(world);
  // In the world's own order: it depends on when bodies were made, never on where they lie in memory.
  for (b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
    gather_body(*body, world.GetGravity(), dt);
  }
}

void Coupling::drop_holders_gone_from(const b2World& world) {
  const auto is_gone = [&world](const Holder& holder) {
    for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
      if (body == holder.body) return !body->IsEnabled();
    }
    return true;
  };
  holders_.erase(std::remove_if(holders_.begin(), holders_.end(), is_gone), holders_.end());
}

void Coupling::gather_body(b2Body& body, b2Vec2 gravity, double dt) {
  if (!body.IsEnabled() || (body.GetType() == b2_dynamicBody && !has_mass(body))) return;
  const Vec2 center_of_mass = to_double(body.GetWorldCenter());
  for (const b2Fixture* fixture = body.GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext()) {
    if (fixture->IsSensor() || fixture->GetType() != b2Shape::e_circle) continue;
    const auto& circle = static_cast<const b2CircleShape&>(*fixture->GetShape());
    const Vec2 center = to_double(body.GetWorldPoint(circle.m_p));
    const double radius = static_cast<double>(circle.m_radius);
    const double speed = static_cast<double>(body.GetLinearVelocityFromLocalPoint(circle.m_p).Length());
    const Box swept = reach_of(center, radius, speed, gravity_, dt);
    for (CoupledCord& coupled : cords_) {
      if (!std::holds_alternative<ribbon::ThesisCord>(coupled.cord)) continue;
      if (!should_collide(fixture->GetFilterData(), coupled.filter)) continue;
      if (!overlap(swept, coupled.reach)) continue;
      coupled.circles.push_back({body_index(body, gravity), center - center_of_mass, radius});
    }
  }
  if (Holder* held = holder(body)) {
    const Vec2 hand = to_double(body.GetWorldPoint(held->local_hand));
    const Vec2 travel = to_double(body.GetWorldVector(held->next_hand - held->local_hand));
    cords_[at(held->cord)].grips.push_back({held->point, body_index(body, gravity), hand - center_of_mass, travel});
    held->local_hand = held->next_hand;
  }
}

int Coupling::body_index(b2Body& body, b2Vec2 gravity) {
  if (gathered_.empty() || gathered_.back().body != &body) {
    gathered_.push_back({&body, -1});
    rigid_.push_back(rigid_body(body, gravity));
    if (const Holder* held = holder(body)) {
      rigid_.back().velocity += held->ahead;
      rigid_.back().angular_velocity += held->ahead_turning;
    }
  }
  return static_cast<int>(gathered_.size()) - 1;
}

void Coupling::step() {
  for (CordIndex c = 0; c < size(); ++c) {
    CoupledCord& coupled = cords_[at(c)];
    if (auto* direct = std::get_if<ribbon::Cord>(&coupled.cord)) {
      coupled.direct_report = direct->step(dt_, gravity_, {rigid_, {}, coupled.grips});
      coupled.direct_total += coupled.direct_report;
    } else {
      coupled.report =
          std::get<ribbon::ThesisCord>(coupled.cord).step(dt_, gravity_, {rigid_, coupled.circles, coupled.grips});
      coupled.total += coupled.report;
    }
    for (const ribbon::RigidCircle& circle : coupled.circles) gathered_[at(circle.body)].met = c;
    for (const ribbon::Grip& grip : coupled.grips) gathered_[at(grip.body)].met = c;
  }
}

void Coupling::apply() {
  for (std::size_t b = 0; b < gathered_.size(); ++b) {
    b2Body& body = *gathered_[b].body;
    if (rigid_[b].inverse_mass == 0.0) continue;
    if (Holder* held = holder(body)) {
      lead(*held, rigid_[b], dt_);
    } else {
      push(gathered_[b], rigid_[b]);
    }
  }
}

/// Gives a touching body its impulse; what single precision loses of it stays with the cord.
void Coupling::push(const GatheredBody& gathered, const RigidBody& rigid) {
  if (rigid.impulse == Vec2{} && rigid.angular_impulse == 0.0) return;
  b2Body& body = *gathered.body;
  const Vec2 before = to_double(body.GetLinearVelocity());
  body.ApplyLinearImpulseToCenter(to_float(rigid.impulse), true);
  body.ApplyAngularImpulse(static_cast<float>(rigid.angular_impulse), true);
  const Vec2 given = (1.0 / rigid.inverse_mass) * (to_double(body.GetLinearVelocity()) - before);
  std::get<ribbon::ThesisCord>(cords_[at(gathered.met)].cord).add_momentum(rigid.impulse - given);
}

/// Makes world.Step take a holder to where the cord saw it go. With v⁺ its velocity at the end of the tick, Box2D gets
/// m·(Δx/dt − a·dt − v), and v⁺ − Δx/dt is carried on.
void Coupling::lead(Holder& holder, const RigidBody& rigid, double dt) {
  b2Body& body = *holder.body;
  const Vec2 fall = dt * rigid.acceleration;  // which world.Step adds
  const Vec2 wanted = (1.0 / dt) * rigid.moved - fall;
  body.ApplyLinearImpulseToCenter(to_float((1.0 / rigid.inverse_mass) * (wanted - to_double(body.GetLinearVelocity()))),
                                  true);
  const Vec2 end = rigid.velocity + fall + rigid.inverse_mass * rigid.impulse;
  holder.ahead = end - (to_double(body.GetLinearVelocity()) + fall);
  if (rigid.inverse_inertia == 0.0) return;
  const double turning = static_cast<double>(body.GetAngularVelocity());
  body.ApplyAngularImpulse(static_cast<float>((rigid.turned / dt - turning) / rigid.inverse_inertia), true);
  const double end_turning = rigid.angular_velocity + rigid.inverse_inertia * rigid.angular_impulse;
  holder.ahead_turning = end_turning - static_cast<double>(body.GetAngularVelocity());
}

void Coupling::hold(CordIndex cord, int point, b2Body& body, b2Vec2 local_hand) {
  if (cord < 0 || cord >= size()) {
    throw ribbon::DefinitionError("cord is " + std::to_string(cord) + "; accepted is an index from 0 to " +
                                  std::to_string(size() - 1));
  }
  std::visit([point](const auto& held) { held.check_point(point); }, cords_[at(cord)].cord);
  if (Holder* held = holder(body)) {
    if (held->cord != cord || held->point != point) held->local_hand = local_hand;
    held->cord = cord;
    held->point = point;
    held->next_hand = local_hand;
  } else {
    holders_.push_back({&body, cord, point, local_hand, local_hand, {}});
  }
}

bool Coupling::release(b2Body& body) {
  const Holder* held = holder(body);
  if (held == nullptr) return false;
  body.SetLinearVelocity(to_float(velocity(body)));
  body.SetAngularVelocity(static_cast<float>(static_cast<double>(body.GetAngularVelocity()) + held->ahead_turning));
  forget(body);
  return true;
}

void Coupling::destroy(b2World& world, b2Body& body) {
  forget(body);
  world.DestroyBody(&body);
}

void Coupling::forget(const b2Body& body) {
  const auto holds = [&body](const Holder& holder) { return holder.body == &body; };
  holders_.erase(std::remove_if(holders_.begin(), holders_.end(), holds), holders_.end());
}

Vec2 Coupling::velocity(const b2Body& body) const {
  const Holder* held = holder(body);
  return to_double(body.GetLinearVelocity()) + (held != nullptr ? held->ahead : Vec2{});
}

const Coupling::Holder* Coupling::holder(const b2Body& body) const {
  for (const Holder& holder : holders_) {
    if (holder.body == &body) return &holder;
  }
  return nullptr;
}

Coupling::Holder* Coupling::holder(const b2Body& body) {
  return const_cast<Holder*>(std::as_const(*this).holder(body));
}

std::optional<CordPoint> Coupling::held_by(const b2Body& body) const {
  const Holder* held = holder(body);
  if (held == nullptr) return std::nullopt;
  return CordPoint{held->cord, held->point, 0.0};
}

std::optional<CordPoint> Coupling::nearest_point(Vec2 position, double reach) const {
  std::optional<CordPoint> nearest;
  for (CordIndex c = 0; c < size(); ++c) {
    const auto positions = this->positions(c);
    for (std::size_t p = 0; p < positions.size(); ++p) {
      const double distance = length(positions[p] - position);
      if (distance > reach || (nearest && distance >= nearest->distance)) continue;
      nearest = CordPoint{c, static_cast<int>(p), distance};
    }
  }
  return nearest;
}

}  // namespace engine
