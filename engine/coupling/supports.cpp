#include "ribbon/box2d/supports.h"

#include <algorithm>
#include <limits>
#include <tuple>

#include "ribbon/box2d/convert.h"

namespace ribbon::box2d {
namespace {

constexpr double max_wedging_speed = 0.9;  // m/s, with which a cord may press a body between several contacts
constexpr double threshold_share = 0.9;    // of the speed from which on Box2D lets a body rebound
constexpr double resting_overlap = 0.5 * static_cast<double>(b2_linearSlop);  // m, less than Box2D takes back

/// Returns whether a body that does not give way may push the body of this contact.
bool may_support(const b2ContactEdge& edge) {
  const b2Contact& contact = *edge.contact;
  return edge.other->GetType() != b2_dynamicBody && contact.IsEnabled() && !contact.GetFixtureA()->IsSensor() &&
         !contact.GetFixtureB()->IsSensor();
}

/// Appends the points at which the bodies of a contact touch now. (The contact's own manifold is of the start of the
/// last world.Step.) Where they overlap, Box2D keeps them from getting nearer. Returns whether there are any.
bool append(const b2Body& body, const b2ContactEdge& edge, int index, std::vector<Support>& supports) {
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
    const double separation = static_cast<double>(places.separations[k]);
    Support support;
    support.body = index;
    support.arm = to_double(places.points[k]) - to_double(body.GetWorldCenter());
    support.normal = (1.0 / length(to_body)) * to_body;
    support.gap = separation > 0.0 ? separation + resting_overlap : 0.0;
    support.speed = dot(to_double(edge.other->GetLinearVelocityFromWorldPoint(places.points[k])), support.normal);
    supports.push_back(support);
  }
  return true;
}

}  // namespace

/// In an order that does not depend on that of Box2D's list.
double append_supports(const b2Body& body, int index, std::vector<Support>& supports) {
  const auto first = static_cast<std::ptrdiff_t>(supports.size());
  double max_push = std::numeric_limits<double>::infinity();
  int contacts = 0;
  for (const b2ContactEdge* edge = body.GetContactList(); edge != nullptr; edge = edge->next) {
    if (!may_support(*edge) || !append(body, *edge, index, supports)) continue;
    ++contacts;
    if (!(edge->contact->GetRestitution() > 0.0F)) continue;
    max_push = std::min(max_push, threshold_share * static_cast<double>(edge->contact->GetRestitutionThreshold()));
  }
  const auto key = [](const Support& s) {
    return std::tuple(s.normal.x, s.normal.y, s.arm.x, s.arm.y, s.gap, s.speed);
  };
  std::sort(supports.begin() + first, supports.end(),
            [&](const Support& a, const Support& b) { return key(a) < key(b); });
  return contacts > 1 ? std::min(max_push, max_wedging_speed) : max_push;
}

}  // namespace ribbon::box2d
