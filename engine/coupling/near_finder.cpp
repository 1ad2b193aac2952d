#include "ribbon/box2d/near_finder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "ribbon/box2d/convert.h"

namespace ribbon::box2d {
namespace {

constexpr double times_way = 4.0;       // that a body goes in a tick by itself, it is looked for from
constexpr double single_least = 1e-30;  // m
constexpr int cords_a_part = 64;        // at least, that are one task
constexpr std::size_t most_cords_a_query = 16;
constexpr std::size_t few_leaves = 4;    // for each cord of a group: the next group may be larger
constexpr std::size_t many_leaves = 16;  // for each cord of a group: it is too large
constexpr int bodies_a_leaf = 30;        // that are gone through in the time in which a leaf of a tree is looked at

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

/// m, that a part of a body may go in a tick of dt seconds in which it falls so far [m], and more.
double way_of(const b2Body& body, const Box& box, double fall, double dt) {
  const double turning = std::abs(static_cast<double>(body.GetAngularVelocity()));
  const double speed = static_cast<double>(body.GetLinearVelocity().Length()) +
                       (turning > 0.0 ? turning * extent(box, to_double(body.GetWorldCenter())) : 0.0);
  return std::min(most_way(fall), times_way * (speed * dt + fall));
}

/// Looks at a part of a fixture for a cord.
void look_at(b2Fixture& fixture, int child, const Look& look, double fall, double dt) {
  const b2Body& body = *fixture.GetBody();
  const b2AABB& aabb = fixture.GetAABB(child);
  if (!is_sound(aabb) || !can_be_met(body)) return;
  const Box box = to_box(aabb);
  const double way = way_of(body, box, fall, dt);
  if (!overlap(box, widened(look.reach, way))) return;
  if (fixture.IsSensor() || (look.circles && fixture.GetType() != b2Shape::e_circle)) return;
  if (!should_collide(fixture.GetFilterData(), look.filter)) return;
  look.near->push_back({&fixture, child, way});
}

void look_at(const b2BroadPhase& broad_phase, int leaf, const Look& look, double fall, double dt) {
  const auto* proxy = static_cast<const b2FixtureProxy*>(broad_phase.GetUserData(leaf));
  look_at(*proxy->fixture, proxy->childIndex, look, fall, dt);
}

/// Whether a body moves, so that it may come near though the tree has it further off: the box that it is in there has
/// no margin left where it has moved inside it.
bool moves(const b2Body& body) {
  return body.GetType() != b2_staticBody && body.IsAwake() &&
         !(body.GetLinearVelocity() == b2Vec2_zero && body.GetAngularVelocity() == 0.0F);
}

/// Passes each leaf that a query of Box2D's tree finds to a function.
template <typename Take>
struct LeafCalls {
  bool QueryCallback(int32 leaf) const {  // NOLINT(readability-identifier-naming): Box2D names it
    return take(leaf);
  }
  const Take& take;  // returns whether to go on
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

void NearFinder::reserve(std::size_t leaves, std::size_t cords) {
  if (lookouts_.empty()) lookouts_.emplace_back();
  lookouts_.front().leaves.reserve(std::max(leaves, most_cords_a_query * many_leaves));
  lookouts_.front().further.reserve(leaves);
  by_x_.reserve(cords);
}

/// What the tree has further off matters only if it moves. It is looked at about each cord as long as that takes less
/// than to go through all bodies once.
void NearFinder::find(b2World& world, std::span<const Look> looks, Vec2 gravity, double dt,
                      const ParallelFor& parallel_for) {
  broad_phase_ = &world.GetContactManager().m_broadPhase;
  if (broad_phase_->GetProxyCount() == 0) return;
  dt_ = dt;
  fall_ = length(gravity) * dt * dt;
  const int parts = parallel_for.parts(static_cast<int>(looks.size()), cords_a_part);
  const auto count = static_cast<std::size_t>(parts);
  lookouts_.resize(std::max(lookouts_.size(), count));
  most_leaves_ = static_cast<std::size_t>(world.GetBodyCount() / (bodies_a_leaf * parts));
  parallel_for(parts, [&](int part) {
    const auto k = static_cast<std::size_t>(part);
    look_around(lookouts_[k], looks, looks.size() * k / count, looks.size() * (k + 1) / count);
  });
  const auto lookouts = std::span(lookouts_).first(count);
  if (!std::all_of(lookouts.begin(), lookouts.end(), [](const Lookout& lookout) { return lookout.about_each; })) {
    look_for_what_moves(world, looks);
    return;
  }
  for (const Lookout& lookout : lookouts) {
    for (const auto& [k, leaf] : lookout.further) look_at(*broad_phase_, leaf, looks[k], fall_, dt_);
  }
}

/// For the looks first … last − 1. It changes nothing but what they find. Neighbours in the list are mostly neighbours
/// in the world, and their queries go the same way down the tree; one query for a group of them costs less than one for
/// each. Groups grow as long as few leaves are near them, and shrink where there are many. What is found does not
/// depend on the groups.
void NearFinder::look_around(Lookout& lookout, std::span<const Look> looks, std::size_t first, std::size_t last) {
  lookout.further.clear();
  lookout.about_each = true;
  std::size_t wanted = 1;
  while (first < last) {
    const std::size_t size = std::min(wanted, last - first);
    if (!list_leaves(lookout, looks.subspan(first, size))) {
      wanted = size / 2;
      continue;
    }
    for (const std::size_t end = first + size; first < end; ++first) look_at_leaves(lookout, looks[first], first);
    lookout.about_each = lookout.further.size() <= most_leaves_;
    if (lookout.leaves.size() <= size * few_leaves) wanted = std::min(2 * size, most_cords_a_query);
  }
}

/// Lists the leaves of the tree near some cords. Stops and returns false if there are many, unless it is for one cord.
bool NearFinder::list_leaves(Lookout& lookout, std::span<const Look> group) const {
  Box box = group.front().reach;
  for (const Look& look : group) box = joined(box, look.reach);
  const std::size_t most = group.size() == 1 ? std::numeric_limits<std::size_t>::max() : group.size() * many_leaves;
  lookout.leaves.clear();
  const auto take = [&](int leaf) {
    lookout.leaves.push_back({broad_phase_->GetFatAABB(leaf), leaf});
    return lookout.leaves.size() < most;
  };
  const LeafCalls<decltype(take)> calls{take};
  broad_phase_->Query(&calls, to_aabb(widened(box, lookout.about_each ? most_way(fall_) : times_way * fall_)));
  return lookout.leaves.size() < most;
}

/// Looks at those of the listed leaves that are near one cord.
void NearFinder::look_at_leaves(Lookout& lookout, const Look& look, std::size_t index) const {
  const b2AABB still = to_aabb(widened(look.reach, times_way * fall_));  // what does not move is met in there
  const b2AABB range = lookout.about_each ? to_aabb(widened(look.reach, most_way(fall_))) : still;
  for (const Leaf& leaf : lookout.leaves) {
    if (b2TestOverlap(leaf.fat, still)) {
      look_at(*broad_phase_, leaf.proxy, look, fall_, dt_);
    } else if (b2TestOverlap(leaf.fat, range)) {
      lookout.further.emplace_back(index, leaf.proxy);
    }
  }
}

/// Goes through all bodies. What is near a cord anyway is found once more.
void NearFinder::look_for_what_moves(b2World& world, std::span<const Look> looks) {
  sort_by_x(looks);
  for (b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
    if (!moves(*body) || !body->IsEnabled() || !can_be_met(*body)) continue;
    for (b2Fixture* fixture = body->GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext()) {
      for (int child = 0; child < fixture->GetShape()->GetChildCount(); ++child) look_from(looks, *fixture, child);
    }
  }
}

/// The looks by where their reaches begin: nearly as they were before, if there are as many.
void NearFinder::sort_by_x(std::span<const Look> looks) {
  if (by_x_.size() != looks.size()) {
    by_x_.resize(looks.size());
    std::iota(by_x_.begin(), by_x_.end(), std::size_t{0});
  }
  widest_ = 0.0;
  for (std::size_t k = 0; k < by_x_.size(); ++k) {
    const std::size_t look = by_x_[k];
    const Box& reach = looks[look].reach;
    widest_ = std::max(widest_, reach.high.x - reach.low.x);
    std::size_t place = k;
    for (; place > 0 && looks[by_x_[place - 1]].reach.low.x > reach.low.x; --place) by_x_[place] = by_x_[place - 1];
    by_x_[place] = look;
  }
}

/// For all that may reach a part of a fixture.
void NearFinder::look_from(std::span<const Look> looks, b2Fixture& fixture, int child) {
  const b2AABB& aabb = fixture.GetAABB(child);
  if (!is_sound(aabb)) return;
  const Box box = to_box(aabb);
  const Box way = widened(box, way_of(*fixture.GetBody(), box, fall_, dt_));
  const auto begins_before = [looks](std::size_t k, double x) { return looks[k].reach.low.x < x; };
  auto k = std::lower_bound(by_x_.begin(), by_x_.end(), way.low.x - widest_, begins_before);
  for (; k != by_x_.end() && looks[*k].reach.low.x <= way.high.x; ++k) {
    if (overlap(looks[*k].reach, way)) look_at(fixture, child, looks[*k], fall_, dt_);
  }
}

}  // namespace ribbon::box2d
