#include "engine/coupling_near.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/convert.h"

namespace engine {
namespace {

using ribbon::Box;
using ribbon::Vec2;

constexpr double times_way = 4.0;       // that a body goes in a tick by itself, it is looked for from
constexpr double single_least = 1e-30;  // m

bool is_small(float number) { return std::abs(number) <= 1e9F; }  // false for what is none

bool is_sound(const b2AABB& box) {
  return is_small(box.lowerBound.x) && is_small(box.lowerBound.y) && is_small(box.upperBound.x) &&
         is_small(box.upperBound.y);
}

Box to_box(const b2AABB& box) { return {to_double(box.lowerBound), to_double(box.upperBound)}; }

/// Around a box, in single precision.
b2AABB to_aabb(const Box& box) {
  const auto rounding = [](double x) { return std::abs(x) * static_cast<double>(b2_epsilon) + single_least; };
  b2AABB aabb;
  aabb.lowerBound = to_float(box.low - Vec2{rounding(box.low.x), rounding(box.low.y)});
  aabb.upperBound = to_float(box.high + Vec2{rounding(box.high.x), rounding(box.high.y)});
  return aabb;
}

/// Box2D's own rule (b2ContactFilter::ShouldCollide).
bool should_collide(const b2Filter& a, const b2Filter& b) {
  if (a.groupIndex == b.groupIndex && a.groupIndex != 0) return a.groupIndex > 0;
  return (a.maskBits & b.categoryBits) != 0 && (a.categoryBits & b.maskBits) != 0;
}

/// m, that a part of a body may go in a tick in which it falls so far [m].
double most_way(double fall) { return static_cast<double>(b2_maxTranslation) + times_way * fall; }

/// m, the furthest that a corner of a box is from a place.
double extent(const Box& box, Vec2 from) {
  const Vec2 corner{std::max(from.x - box.low.x, box.high.x - from.x),
                    std::max(from.y - box.low.y, box.high.y - from.y)};
  return length(corner);
}

/// What Box2D's tree calls with each of its leaves.
template <typename Take>
struct LeafCalls {
  bool QueryCallback(int32 proxy) const {  // NOLINT(readability-identifier-naming): Box2D names it
    take(proxy);
    return true;
  }
  const Take& take;
};

}  // namespace

bool is_sound(const b2Body& body) {
  return is_small(body.GetPosition().x) && is_small(body.GetPosition().y) && is_small(body.GetAngle()) &&
         is_small(body.GetLinearVelocity().x) && is_small(body.GetLinearVelocity().y) &&
         is_small(body.GetAngularVelocity()) && is_small(body.GetWorldCenter().x) &&
         is_small(body.GetWorldCenter().y) && is_small(body.GetGravityScale());
}

bool can_be_met(const b2Body& body) {
  return is_sound(body) && (body.GetType() != b2_dynamicBody || body.GetMass() > 0.0F);
}

NearSearch::NearSearch(const b2World& world, const Look& look, std::vector<NearShape>& near, std::vector<int>* further)
    : broad_phase_(&world.GetContactManager().m_broadPhase), look_(&look), near_(&near), further_(further) {
  const double fall = length(look.gravity) * look.dt * look.dt;
  most_way_ = most_way(fall);
  still_ = to_aabb(widened(look.reach, times_way * fall));
}

bool NearSearch::moves(const b2Body& body) {
  return body.GetType() != b2_staticBody && body.IsAwake() &&
         !(body.GetLinearVelocity() == b2Vec2_zero && body.GetAngularVelocity() == 0.0F);
}

double NearSearch::way_of(const b2Body& body, const Box& box, Vec2 gravity, double dt) {
  const double fall = length(gravity) * dt * dt;
  const double turning = std::abs(static_cast<double>(body.GetAngularVelocity()));
  const double speed = static_cast<double>(body.GetLinearVelocity().Length()) +
                       (turning > 0.0 ? turning * extent(box, to_double(body.GetWorldCenter())) : 0.0);
  return std::min(most_way(fall), times_way * (speed * dt + fall));
}

void NearSearch::look_around() {
  if (broad_phase_->GetProxyCount() == 0) return;
  const auto take = [this](int proxy) { take_leaf(proxy); };
  const LeafCalls<decltype(take)> calls{take};
  broad_phase_->Query(&calls, further_ != nullptr ? to_aabb(widened(look_->reach, most_way_)) : still_);
}

void NearSearch::take_leaf(int proxy) {
  if (further_ == nullptr || b2TestOverlap(broad_phase_->GetFatAABB(proxy), still_)) {
    look_at(proxy);
  } else {
    further_->push_back(proxy);
  }
}

void NearSearch::look_at(int proxy) {
  const auto* found = static_cast<const b2FixtureProxy*>(broad_phase_->GetUserData(proxy));
  look_at(*found->fixture, found->childIndex, found->aabb);
}

void NearSearch::look_at(b2Fixture& fixture, int child) { look_at(fixture, child, fixture.GetAABB(child)); }

Box NearSearch::way_box(const b2Fixture& fixture, int child, Vec2 gravity, double dt) {
  const b2AABB& aabb = fixture.GetAABB(child);
  const b2Body& body = *fixture.GetBody();
  if (!is_sound(aabb) || !engine::is_sound(body)) return {};
  return widened(to_box(aabb), way_of(body, to_box(aabb), gravity, dt));
}

void NearSearch::look_at(b2Fixture& fixture, int child, const b2AABB& aabb) {
  const b2Body& body = *fixture.GetBody();
  if (!is_sound(aabb) || !can_be_met(body)) return;
  const Box box = to_box(aabb);
  const double way = way_of(body, box, look_->gravity, look_->dt);
  if (!overlap(box, widened(look_->reach, way))) return;
  if (fixture.IsSensor() || (look_->circles && fixture.GetType() != b2Shape::e_circle)) return;
  if (!should_collide(fixture.GetFilterData(), look_->filter)) return;
  near_->push_back({&fixture, child, way});
}

}  // namespace engine
