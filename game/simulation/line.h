#pragma once

#include <box2d/box2d.h>

#include <optional>

#include "ribbon/box2d/coupling.h"
#include "ribbon/box2d/state_hash.h"
#include "ribbon/vec2.h"

namespace game {

/// What the player's own line is like. It stretches, so that a fall into it is stored and given back.
struct LineTuning {
  double reach = 10.0;                ///< m, from the hand to a hook that it can be thrown at
  double flight_speed = 40.0;         ///< m/s, of its end on the way there
  double shortest = 1.0;              ///< m, to which it can be reeled in
  double longest = 14.0;              ///< m, and out
  double reel_in_speed = 2.5;         ///< m/s
  double reel_out_speed = 4.0;        ///< m/s
  double stretch_stiffness = 6000.0;  ///< N: a player of 60 kg stretches it by a tenth
  double mass_per_length = 0.05;      ///< kg/m
  double radius = 0.03;               ///< m
  double damping = 0.03;              ///< s
  int points = 21;
};

/// A line of the player's own: thrown at a hook, held, reeled in and out, let go. Then it stays where it hangs until
/// the next throw.
class Line {
 public:
  enum class State : unsigned char { stowed, flying, held, left };

  explicit Line(const LineTuning& tuning = {}) : tuning_(tuning) {}

  State state() const { return state_; }
  /// m, where the end of a line in flight is on its way from `hand`.
  ribbon::Vec2 tip(ribbon::Vec2 hand) const;
  ribbon::Vec2 hook() const { return hook_; }  ///< m, of the last throw
  /// Its place among the cords, from the first throw on.
  std::optional<ribbon::box2d::CordId> cord() const { return cord_; }
  /// Whether it was made in the last tick.
  bool is_new() const { return is_new_; }
  /// m at rest, of one that is held or left.
  double length() const { return length_; }
  const LineTuning& tuning() const { return tuning_; }

  /// Throws it, whatever it was doing, at a hook within reach of `hand`.
  void throw_at(ribbon::Vec2 hook, ribbon::Vec2 hand, double dt);
  /// True of one in flight that arrives in this tick.
  bool arrives() const { return state_ == State::flying && ticks_left_ <= 1; }
  /// A tick: one in flight flies on, and where it arrives `body` holds it at `hand`, m, in its own frame. True then.
  bool fly(ribbon::box2d::Coupling& coupling, b2Body& body, ribbon::Vec2 hand);
  /// Reels one that is held in (−1), out (1), or not at all (0).
  void reel(int direction, ribbon::box2d::Coupling& coupling, double dt);
  /// Lets go of it, or calls it back; false if it was out of hand already.
  bool let_go(ribbon::box2d::Coupling& coupling);
  /// Notices where the line has been taken from the hand. Before all else in a tick.
  void follow(ribbon::box2d::Coupling& coupling);

  void add_to(ribbon::box2d::Hasher& hasher) const;

 private:
  void leave(ribbon::box2d::Coupling& coupling);

  LineTuning tuning_;
  State state_ = State::stowed;
  ribbon::Vec2 hook_;
  int flight_ticks_ = 0;
  int ticks_left_ = 0;
  double length_ = 0.0;
  bool is_new_ = false;
  std::optional<ribbon::box2d::CordId> cord_;
  std::optional<ribbon::box2d::GripId> grip_;
};

}  // namespace game
