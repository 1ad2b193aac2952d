#include "game/simulation/drag.h"

#include <box2d/b2_distance.h>

#include <algorithm>
#include <cmath>

#include "game/simulation/buttons.h"
#include "ribbon/box2d/convert.h"

namespace game {
namespace {

using ribbon::Vec2;
using ribbon::box2d::to_double;
using ribbon::box2d::to_float;

constexpr double ticks_to_get_there = 3.0;  // in which a body closes up to the pointer, if it may be as fast

std::size_t at(int index) { return static_cast<std::size_t>(index); }

Vec2 no_further(Vec2 from, Vec2 to, double most) {
  const double way = length(to - from);
  return way > most ? from + (most / way) * (to - from) : to;
}

bool is_constrained(const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord, int point) {
  return coupling.cord(cord).kind(point) == ribbon::PointKind::constrained;
}

/// m, along the cord from one point to another.
double way_between(const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord, int from, int to) {
  const int rows = coupling.cord(cord).shape().rows;
  const auto x = coupling.cord(cord).positions();
  const std::size_t row = at(from % rows);
  const std::size_t step = at(rows);
  double way = 0.0;
  for (std::size_t p = at(std::min(from, to) / rows) * step + row; p < at(std::max(from, to) / rows) * step + row;
       p += step) {
    way += length(x[p + step] - x[p]);
  }
  return way;
}

/// Where a point can be dragged to in this tick: towards `pointer` by `most` [m], and no further from what else the
/// cord is fixed to than it is long. One that does not stretch would be torn about otherwise.
Vec2 within_reach(const ribbon::box2d::Coupling& coupling, const ribbon::box2d::CordPoint& dragged, Vec2 pointer,
                  double most) {
  const auto x = coupling.cord(dragged.cord).positions();
  const int rows = coupling.cord(dragged.cord).shape().rows;
  Vec2 target = no_further(x[at(dragged.point)], pointer, most);
  for (int p = 0; p < static_cast<int>(x.size()); ++p) {
    if (p / rows == dragged.point / rows || !is_constrained(coupling, dragged.cord, p)) continue;
    target = no_further(x[at(p)], target, way_between(coupling, dragged.cord, dragged.point, p));
  }
  return target;
}

/// m, from a place to the rim of a body; 0 inside it.
double distance_to(const b2Body& body, Vec2 place) {
  b2CircleShape point;
  point.m_radius = 0.0F;
  b2DistanceInput input;
  input.proxyA.Set(&point, 0);
  input.transformA.Set(to_float(place), 0.0F);
  input.transformB = body.GetTransform();
  input.useRadii = true;
  float nearest = b2_maxFloat;
  for (const b2Fixture* fixture = body.GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext()) {
    input.proxyB.Set(fixture->GetShape(), 0);
    b2SimplexCache cache;
    cache.count = 0;
    b2DistanceOutput output;
    b2Distance(&output, &cache, &input);
    nearest = std::min(nearest, output.distance);
  }
  return static_cast<double>(nearest);
}

/// The impulse that changes the velocity of a body's point, `arm` from its centre of mass, by `change`.
Vec2 impulse_for(const b2Body& body, Vec2 arm, Vec2 change) {
  const double inverse_mass = 1.0 / static_cast<double>(body.GetMass());
  const Vec2 local = to_double(body.GetLocalCenter());
  const double inertia =
      static_cast<double>(body.GetInertia()) - static_cast<double>(body.GetMass()) * dot(local, local);
  const double inverse_inertia = body.IsFixedRotation() || inertia <= 0.0 ? 0.0 : 1.0 / inertia;
  // K = (1/m)·1 + (1/I)·[arm]ᵀ[arm], two by two
  const double xx = inverse_mass + inverse_inertia * arm.y * arm.y;
  const double xy = -inverse_inertia * arm.x * arm.y;
  const double yy = inverse_mass + inverse_inertia * arm.x * arm.x;
  const double determinant = xx * yy - xy * xy;
  return (1.0 / determinant) * Vec2{yy * change.x - xy * change.y, xx * change.y - xy * change.x};
}

}  // namespace

void Drag::apply(const engine::TickInput& input, engine::Scene& scene, b2Body& player, double dt) {
  ribbon::box2d::Coupling& coupling = scene.coupling();
  if ((input.buttons & button_drag) == 0) return let_go(coupling);
  const Vec2 pointer = engine::pointer(input);
  if (!body_ && !cord_point_) take(pointer, scene, player);
  if (body_) move_body(pointer, coupling, dt);
  if (cord_point_) move_cord_point(pointer, coupling, dt);
}

void Drag::take(Vec2 pointer, engine::Scene& scene, b2Body& player) {
  ribbon::box2d::Coupling& coupling = scene.coupling();
  body_ = nearest_body(pointer, scene, player);
  const auto nearest = coupling.nearest_point(pointer, cord_reach);
  if (body_ && nearest && nearest->distance < body_->distance) body_.reset();
  if (body_) {
    b2Body& body = *body_->body;
    body_->at = body.GetLocalPoint(to_float(pointer));
    body_->type = body.GetType();
    body_->velocity = body.GetLinearVelocity();
    if (body_->type == b2_staticBody) body.SetType(b2_kinematicBody);
  } else if (nearest) {
    cord_point_ = nearest;
    is_pin_ = is_constrained(coupling, nearest->cord, nearest->point);
  }
}

void Drag::let_go(ribbon::box2d::Coupling& coupling) {
  if (body_ && body_->type != b2_dynamicBody) {
    body_->body->SetLinearVelocity(body_->velocity);
    body_->body->SetType(body_->type);
  }
  if (cord_point_ && !is_pin_) coupling.cord(cord_point_->cord).free(cord_point_->point);
  forget();
}

std::optional<Drag::Body> Drag::nearest_body(Vec2 pointer, const engine::Scene& scene, b2Body& player) {
  std::optional<Body> nearest;
  int number = 0;
  const auto look_at = [&](b2Body& body, bool stays) {
    const Body found{&body, number++, stays ? body_reach : distance_to(body, pointer)};
    if (!stays && found.distance <= (nearest ? nearest->distance : body_reach)) nearest = found;
  };
  for (const engine::SceneBody& made : scene.bodies()) look_at(*made.body, made.kind == engine::BodyKind::ground);
  look_at(player, false);
  return nearest;
}

/// By its velocity, so that everything else pushes it as ever: one that is driven has that of the pointer, and one that
/// has a mass is pushed towards it.
void Drag::move_body(Vec2 pointer, const ribbon::box2d::Coupling& coupling, double dt) const {
  b2Body& body = *body_->body;
  const Vec2 held_at = to_double(body.GetWorldPoint(body_->at));
  const Vec2 wanted = no_further({}, (1.0 / (ticks_to_get_there * dt)) * (pointer - held_at), speed);
  if (body.GetType() != b2_dynamicBody) {
    return body.SetLinearVelocity(to_float(no_further({}, wanted, pin_speed)));
  }
  const Vec2 arm = held_at - to_double(body.GetWorldCenter());
  const double turning = static_cast<double>(body.GetAngularVelocity());
  const Vec2 now = coupling.velocity(body) + turning * Vec2{-arm.y, arm.x};
  const double most = strength * static_cast<double>(body.GetMass()) * dt;
  const Vec2 impulse = no_further({}, impulse_for(body, arm, wanted - now), most);
  body.ApplyLinearImpulse(to_float(impulse), to_float(held_at), true);
}

/// What is fixed stays so: all of a column's points that are go along.
void Drag::move_cord_point(Vec2 pointer, ribbon::box2d::Coupling& coupling, double dt) const {
  const ribbon::box2d::CordId cord = cord_point_->cord;
  const int point = cord_point_->point;
  const Vec2 target = within_reach(coupling, *cord_point_, pointer, (is_pin_ ? pin_speed : speed) * dt);
  if (!is_pin_) return coupling.cord(cord).drag(point, target);
  const auto x = coupling.cord(cord).positions();
  const Vec2 way = target - x[at(point)];
  const int rows = coupling.cord(cord).shape().rows;
  const int first = point / rows * rows;
  for (int p = first; p < first + rows; ++p) {
    if (is_constrained(coupling, cord, p)) coupling.cord(cord).pin(p, x[at(p)] + way);
  }
}

void Drag::add_to(ribbon::box2d::Hasher& hasher) const {
  hasher.add(cord_point_ ? cord_point_->cord : -1);
  hasher.add(cord_point_ ? cord_point_->point : -1);
  if (!body_) return;
  hasher.add(body_->number);
  hasher.add(to_double(body_->at));
}

}  // namespace game
