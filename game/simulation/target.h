#pragma once

#include <box2d/box2d.h>

#include <cstddef>
#include <optional>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/coupling_types.h"
#include "ribbon/vec2.h"

namespace game {

/// A place to which a line can be fixed: a hook of the level, or a place on a sticky body.
struct Target {
  ribbon::Vec2 at;                    ///< m, of a hook or on a static body
  b2Body* body = nullptr;             ///< a body that moves, which takes the place along
  b2Vec2 local{0.0F, 0.0F};           ///< m, the place in the frame of this body
  std::optional<std::size_t> hook{};  ///< index in Level::hooks

  /// Returns where the place is now, m.
  ribbon::Vec2 place() const { return body != nullptr ? ribbon::box2d::to_double(body->GetWorldPoint(local)) : at; }
};

/// What a player's lines can be fixed to in a tick.
struct Targets {
  std::optional<Target> thrown;   ///< by a throw
  std::optional<Target> at_hand;  ///< by a knot: within reach of the hand
  /// The cord that the other player holds in its hand.
  std::optional<ribbon::box2d::CordId> shared;
};

}  // namespace game
