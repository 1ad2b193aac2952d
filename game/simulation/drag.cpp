#include "game/simulation/drag.h"

#include <box2d/b2_distance.h>

#include <algorithm>
#include <cmath>

#include "game/simulation/buttons.h"
#include "game/simulation/index.h"
#include "ribbon/box2d/convert.h"

namespace game {
namespace {

using ribbon::Vec2;
using ribbon::box2d::to_double;
using ribbon::box2d::to_float;

constexpr double approach_ticks = 3.0;  // in which a body reaches the pointer, unless the maximum speed limits it

/// Returns `to`, moved towards `from` if it is farther than max_distance.
Vec2 clamp_distance(Vec2 from, Vec2 to, double max_distance) {
  const double distance = length(to - from);
  return distance > max_distance ? from + (max_distance / distance) * (to - from) : to;
}

bool is_constrained(const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord, int point) {
  return coupling.cord(cord).kind(point) == ribbon::PointKind::constrained;
}

/// Returns the distance along the cord between two points, in m.
double path_length(const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord, int from, int to) {
  const int rows = coupling.cord(cord).shape().rows;
  const auto x = coupling.cord(cord).positions();
  const std::size_t row = at(from % rows);
  const std::size_t step = at(rows);
  double sum = 0.0;
  for (std::size_t p = at(std::min(from, to) / rows) * step + row; p < at(std::max(from, to) / rows) * step + row;
       p += step) {
    sum += length(x[p + step] - x[p]);
  }
  return sum;
}

/// Returns the position to which a point is dragged in this tick: at most `max_distance` m towards `pointer`, and not
/// farther from any pin than the cord is long between them, since an inextensible cord cannot follow.
Vec2 reachable_target(const ribbon::box2d::Coupling& coupling, const ribbon::box2d::CordPoint& dragged, Vec2 pointer,
                      double max_distance) {
  const auto x = coupling.cord(dragged.cord).positions();
  const int rows = coupling.cord(dragged.cord).shape().rows;
  Vec2 target = clamp_distance(x[at(dragged.point)], pointer, max_distance);
  for (int p = 0; p < static_cast<int>(x.size()); ++p) {
    if (p / rows == dragged.point / rows || !is_constrained(coupling, dragged.cord, p)) continue;
    target = clamp_distance(x[at(p)], target, path_length(coupling, dragged.cord, dragged.point, p));
  }
  return target;
}

/// Returns the distance of a point from a body in m; 0 inside it.
double distance_to(const b2Body& body, Vec2 position) {
  b2CircleShape point;
  point.m_radius = 0.0F;
  b2DistanceInput input;
  input.proxyA.Set(&point, 0);
  input.transformA.Set(to_float(position), 0.0F);
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

/// Returns the impulse that changes the velocity of a point of a body by `change`. `arm`: the point relative to the
/// centre of mass.
Vec2 impulse_for(const b2Body& body, Vec2 arm, Vec2 change) {
  const double inverse_mass = 1.0 / static_cast<double>(body.GetMass());
  const Vec2 local = to_double(body.GetLocalCenter());
  const double inertia =
      static_cast<double>(body.GetInertia()) - static_cast<double>(body.GetMass()) * dot(local, local);
  const double inverse_inertia = body.IsFixedRotation() || inertia <= 0.0 ? 0.0 : 1.0 / inertia;
  // K = (1/m)·1 + (1/I)·[arm]ᵀ[arm], a 2 × 2 matrix
  const double xx = inverse_mass + inverse_inertia * arm.y * arm.y;
  const double xy = -inverse_inertia * arm.x * arm.y;
  const double yy = inverse_mass + inverse_inertia * arm.x * arm.x;
  const double determinant = xx * yy - xy * xy;
  return (1.0 / determinant) * Vec2{yy * change.x - xy * change.y, xx * change.y - xy * change.x};
}

}  // namespace

void Drag::apply(const engine::TickInput& input, ribbon::box2d::Coupling& coupling,
                 std::span<const engine::SceneBody> bodies, std::span<b2Body* const> players, double dt) {
  if (cord_point_ && !coupling.cord(cord_point_->cord).is_valid()) follow_piece(coupling);
  if ((input.buttons & button_drag) == 0) return release(coupling);
  const Vec2 pointer = engine::pointer(input);
  if (!body_ && !cord_point_) pick(pointer, coupling, bodies, players);
  if (body_) move_body(pointer, coupling, dt);
  if (cord_point_) move_cord_point(pointer, coupling, dt);
}

void Drag::pick(Vec2 pointer, ribbon::box2d::Coupling& coupling, std::span<const engine::SceneBody> bodies,
                std::span<b2Body* const> players) {
  body_ = nearest_body(pointer, bodies, players);
  const auto nearest = coupling.nearest_point(pointer, cord_range);
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

/// The cord was cut: the point is now one of a piece, which has a higher id. It is still constrained, unless that piece
/// is gone too.
void Drag::follow_piece(const ribbon::box2d::Coupling& coupling) {
  constexpr double same_place = 1e-6;  // m
  const ribbon::box2d::CordId cut = cord_point_->cord;
  cord_point_.reset();
  for (const ribbon::box2d::CordId id : coupling.cords()) {
    if (id <= cut) continue;
    const auto x = coupling.cord(id).positions();
    for (int p = 0; p < static_cast<int>(x.size()); ++p) {
      if (length(x[at(p)] - cord_at_) > same_place || !is_constrained(coupling, id, p)) continue;
      cord_point_ = ribbon::box2d::CordPoint{id, p};
      return;
    }
  }
}

void Drag::release(ribbon::box2d::Coupling& coupling) {
  if (body_ && body_->type != b2_dynamicBody) {
    body_->body->SetLinearVelocity(body_->velocity);
    body_->body->SetType(body_->type);
  }
  if (cord_point_ && !is_pin_ && coupling.cord(cord_point_->cord).is_valid())
    coupling.cord(cord_point_->cord).free(cord_point_->point);
  forget();
}

std::optional<Drag::Body> Drag::nearest_body(Vec2 pointer, std::span<const engine::SceneBody> bodies,
                                             std::span<b2Body* const> players) {
  std::optional<Body> nearest;
  int number = 0;
  const auto consider = [&](b2Body& body, bool is_ground) {
    const Body found{&body, number++, is_ground ? body_range : distance_to(body, pointer)};
    if (!is_ground && found.distance <= (nearest ? nearest->distance : body_range)) nearest = found;
  };
  for (const engine::SceneBody& made : bodies) consider(*made.body, made.kind == engine::BodyKind::ground);
  for (b2Body* player : players) consider(*player, false);
  return nearest;
}

/// Moves the body by its velocity, so that it still collides: a kinematic body gets the velocity, a dynamic body an
/// impulse towards it.
void Drag::move_body(Vec2 pointer, const ribbon::box2d::Coupling& coupling, double dt) const {
  b2Body& body = *body_->body;
  const Vec2 held_at = to_double(body.GetWorldPoint(body_->at));
  const Vec2 wanted = clamp_distance({}, (1.0 / (approach_ticks * dt)) * (pointer - held_at), max_speed);
  if (body.GetType() != b2_dynamicBody) {
    return body.SetLinearVelocity(to_float(clamp_distance({}, wanted, max_pin_speed)));
  }
  const Vec2 arm = held_at - to_double(body.GetWorldCenter());
  const double spin = static_cast<double>(body.GetAngularVelocity());
  const Vec2 now = coupling.body(body).velocity() + spin * Vec2{-arm.y, arm.x};
  const double max_impulse = max_acceleration * static_cast<double>(body.GetMass()) * dt;
  const Vec2 impulse = clamp_distance({}, impulse_for(body, arm, wanted - now), max_impulse);
  body.ApplyLinearImpulse(to_float(impulse), to_float(held_at), true);
}

/// Drags a free point. A pin stays a pin: it moves with all pins of its column.
void Drag::move_cord_point(Vec2 pointer, ribbon::box2d::Coupling& coupling, double dt) {
  const ribbon::box2d::CordId cord = cord_point_->cord;
  const int point = cord_point_->point;
  const Vec2 target = reachable_target(coupling, *cord_point_, pointer, (is_pin_ ? max_pin_speed : max_speed) * dt);
  cord_at_ = target;
  if (!is_pin_) return coupling.cord(cord).drag(point, target);
  const auto x = coupling.cord(cord).positions();
  const Vec2 displacement = target - x[at(point)];
  const int rows = coupling.cord(cord).shape().rows;
  const int first = point / rows * rows;
  for (int p = first; p < first + rows; ++p) {
    if (is_constrained(coupling, cord, p)) coupling.cord(cord).pin(p, x[at(p)] + displacement);
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
