#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ribbon/cord.h"
#include "tests/support/coupled_world.h"

namespace peers {

/// What a scene puts into a world, for whichever engine plays it.
using SetUp = std::function<void(test_support::CoupledWorld&)>;

/// A rigid body, of a shape that every engine has. At most one of the shapes is there.
struct BodyPlan {
  bool dynamic = false;
  ribbon::Vec2 position;
  double angle = 0.0;
  double mass = 0.0;                                           ///< kg; 0 if it is static, as is the next
  double inertia = 0.0;                                        ///< kg·m², about its position
  double friction = 0.0;                                       ///< of its shape
  double radius = 0.0;                                         ///< m: of a circle, or around a link's middle line
  double half_length = 0.0;                                    ///< m: above 0 it is a link of a cord, along its own x
  std::vector<std::pair<ribbon::Vec2, ribbon::Vec2>> edges{};  ///< static
};

/// Two bodies, by their places in the plan, that share a point for good.
struct HingePlan {
  int a = 0;
  int b = 0;
  ribbon::Vec2 place;
};

/// A cord as a user declares it, and what stands for it where there are bodies alone.
struct CordPlan {
  ribbon::CordDef def;
  std::vector<int> links{};                 ///< bodies, from its first point on; none of a ribbon's
  std::vector<std::pair<int, int>> held{};  ///< a point and the body that holds it; pins are in `def`
};

/// A scene in a form for any engine: ropes are given as cords, and as chains of hinged links with the same masses at
/// the same places.
struct Plan {
  ribbon::Vec2 gravity;  ///< m/s²
  int calm_ticks = 0;    ///< at the start, after each of which all that moves loses a tenth of its velocity
  int ticks = 0;         ///< after them, which are timed and judged
  std::vector<BodyPlan> bodies{};
  std::vector<HingePlan> hinges{};
  std::vector<CordPlan> cords{};

  /// Of the bodies, in their order, those that move and are no links.
  std::vector<int> movers() const;
};

/// The bodies of a CoupledWorld's, made by any method, that the plan of its scene has as movers, in their order.
std::vector<b2Body*> movers_of(b2World& world);

/// What the set-up makes, read from a world of it. Throws std::invalid_argument if there is a shape in it that a
/// BodyPlan has no place for.
Plan plan_of(const SetUp& set_up, int calm_ticks, int ticks);

/// As JSON, which the players in tests/peers/*.mjs read.
std::string to_json(const Plan& plan);

}  // namespace peers
