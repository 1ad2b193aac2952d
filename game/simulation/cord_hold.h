#pragma once

#include <box2d/box2d.h>

#include <optional>

#include "game/simulation/player_tuning.h"
#include "ribbon/box2d/coupling.h"
#include "ribbon/box2d/state_hash.h"
#include "ribbon/vec2.h"

namespace game {

/// The hold of a player's hands on a cord that is not its line: catching it, climbing along it, and letting go.
class CordHold {
 public:
  /// `grabs`: the button to catch is down. `hand`: the position of the hand, m.
  void begin_tick(bool grabs, ribbon::Vec2 hand, const ribbon::box2d::Coupling& coupling, const PlayerTuning& tuning);

  /// Returns whether a cord is held.
  bool is_valid(const ribbon::box2d::Coupling& coupling) const {
    return grip_id_ && coupling.grip(*grip_id_).is_valid();
  }
  /// Returns the held place. Precondition: is_valid().
  ribbon::box2d::CordPoint place(const ribbon::box2d::Coupling& coupling) const;
  /// The held point relative to the centre of the body, m.
  ribbon::Vec2 grip() const { return grip_; }
  bool is_climbing() const { return climbs_; }

  /// Returns whether the button was up since the last release.
  bool may_catch() const { return may_catch_; }
  /// The button has to be up before the next catch.
  void wait_for_button() { may_catch_ = false; }
  /// The cord that was released last, until it may be caught again.
  const std::optional<ribbon::box2d::CordId>& left_cord() const { return left_cord_; }
  /// Catches a cord at a place.
  void take(const ribbon::box2d::CordPoint& place, b2Body& body, ribbon::box2d::Coupling& coupling);
  /// One tick of hanging: the held position moves towards the hand, and up (1) and down (−1) climb. Returns the place
  /// from which the player hangs, m; nothing, and does nothing, if the cord was pulled out of the hand.
  std::optional<ribbon::Vec2> hang(const ribbon::box2d::CordPoint& held, int climb, const b2Body& body,
                                   ribbon::box2d::Coupling& coupling, const PlayerTuning& tuning);
  /// Lets go of what is held: `held`, if the player holds it.
  void release(const std::optional<ribbon::box2d::CordPoint>& held, ribbon::box2d::Coupling& coupling);
  /// Remembers a cord that the hand has let go of. It flies on beside the hand, which reaches for another one.
  void leave(ribbon::box2d::CordId cord);
  /// Forgets the hold, which something else has released, and the cord that was left.
  void forget();

  // In two parts: the hash of a player has others between them.
  void add_release_to(ribbon::box2d::Hasher& hasher) const;
  void add_grip_to(ribbon::box2d::Hasher& hasher) const;

 private:
  void forget_left_cord(ribbon::Vec2 hand, const ribbon::box2d::Coupling& coupling, const PlayerTuning& tuning);
  void climb(int direction, const ribbon::box2d::CordPoint& held, ribbon::box2d::Coupling& coupling,
             const PlayerTuning& tuning);

  std::optional<ribbon::box2d::GripId> grip_id_;
  bool can_climb_ = true;  // the held cord is one of the direct solver
  bool may_catch_ = true;  // false from a release until the grab button was up
  std::optional<ribbon::box2d::CordId> left_cord_;
  int ticks_since_left_ = 0;
  bool climbs_ = false;
  ribbon::Vec2 grip_{};  // m, the held point relative to the centre of the body; moves towards the hand
};

}  // namespace game
