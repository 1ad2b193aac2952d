#pragma once

#include <box2d/box2d.h>

#include <cstdint>
#include <optional>

#include "game/simulation/area.h"
#include "game/simulation/line.h"
#include "ribbon/box2d/coupling.h"
#include "ribbon/box2d/state_hash.h"
#include "ribbon/vec2.h"

namespace game {

/// The player's Box2D collision category. Cords do not collide with the player unless they are solid.
inline constexpr std::uint16_t player_category = 0x0002;

/// The parameters of the player's motion. Ticks are 1/60 s.
struct PlayerTuning {
  double radius = 0.3;                ///< m, of feet and head
  double height = 1.5;                ///< m
  double mass = 60.0;                 ///< kg, unless the level sets it
  double run_speed = 6.0;             ///< m/s
  double ground_acceleration = 40.0;  ///< m/s², towards the run speed
  double air_acceleration = 9.0;      ///< m/s², in the air; never reduces the speed gained by a swing
  double jump_speed = 6.5;            ///< m/s, upwards: 2.1 m high
  double cut_speed = 2.5;             ///< m/s, upwards, of a jump whose key is let go: from 0.3 m high on
  double sinking_speed = -0.5;        ///< m/s, vertical; below it the player does not stand on a cord yet
  double bounce_fraction = 0.8;       ///< of jump_speed, added to the velocity on a bouncing surface
  double pump_acceleration = 8.0;     ///< m/s², across the cord while hanging
  int pump_ticks = 30;                ///< after a press of left or right; a key that is held gives no more
  double grab_range = 1.0;            ///< m, from the hand to a cord
  double max_arm_length = 1.2;        ///< m, from the hand to a held point that is pulled away; beyond it is released
  double pull_in = 0.25;              ///< fraction of the distance from the held point to the hand, per tick
  double climb_speed = 1.8;           ///< m/s, up a cord
  double slide_speed = 4.0;           ///< m/s, down a cord
  double top_margin = 0.5;            ///< m along the cord, from its pin to the end of a climb
  double hop_speed = 2.5;             ///< m/s, upwards, added when the player jumps off a cord
  double hand_height = 0.95;          ///< m above the centre of the body
  double ground_slope = 0.5;          ///< min. upward component of the normal of ground
  int coyote_ticks = 6;               ///< a jump is possible this long after leaving the ground
  int jump_buffer_ticks = 6;          ///< a jump is remembered this long before landing
  int jump_pause_ticks = 20;          ///< min. pause between two jumps, so that a bounce is used once
  int hop_ticks = 6;                  ///< a jump this long after releasing a cord is a jump off the cord
  int forget_ticks = 30;              ///< a cord that was released is not caught this long, unless the hand was
  double forget_distance = 1.5;       ///< m, away from it
  double step_speed = 1.0;            ///< m/s, upwards, at which the player leaves ground without a jump, at most
};

/// The player: a Box2D body, its line, and the state of its controls.
class Player {
 public:
  /// `feet`: the middle of the soles, m.
  Player(b2World& world, ribbon::Vec2 feet, const PlayerTuning& tuning = {}, const LineTuning& line_tuning = {});

  /// Applies the buttons of one tick (game/simulation/buttons.h): run, jump, catch, climb, pump, release, and use the
  /// line. `aim`: the hook for a throw, m.
  void apply(std::uint16_t buttons, std::optional<ribbon::Vec2> aim, ribbon::box2d::Coupling& coupling, double dt);
  /// Detects ground from the contacts of the world's last step; the next apply() uses the result instead of its own.
  /// For callers that step the world several times per tick.
  void detect_ground(const ribbon::box2d::Coupling& coupling);
  /// Releases everything and places the player at rest at `feet`, m.
  void put(ribbon::Vec2 feet, ribbon::box2d::Coupling& coupling);

  /// Declares that the body also holds an end of this cord at its waist. The player never catches or releases it,
  /// except in put().
  void set_tether(ribbon::box2d::CordId cord) { tether_ = cord; }
  /// Returns the place of a cord or line that the player holds in its hand; not of the tether.
  std::optional<ribbon::box2d::CordPoint> held_place(const ribbon::box2d::Coupling& coupling) const;

  b2Body& body() { return *body_; }
  const b2Body& body() const { return *body_; }
  ribbon::Vec2 position() const;  ///< m, the centre of the body
  /// Returns whether the body overlaps the area.
  bool touches(const Area& area) const;
  ribbon::Vec2 hand() const;                   ///< m, the target of a held cord point
  ribbon::Vec2 grip() const { return grip_; }  ///< m, the held point relative to the centre of the body
  const Line& line() const { return line_; }
  bool is_on_ground() const { return ticks_off_ground_ == 0; }
  /// Returns whether the player stands on level static ground.
  bool is_on_firm_ground() const { return on_firm_ground_; }
  bool is_climbing() const { return climbs_; }
  bool faces_left() const { return faces_left_; }
  const PlayerTuning& tuning() const { return tuning_; }
  /// Changes the parameters; size and mass of the body stay. Recordings do not include it.
  void set_tuning(const PlayerTuning& tuning) { tuning_ = tuning; }

  void add_to(ribbon::box2d::Hasher& hasher) const;

 private:
  struct Command;

  bool holds_cord(const ribbon::box2d::Coupling& coupling) const;
  std::optional<double> rise_of_cord_below(const ribbon::box2d::Coupling& coupling) const;
  void stay_low();
  void update_ground(const ribbon::box2d::Coupling& coupling);
  void handle_line(const Command& command, std::optional<ribbon::Vec2> aim, ribbon::box2d::Coupling& coupling,
                   double dt);
  void run(int direction, double dt);
  void jump_if_possible();
  void cut_jump(bool key_is_down);
  void catch_cord(ribbon::box2d::Coupling& coupling);
  void hang(const Command& command, ribbon::box2d::Coupling& coupling, double dt);
  void climb(int direction, const ribbon::box2d::CordPoint& held, ribbon::box2d::Coupling& coupling);
  void pump(ribbon::Vec2 from, double dt);
  void release_cord(ribbon::box2d::Coupling& coupling);
  void leave(ribbon::box2d::CordId cord);
  void forget_left_cord(const ribbon::box2d::Coupling& coupling);
  void hop();

  PlayerTuning tuning_;
  b2Body* body_;
  Line line_;
  std::optional<ribbon::box2d::GripId> grip_id_;  // of the held cord, not of the line
  std::optional<ribbon::box2d::CordId> tether_;   // held at the waist too
  int direction_ = 0;                             // 1 right, −1 left, in the last tick
  int pump_ticks_left_ = 0;
  bool can_climb_ = true;                // the held cord is one of the direct solver
  std::optional<bool> detected_ground_;  // since the last apply
  bool on_firm_ground_ = false;
  double speed_up_before_ = 0.0;  // m/s, upwards, in the last tick
  bool was_on_cord_ = false;      // it stands on a cord, or stood on one last
  double ground_rise_ = 0.0;      // m/s, upwards, of what the player stands on
  int ticks_off_ground_ = 0;
  int ticks_since_jump_pressed_;
  int ticks_since_release_;
  int ticks_since_jump_;
  bool jump_can_be_cut_ = false;  // it rises from a body
  std::uint16_t buttons_before_ = 0;
  bool may_catch_ = true;                           // false from a release until the grab button was up
  std::optional<ribbon::box2d::CordId> left_cord_;  // the cord that was released last, until it may be caught again
  int ticks_since_left_ = 0;
  bool faces_left_ = false;
  bool climbs_ = false;
  ribbon::Vec2 grip_{};  // m, the held point relative to the centre of the body; moves towards the hand
};

}  // namespace game
