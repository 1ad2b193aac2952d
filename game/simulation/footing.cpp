#include "game/simulation/footing.h"

#include <algorithm>
#include <optional>

#include "game/simulation/nearest_point.h"
#include "ribbon/box2d/convert.h"

namespace game {
namespace {

using ribbon::box2d::Coupling;
using ribbon::box2d::to_double;

constexpr double firm_slope = 0.95;  // min. upward component of the normal of ground on which the player does not slide

void add_rise(Footing& footing, double rise) {
  footing.rise = footing.is_ground ? std::max(footing.rise, rise) : rise;
  footing.is_ground = true;
}

void add_bodies(Footing& footing, const b2Body& player, const PlayerTuning& tuning) {
  for (const b2ContactEdge* edge = player.GetContactList(); edge != nullptr; edge = edge->next) {
    const b2Fixture* a = edge->contact->GetFixtureA();
    const b2Fixture* b = edge->contact->GetFixtureB();
    if (!edge->contact->IsTouching() || a->IsSensor() || b->IsSensor()) continue;
    b2WorldManifold manifold;
    edge->contact->GetWorldManifold(&manifold);
    const bool is_b = b->GetBody() == &player;
    const double up = static_cast<double>(is_b ? manifold.normal.y : -manifold.normal.y);
    const b2Body* other = (is_b ? a : b)->GetBody();
    if (up > tuning.ground_slope) {
      add_rise(footing, static_cast<double>(other->GetLinearVelocityFromWorldPoint(manifold.points[0]).y));
    }
    footing.is_firm = footing.is_firm || (up > firm_slope && other->GetType() == b2_staticBody);
  }
}

/// Returns the upward speed [m/s] of a solid cord below the feet that has stopped the fall, or nothing.
std::optional<double> rise_of_cord_below(const b2Body& player, const Coupling& coupling, const PlayerTuning& tuning) {
  if (coupling.body(player).velocity().y < tuning.sinking_speed) return std::nullopt;
  const double soles = to_double(player.GetPosition()).y - 0.5 * tuning.height;
  for (const ribbon::box2d::CordId c : coupling.cords()) {
    for (const ribbon::box2d::FixtureTouch& touch : coupling.cord(c).touching()) {
      const b2Fixture* fixture = coupling.fixture(touch.fixture);
      if (fixture == nullptr || fixture->GetBody() != &player || touch.impulse <= 0.0) continue;
      if (touch.point.y >= soles + tuning.radius) continue;
      const ribbon::box2d::CordView cord = coupling.cord(c);
      const auto velocities =
          cord.solver() == ribbon::box2d::Solver::direct ? cord.direct().velocities() : cord.thesis().velocities();
      return velocities[nearest_point(cord.positions(), touch.point)].y;
    }
  }
  return std::nullopt;
}

}  // namespace

Footing find_footing(const b2Body& player, const Coupling& coupling, const PlayerTuning& tuning) {
  Footing footing;
  add_bodies(footing, player, tuning);
  const std::optional<double> rise = rise_of_cord_below(player, coupling, tuning);
  footing.is_cord = rise.has_value();
  if (rise) add_rise(footing, *rise);
  return footing;
}

}  // namespace game
