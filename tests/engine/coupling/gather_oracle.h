#pragma once

#include <box2d/box2d.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "ribbon/box.h"
#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/coupling.h"

/// What Coupling::gather has to find: a search of all children of all fixtures.
namespace gather_oracle {

using Found = std::vector<std::pair<const b2Fixture*, int>>;

inline Found sorted(Found found) {
  std::sort(found.begin(), found.end());
  return found;
}

inline bool should_collide(const b2Filter& a, const b2Filter& b) {
  if (a.groupIndex == b.groupIndex && a.groupIndex != 0) return a.groupIndex > 0;
  return (a.maskBits & b.categoryBits) != 0 && (a.categoryBits & b.maskBits) != 0;
}

/// m/s and rad/s, as gather finds them: it gives a body that is no longer solver-driven its velocity carry.
using Speeds = std::map<const b2Body*, std::pair<double, double>>;

inline Speeds speeds_in(const b2World& world) {
  Speeds speeds;
  for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
    speeds[body] = {static_cast<double>(body->GetLinearVelocity().Length()),
                    std::abs(static_cast<double>(body->GetAngularVelocity()))};
  }
  return speeds;
}

/// Returns the maximum displacement of a part of a body in a tick by the documentation, m.
inline double way_of(const b2Body& body, const Speeds& speeds, const ribbon::Box& box, double fall, double dt) {
  const ribbon::Vec2 center = ribbon::box2d::to_double(body.GetWorldCenter());
  double extent = 0.0;
  for (const ribbon::Vec2 corner :
       {box.low, box.high, ribbon::Vec2{box.low.x, box.high.y}, ribbon::Vec2{box.high.x, box.low.y}}) {
    extent = std::max(extent, length(corner - center));
  }
  const auto [straight, turning] = speeds.at(&body);
  const double speed = straight + turning * extent;
  return std::min(static_cast<double>(b2_maxTranslation) + 4.0 * fall, 4.0 * (speed * dt + fall));
}

inline Found by_looking_at_all(const b2World& world, const Speeds& speeds, const ribbon::Box& reach,
                               const b2Filter& filter, double dt) {
  const double fall = length(ribbon::box2d::to_double(world.GetGravity())) * dt * dt;
  Found found;
  for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
    if (!body->IsEnabled() || (body->GetType() == b2_dynamicBody && !(body->GetMass() > 0.0F))) continue;
    for (const b2Fixture* f = body->GetFixtureList(); f != nullptr; f = f->GetNext()) {
      if (f->IsSensor() || !should_collide(f->GetFilterData(), filter)) continue;
      for (int child = 0; child < f->GetShape()->GetChildCount(); ++child) {
        const b2AABB& aabb = f->GetAABB(child);
        const ribbon::Box box{ribbon::box2d::to_double(aabb.lowerBound), ribbon::box2d::to_double(aabb.upperBound)};
        if (overlap(box, widened(reach, way_of(*body, speeds, box, fall, dt)))) found.emplace_back(f, child);
      }
    }
  }
  return sorted(found);
}

inline Found by_gather(const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord) {
  Found found;
  for (const ribbon::box2d::NearShape& shape : coupling.cord(cord).near())
    found.emplace_back(shape.fixture, shape.child);
  return sorted(found);
}

}  // namespace gather_oracle
