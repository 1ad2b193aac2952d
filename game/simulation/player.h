#pragma once

#include <box2d/box2d.h>

#include <cstdint>
#include <optional>

#include "game/simulation/line.h"
#include "ribbon/box2d/coupling.h"
#include "ribbon/box2d/state_hash.h"
#include "ribbon/vec2.h"

namespace game {

/// The player's Box2D collision category: cords do not bump into players, who hold them instead.
inline constexpr std::uint16_t player_category = 0x0002;

/// How the player moves: change these to change the feel. Ticks are 1/60 s.
struct PlayerTuning {
  double radius = 0.3;          ///< m, of feet and head
  double height = 1.5;          ///< m
  double mass = 60.0;           ///< kg, unless the level has its own
  double run_speed = 6.0;       ///< m/s
  double ground_gain = 40.0;    ///< m/s², towards the run speed
  double air_gain = 9.0;        ///< m/s², in the air, and only to gain speed, never to lose what a swing gave
  double jump_speed = 6.5;      ///< m/s, upwards: 2.1 m high
  double sinking_speed = -0.5;  ///< m/s, on a cord; who sinks in faster does not stand yet
  double spring_share = 0.5;    ///< of the jump's speed, added to what a trampoline gives
  double pump_gain = 4.5;       ///< m/s², across the cord while hanging
  double reach = 1.0;           ///< m, from the hand to the cord it can catch
  double longest_arm = 1.2;     ///< m, from the hand to a held point that something else pulls away
  double pull_in = 0.25;        ///< share of the way from where it caught the cord to the hand, a tick
  double climb_speed = 1.8;     ///< m/s, up a cord
  double slide_speed = 4.0;     ///< m/s, down it
  double top_margin = 0.5;      ///< m along the cord, from what it is fixed to, where climbing ends
  double hop_speed = 2.5;       ///< m/s, upwards, more for who jumps off a cord
  double hand_height = 0.95;    ///< m above the middle of the body
  double ground_slope = 0.5;    ///< least upward part of the normal of what counts as ground
  int coyote_ticks = 6;         ///< a jump still counts this long after the ground was left
  int jump_buffer_ticks = 6;    ///< and this long before it is reached
  int jump_pause_ticks = 20;    ///< between two jumps at the least: what throws one up would take several
  int hop_ticks = 6;            ///< a jump this long after letting go is one off the cord
};

/// The player: a Box2D body, and what the hands and feet remember.
class Player {
 public:
  /// `feet` is the middle of the soles, m.
  Player(b2World& world, ribbon::Vec2 feet, const PlayerTuning& tuning = {}, const LineTuning& line_tuning = {});

  /// One tick's buttons (game/simulation/buttons.h): run, jump, catch, climb, pump, let go, and what the line does;
  /// thrown, it goes for the hook at `aim` [m].
  void apply(std::uint16_t buttons, std::optional<ribbon::Vec2> aim, ribbon::box2d::Coupling& coupling, double dt);
  /// Feels for ground by the world's last step, as the next apply does else: for who steps the world several times a
  /// tick, and has the player feel what a single step would have found.
  void feel_ground(const ribbon::box2d::Coupling& coupling);
  /// Lets go of everything and stands still at `feet` [m].
  void put(ribbon::Vec2 feet, ribbon::box2d::Coupling& coupling);

  b2Body& body() { return *body_; }
  const b2Body& body() const { return *body_; }
  ribbon::Vec2 position() const;               ///< m, the middle of the body
  ribbon::Vec2 hand() const;                   ///< m, where a held cord point ends up
  ribbon::Vec2 grip() const { return grip_; }  ///< m, the held point as seen from the middle of the body
  const Line& line() const { return line_; }
  bool is_on_ground() const { return ticks_off_ground_ == 0; }
  /// On what does not move, and level, since the last step.
  bool is_on_firm_ground() const { return on_firm_ground_; }
  bool is_climbing() const { return climbs_; }
  bool faces_left() const { return faces_left_; }
  const PlayerTuning& tuning() const { return tuning_; }
  /// Moves otherwise from now on; size and mass of the body stay. No recording has it.
  void set_tuning(const PlayerTuning& tuning) { tuning_ = tuning; }

  void add_to(ribbon::box2d::Hasher& hasher) const;

 private:
  struct Wish;

  bool holds_cord(const ribbon::box2d::Coupling& coupling) const;
  bool stands_on_cord(const ribbon::box2d::Coupling& coupling) const;
  void feel_feet(const ribbon::box2d::Coupling& coupling);
  void handle_line(const Wish& wish, std::optional<ribbon::Vec2> aim, ribbon::box2d::Coupling& coupling, double dt);
  void run(int direction, double dt);
  void jump_if_wanted();
  void catch_cord(ribbon::box2d::Coupling& coupling);
  void hang(const Wish& wish, ribbon::box2d::Coupling& coupling, double dt);
  void climb(int direction, const ribbon::box2d::CordPoint& held, ribbon::box2d::Coupling& coupling);
  void pump(int direction, ribbon::Vec2 from, double dt);
  void let_go(ribbon::box2d::Coupling& coupling);
  void hop();

  PlayerTuning tuning_;
  b2Body* body_;
  Line line_;
  std::optional<ribbon::box2d::GripId> grip_id_;  // of the held cord, which is not the line
  bool can_climb_ = true;                         // the held cord is of the direct solver
  std::optional<bool> feels_ground_;              // since the last apply
  bool on_firm_ground_ = false;
  int ticks_off_ground_ = 0;
  int ticks_since_jump_wanted_;
  int ticks_since_let_go_;
  int ticks_since_jump_;
  std::uint16_t buttons_before_ = 0;
  bool wants_to_catch_ = true;  // false from letting go until the grab button was up
  bool faces_left_ = false;
  bool climbs_ = false;
  ribbon::Vec2 grip_{};  // m, the held point as seen from the middle of the body; on its way to the hand
};

}  // namespace game
