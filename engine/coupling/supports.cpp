#include "ribbon/box2d/supports.h"

#include <box2d/b2_distance.h>

#include <algorithm>
#include <limits>
#include <tuple>

#include "ribbon/box2d/convert.h"

namespace ribbon::box2d {
namespace {

constexpr double max_wedging_speed = 0.9;     // m/s, with which a cord may press a body between several contacts
constexpr double threshold_share = 0.9;       // of the speed from which on Box2D lets a body rebound
constexpr double least_pressing_speed = 0.3;  // m/s, that a contact gives the lighter body in a tick
constexpr double resting_overlap = 0.5 * static_cast<double>(b2_linearSlop);  // m, less than Box2D takes back

/// Returns whether a contact between dynamic bodies pushed the lighter one so much that it matters where cords are.
bool presses(const b2Contact& contact) {
  double impulse = 0.0;
  for (int k = 0; k < contact.GetManifold()->pointCount; ++k) {
    impulse += static_cast<double>(contact.GetManifold()->points[k].normalImpulse);
  }
  const double mass = static_cast<double>(
      std::min(contact.GetFixtureA()->GetBody()->GetMass(), contact.GetFixtureB()->GetBody()->GetMass()));
  return impulse > least_pressing_speed * mass;
}

/// Returns whether a body is moved by what pushes it. Box2D takes a dynamic body without mass for one that is not.
bool gives_way(const b2Body& body) { return body.GetType() == b2_dynamicBody && body.GetMass() > 0.0F; }

/// Returns whether the other body of a contact may push this one.
bool may_support(const b2ContactEdge& edge) {
  const b2Contact& contact = *edge.contact;
  if (!contact.IsEnabled() || contact.GetFixtureA()->IsSensor() || contact.GetFixtureB()->IsSensor()) return false;
  return !gives_way(*edge.other) || (contact.IsTouching() && presses(contact));
}

/// Returns the support by a body at a place of the supported one, m, that is `distance` [m] from the other one.
/// The normal is towards the body.
FoundSupport support_by(b2Body& other, b2Vec2 place, Vec2 normal, double distance) {
  FoundSupport found;
  Support& support = found.support;
  found.place = to_double(place);
  support.normal = normal;
  support.gap = distance > 0.0 ? distance + resting_overlap : 0.0;
  if (gives_way(other)) {
    found.other = &other;
  } else {
    support.speed = dot(to_double(other.GetLinearVelocityFromWorldPoint(place)), normal);
  }
  return found;
}

/// Returns whether Box2D lets two fixtures of different bodies collide.
bool may_collide(b2Fixture& a, b2Fixture& b) {
  if (a.IsSensor() || b.IsSensor()) return false;
  for (const b2JointEdge* edge = a.GetBody()->GetJointList(); edge != nullptr; edge = edge->next) {
    if (edge->other == b.GetBody() && !edge->joint->GetCollideConnected()) return false;
  }
  b2ContactFilter* const filter = a.GetBody()->GetWorld()->GetContactManager().m_contactFilter;
  return filter == nullptr || filter->ShouldCollide(&a, &b);
}

/// A fixture near a body, and how near [m] what counts has to be.
struct NearFixture {
  b2Fixture& own;
  b2Fixture& other;
  double reach;
};

/// Appends the place where a child of each of two fixtures that do not touch are nearest to each other. The normal is
/// that between their shapes without radii: the surfaces may be nearer to each other than single precision tells.
void append_nearest(const NearFixture& near, int own_child, int other_child, std::vector<FoundSupport>& supports) {
  b2DistanceInput input;
  input.proxyA.Set(near.own.GetShape(), own_child);
  input.proxyB.Set(near.other.GetShape(), other_child);
  input.transformA = near.own.GetBody()->GetTransform();
  input.transformB = near.other.GetBody()->GetTransform();
  input.useRadii = false;
  b2SimplexCache cache;
  cache.count = 0;
  b2DistanceOutput nearest;
  b2Distance(&nearest, &cache, &input);
  const Vec2 to_body = to_double(nearest.pointA) - to_double(nearest.pointB);
  const double own_radius = static_cast<double>(input.proxyA.m_radius);
  const double distance = length(to_body) - own_radius - static_cast<double>(input.proxyB.m_radius);
  if (!(distance > 0.0 && distance < near.reach)) return;
  const Vec2 normal = (1.0 / length(to_body)) * to_body;
  const b2Vec2 place = to_float(to_double(nearest.pointA) - own_radius * normal);
  supports.push_back(support_by(*near.other.GetBody(), place, normal, distance));
}

/// Collects each fixture once, although Box2D reports it for each of its children.
struct FixtureCollector : b2QueryCallback {
  explicit FixtureCollector(std::vector<b2Fixture*>& memory) : found(memory) {}
  bool ReportFixture(b2Fixture* fixture) override {
    if (std::find(found.begin(), found.end(), fixture) == found.end()) found.push_back(fixture);
    return true;
  }
  std::vector<b2Fixture*>& found;
};

/// Appends the places of static and kinematic bodies that a fixture does not touch, but that are within `reach` [m].
/// The contacts of Box2D would not do: which it has of bodies that do not touch depends on where they have been.
void append_near(b2Fixture& fixture, double reach, std::vector<b2Fixture*>& memory,
                 std::vector<FoundSupport>& supports) {
  FixtureCollector collector(memory);
  const b2Vec2 margin{static_cast<float>(reach), static_cast<float>(reach)};
  for (int child = 0; child < fixture.GetShape()->GetChildCount(); ++child) {
    b2AABB box;
    fixture.GetShape()->ComputeAABB(&box, fixture.GetBody()->GetTransform(), child);
    box.lowerBound -= margin;
    box.upperBound += margin;
    memory.clear();
    fixture.GetBody()->GetWorld()->QueryAABB(&collector, box);
    for (b2Fixture* const other : memory) {
      if (other->GetBody()->GetType() == b2_dynamicBody || !may_collide(fixture, *other)) continue;
      for (int k = 0; k < other->GetShape()->GetChildCount(); ++k) {
        if (b2TestOverlap(box, other->GetAABB(k))) append_nearest({fixture, *other, reach}, child, k, supports);
      }
    }
  }
}

/// Appends the points at which the bodies of a contact touch now. (The contact's own manifold is of the start of the
/// last world.Step.) Where they overlap, Box2D keeps them from getting nearer. Returns whether there are any.
bool append(const b2Body& body, const b2ContactEdge& edge, std::vector<FoundSupport>& supports) {
  b2Contact& contact = *edge.contact;
  const b2Fixture& a = *contact.GetFixtureA();
  const b2Fixture& b = *contact.GetFixtureB();
  b2Manifold manifold;
  contact.Evaluate(&manifold, a.GetBody()->GetTransform(), b.GetBody()->GetTransform());
  if (manifold.pointCount == 0) return false;
  b2WorldManifold places;
  places.Initialize(&manifold, a.GetBody()->GetTransform(), a.GetShape()->m_radius, b.GetBody()->GetTransform(),
                    b.GetShape()->m_radius);
  const Vec2 to_body = to_double(b.GetBody() == &body ? places.normal : -places.normal);
  for (int k = 0; k < manifold.pointCount; ++k) {
    supports.push_back(support_by(*edge.other, places.points[k], (1.0 / length(to_body)) * to_body,
                                  static_cast<double>(places.separations[k])));
  }
  return true;
}

}  // namespace

/// In an order that does not depend on that of Box2D's list.
double append_supports(b2Body& body, const SupportSearch& search, std::vector<FoundSupport>& supports) {
  const auto first = static_cast<std::ptrdiff_t>(supports.size());
  double max_push = std::numeric_limits<double>::infinity();
  int contacts = 0;
  for (const b2ContactEdge* edge = body.GetContactList(); edge != nullptr; edge = edge->next) {
    if (!may_support(*edge) || !append(body, *edge, supports)) continue;
    ++contacts;
    if (!(edge->contact->GetRestitution() > 0.0F)) continue;
    max_push = std::min(max_push, threshold_share * static_cast<double>(edge->contact->GetRestitutionThreshold()));
  }
  if (search.reach > 0.0) {
    for (b2Fixture* own = body.GetFixtureList(); own != nullptr; own = own->GetNext())
      append_near(*own, search.reach, search.memory, supports);
  }
  const auto key = [](const FoundSupport& found) {
    const Support& s = found.support;
    return std::tuple(s.normal.x, s.normal.y, found.place.x, found.place.y, s.gap, s.speed);
  };
  std::sort(supports.begin() + first, supports.end(),
            [&](const FoundSupport& a, const FoundSupport& b) { return key(a) < key(b); });
  return contacts > 1 ? std::min(max_push, max_wedging_speed) : max_push;
}

}  // namespace ribbon::box2d
