#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ribbon/cord.h"
#include "tests/support/coupled_world.h"

namespace peers {

/// Builds a scene in a world, independent of the engine.
using SetUp = std::function<void(test_support::CoupledWorld&)>;

/// A rigid body with at most one shape, of a kind that every engine has.
struct BodyPlan {
  bool dynamic = false;
  ribbon::Vec2 position;
  double angle = 0.0;
  double mass = 0.0;                                           ///< kg; 0 for a static body, as is the inertia
  double inertia = 0.0;                                        ///< kg·m², about its position
  double friction = 0.0;                                       ///< coefficient of its shape
  double radius = 0.0;                                         ///< m: of a circle, or around a link's middle line
  double half_length = 0.0;                                    ///< m: above 0 for a link of a cord, along its own x
  std::vector<std::pair<ribbon::Vec2, ribbon::Vec2>> edges{};  ///< static
};

/// A revolute joint of two bodies, given by their indices in the plan.
struct HingePlan {
  int a = 0;
  int b = 0;
  ribbon::Vec2 place;
};

/// A cord as a user declares it, and the bodies that replace it in engines without cords.
struct CordPlan {
  ribbon::CordDef def;
  std::vector<int> links{};                 ///< bodies, from its first point on; empty for a ribbon
  std::vector<std::pair<int, int>> held{};  ///< a point and the body that holds it; `def` has the pins
};

/// A scene in a form for any engine. It has ropes both as cords and as chains of hinged links with the same masses at
/// the same places.
struct Plan {
  ribbon::Vec2 gravity;    ///< m/s²
  int settling_ticks = 0;  ///< at the start; after each, all velocities are reduced by a tenth
  int ticks = 0;           ///< after these; timed and judged
  std::vector<BodyPlan> bodies{};
  std::vector<HingePlan> hinges{};
  std::vector<CordPlan> cords{};

  /// Returns the indices of the moving bodies that are not links, in order.
  std::vector<int> moving_bodies() const;
};

/// Returns the bodies of a CoupledWorld that correspond to the moving_bodies of its scene's plan, in order.
std::vector<b2Body*> moving_bodies_of(b2World& world);

/// Returns the plan of what the set-up builds. Throws std::invalid_argument for a shape that a BodyPlan cannot
/// represent.
Plan plan_of(const SetUp& set_up, int settling_ticks, int ticks);

/// Returns the plan as JSON, the input of tests/peers/*.mjs.
std::string to_json(const Plan& plan);

}  // namespace peers
