// What the cords see of the world before a tick: who holds them, and what they may reach.

#include <algorithm>
#include <cmath>
#include <functional>
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
constexpr int cords_a_part = 64;      // at least, that are one task
constexpr int bodies_a_leaf = 30;     // that are gone through in the time in which a leaf of a tree is looked at

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
  const Vec2 gravity = to_double(world.GetGravity());
  ribbon::check_step(dt, gravity);
  const bool as_before = gravity == gravity_ && dt == dt_;
  gravity_ = gravity;
  dt_ = dt;
  gathered_.clear();
  rigid_.clear();
  body_places_.clear();
  fixture_ids_.begin_tick();
  enter(world);
  look_at_holders();
  look_around(world, as_before);
  number_new_fixtures(world);
  for (CoupledCord& coupled : cords_) meet(coupled);
  gather_grips();
  let_run_who_left();
  look_for_the_missing(world);
}

/// That of a cord that sleeps stays as it is.
void Coupling::find_reach(CoupledCord& coupled, bool as_before) const {
  const auto* direct = std::get_if<ribbon::Cord>(&coupled.cord);
  const bool asleep = coupled.enabled && direct != nullptr && direct->is_asleep();
  if (asleep && coupled.reach_rests && as_before) return;
  coupled.reach_rests = asleep;
  coupled.reach = {};
  if (!coupled.enabled) return;
  coupled.reach = std::visit([&](const auto& cord) { return reach_of(cord, gravity_, dt_); }, coupled.cord);
}

Look Coupling::look_of(const CoupledCord& coupled) const {
  const bool is_thesis = std::holds_alternative<ribbon::ThesisCord>(coupled.cord);
  return {coupled.reach, coupled.filter, is_thesis, gravity_, dt_};
}

/// Finds what each cord may reach. What comes from further off is looked for about each cord as long as
/// that takes less than to go through all bodies once.
void Coupling::look_around(b2World& world, bool as_before) {
  const int parts = parallel_for_.parts(size(), cords_a_part);
  lookouts_.resize(std::max(lookouts_.size(), at(parts)));
  const auto most = at(world.GetBodyCount() / (bodies_a_leaf * parts));
  parallel_for_(parts, [&](int part) {
    const auto share = [&](int k) { return static_cast<CordIndex>(std::int64_t{size()} * k / parts); };
    look_around(lookouts_[at(part)], share(part), share(part + 1), {world, as_before, most});
  });
  const auto first = lookouts_.begin();
  if (!std::all_of(first, first + parts, [](const Lookout& lookout) { return lookout.about_each; })) {
    look_for_what_moves(world);
    return;
  }
  for (auto lookout = first; lookout != first + parts; ++lookout) {
    for (const auto& [c, leaf] : lookout->further) {
      const Look look = look_of(cords_[at(c)]);
      NearSearch(world, look, cords_[at(c)].near, nullptr).look_at(leaf);
    }
  }
}

/// For the cords first … last − 1. It changes nothing but theirs.
void Coupling::look_around(Lookout& lookout, CordIndex first, CordIndex last, const Around& around) {
  lookout.further.clear();
  lookout.about_each = true;
  for (CordIndex c = first; c < last; ++c) {
    CoupledCord& coupled = cords_[at(c)];
    find_reach(coupled, around.as_before);
    coupled.near.clear();
    if (!coupled.enabled) continue;
    const Look look = look_of(coupled);
    lookout.leaves.clear();
    std::vector<int>* const leaves = lookout.about_each ? &lookout.leaves : nullptr;
    NearSearch(around.world, look, coupled.near, leaves).look_around();
    for (const int leaf : lookout.leaves) lookout.further.emplace_back(c, leaf);
    lookout.about_each = lookout.further.size() <= around.most_leaves;
  }
}

/// Goes through all bodies. What is near a cord anyway is found once more.
void Coupling::look_for_what_moves(b2World& world) {
  sort_by_x();
  for (b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
    if (!NearSearch::moves(*body) || !body->IsEnabled()) continue;
    for (b2Fixture* fixture = body->GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext()) {
      for (int child = 0; child < fixture->GetShape()->GetChildCount(); ++child) look_from(world, *fixture, child);
    }
  }
}

/// The cords by where their reaches begin, as nearly as they were before.
void Coupling::sort_by_x() {
  while (by_x_.size() < cords_.size()) by_x_.push_back(static_cast<CordIndex>(by_x_.size()));
  const auto low = [this](CordIndex c) { return cords_[at(c)].reach.low.x; };
  widest_ = 0.0;
  for (std::size_t k = 0; k < by_x_.size(); ++k) {
    const CordIndex c = by_x_[k];
    const Box& reach = cords_[at(c)].reach;
    widest_ = std::max(widest_, reach.high.x - reach.low.x);
    std::size_t place = k;
    for (; place > 0 && low(by_x_[place - 1]) > low(c); --place) by_x_[place] = by_x_[place - 1];
    by_x_[place] = c;
  }
}

/// Whoever may reach a part of a fixture.
void Coupling::look_from(const b2World& world, b2Fixture& fixture, int child) {
  const Box way = NearSearch::way_box(fixture, child, gravity_, dt_);
  const auto begins_before = [this](CordIndex c, double x) { return cords_[at(c)].reach.low.x < x; };
  auto c = std::lower_bound(by_x_.begin(), by_x_.end(), way.low.x - widest_, begins_before);
  for (; c != by_x_.end() && cords_[at(*c)].reach.low.x <= way.high.x; ++c) {
    CoupledCord& coupled = cords_[at(*c)];
    if (!coupled.enabled || !overlap(coupled.reach, way)) continue;
    const Look look = look_of(coupled);
    NearSearch(world, look, coupled.near, nullptr).look_at(fixture, child);
  }
}

/// In the world's own order: it depends on when they were made, never on where they lie in memory or who is far away.
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
