#pragma once

#include <box2d/box2d.h>

#include <optional>

#include "game/simulation/player_tuning.h"
#include "ribbon/box2d/coupling.h"
#include "ribbon/box2d/state_hash.h"

namespace game {

/// How a player stands, runs and jumps.
class Legs {
 public:
  /// Detects ground from the contacts of the world's last step; the next begin_tick() uses the result instead of its
  /// own.
  void detect_ground(const b2Body& body, const ribbon::box2d::Coupling& coupling, const PlayerTuning& tuning);
  /// Updates what the player stands on. `jump`: its key was pressed in this tick.
  void begin_tick(bool jump, b2Body& body, const ribbon::box2d::Coupling& coupling, const PlayerTuning& tuning);

  /// Runs in a direction, 1, −1 or 0, and jumps if that was wanted and is possible. `holds_jump`: its key is down.
  void move(int direction, bool holds_jump, b2Body& body, const PlayerTuning& tuning, double dt);
  /// Jumps off a cord: adds hop_speed to the velocity of the swing.
  void hop(b2Body& body, const PlayerTuning& tuning);
  /// Jumps off a ledge from which the player hangs.
  void jump_off_ledge(b2Body& body, const PlayerTuning& tuning);
  /// Declares that the player has just let go of a cord: a jump now is one off it.
  void leave_cord();

  bool is_on_ground() const { return ticks_off_ground_ == 0; }
  /// Returns whether the player stands on level static ground.
  bool is_on_firm_ground() const { return on_firm_ground_; }

  // In two parts: the hash of a player has others between them.
  void add_times_to(ribbon::box2d::Hasher& hasher) const;
  void add_ground_to(ribbon::box2d::Hasher& hasher) const;

 private:
  static constexpr int long_ago = 1'000'000;  // ticks

  void stay_low(b2Body& body, const PlayerTuning& tuning) const;
  void run(int direction, b2Body& body, const PlayerTuning& tuning, double dt) const;
  void jump_if_possible(b2Body& body, const PlayerTuning& tuning);
  void cut_jump(bool key_is_down, b2Body& body, const PlayerTuning& tuning);

  std::optional<bool> detected_ground_;  // since the last tick began
  bool on_firm_ground_ = false;
  double speed_up_before_ = 0.0;  // m/s, upwards, in the last tick
  bool was_on_cord_ = false;      // it stands on a cord, or stood on one last
  double ground_rise_ = 0.0;      // m/s, upwards, of what the player stands on
  int ticks_off_ground_ = 0;
  int ticks_since_jump_pressed_ = long_ago;
  int ticks_since_release_ = long_ago;  // of a cord
  int ticks_since_jump_ = long_ago;
  bool jump_can_be_cut_ = false;  // it rises from a body
};

}  // namespace game
