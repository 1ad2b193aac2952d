#pragma once

#include <box2d/box2d.h>

#include <optional>

#include "game/simulation/target.h"
#include "ribbon/box2d/coupling.h"
#include "ribbon/box2d/state_hash.h"
#include "ribbon/cord_def.h"
#include "ribbon/vec2.h"

namespace game {

/// The parameters of the player's line. It is elastic, so that it stores the energy of a fall and returns it.
struct LineTuning {
  double throw_range = 10.0;          ///< m, from the hand to a hook
  double flight_speed = 40.0;         ///< m/s, of its end when it is thrown
  double min_length = 1.0;            ///< m, by reeling in
  double max_length = 14.0;           ///< m, by reeling out
  double reel_in_speed = 2.5;         ///< m/s
  double reel_out_speed = 4.0;        ///< m/s
  double stretch_stiffness = 6000.0;  ///< N: a player of 60 kg stretches it by a tenth
  double mass_per_length = 0.05;      ///< kg/m
  double radius = 0.03;               ///< m
  double damping = 0.03;              ///< s
  int points = 21;
  /// Of the solver. A line is elastic and light, and a player of a thousand times its mass bounces on it: with one
  /// substep it is up to 11 cm from the converged motion (tests/baseline/levels.csv has what it is now).
  ribbon::Accuracy accuracy = {.substeps = 4};
};

/// A line in a hand of the player: it is thrown at a target, held, reeled in and out, and released. Then it hangs at
/// the target until the next throw. Its cord meets scenery and bodies, so that it wraps around corners.
class Line {
 public:
  enum class State : unsigned char { stowed, flying, held, released };

  explicit Line(const LineTuning& tuning = {}) : tuning_(tuning) {}

  State state() const { return state_; }
  /// The position of the end of a flying line in m. `hand`: the position of the hand, m.
  ribbon::Vec2 tip(ribbon::Vec2 hand) const;
  ribbon::Vec2 end() const { return target_.place(); }  ///< m, where the last throw fixes it
  bool is_held() const { return state_ == State::held; }
  /// Returns the place that a held line is held at; nothing in another state.
  std::optional<ribbon::box2d::CordPoint> held_place(const ribbon::box2d::Coupling& coupling) const;
  /// The cord of the line; nothing before the first throw.
  std::optional<ribbon::box2d::CordId> cord() const { return cord_; }
  /// Whether the cord was made in the last tick.
  bool is_new() const { return is_new_; }
  /// The rest length in m of a line that is held or released.
  double length() const { return length_; }
  const LineTuning& tuning() const { return tuning_; }

  /// Throws the line, in any state, at a target within the throw range of `hand`.
  void throw_at(const Target& target, ribbon::Vec2 hand, double dt);
  /// Returns whether a flying line arrives in this tick.
  bool arrives() const { return state_ == State::flying && ticks_left_ <= 1; }
  /// Advances a flying line by one tick. When it arrives, `body` holds it at `hand` (m, in the frame of the body).
  /// Returns whether it arrived.
  bool fly(ribbon::box2d::Coupling& coupling, b2Body& body, ribbon::Vec2 hand);
  /// Reels a held line: −1 in, 1 out, 0 not.
  void reel(int direction, ribbon::box2d::Coupling& coupling, double dt);
  /// Releases a held line or cancels a throw. Returns false if there is neither.
  bool release(ribbon::box2d::Coupling& coupling);
  /// Lets go of a line that is held, for good: the cord stays where it is fixed, and another throw makes a new one.
  /// Returns the cord. Precondition: is_held().
  ribbon::box2d::CordId leave(ribbon::box2d::Coupling& coupling);
  /// Does so with a line in any state that has a cord, and keeps the cord as it moves, with all that others hold of it.
  /// A throw goes on. The cord may have been cut: its id is returned, and the pieces stay.
  ribbon::box2d::CordId hand_over(ribbon::box2d::Coupling& coupling);
  /// Updates the state after something else removed the grip. Call it first in each tick.
  void follow(ribbon::box2d::Coupling& coupling);

  void add_to(ribbon::box2d::Hasher& hasher) const;

 private:
  void put_cord(ribbon::Cord cord, ribbon::box2d::Coupling& coupling);
  void set_released(ribbon::box2d::Coupling& coupling);

  LineTuning tuning_;
  State state_ = State::stowed;
  Target target_;
  int flight_ticks_ = 0;
  int ticks_left_ = 0;
  double length_ = 0.0;
  bool is_new_ = false;
  std::optional<ribbon::box2d::CordId> cord_;
  std::optional<ribbon::box2d::GripId> grip_;
};

}  // namespace game
