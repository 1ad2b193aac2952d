#include "ribbon/box2d/impulse_report.h"

#include <algorithm>
#include <span>

#include "ribbon/box2d/fixture_shapes.h"

namespace ribbon::box2d {
namespace {

/// The normal of a contact is from the cord's link to a circle, but from an edge to the cord's point.
TouchImpulse impulse_of(const Touch& touch) {
  const Vec2 normal = is_edge(touch.other) ? -touch.normal : touch.normal;
  return {touch.point, normal, dot(touch.push, normal), dot(touch.push, perp(normal)), touch.push};
}

}  // namespace

void report_impulses(CordTable& cords, const FixtureIds& fixtures, ContactListener& listener,
                     std::vector<TouchImpulse>& memory) {
  for (const CoupledCord& cord : cords.active()) {
    if (!cord.is_direct() || !cord.enabled || cord.direct().is_asleep()) continue;
    const std::span<const Touch> touches = cord.direct().touches();
    for (auto first = touches.begin(); first != touches.end();) {
      const std::uint64_t number = fixture_of(first->other);
      const auto last = std::find_if(first, touches.end(),
                                     [number](const Touch& touch) { return fixture_of(touch.other) != number; });
      memory.clear();
      for (auto touch = first; touch != last; ++touch) memory.push_back(impulse_of(*touch));
      first = last;
      const b2Fixture* const fixture = fixtures.fixture(number);
      if (fixture != nullptr) listener.post_solve(cord.id, *fixture, memory);
    }
  }
}

}  // namespace ribbon::box2d
