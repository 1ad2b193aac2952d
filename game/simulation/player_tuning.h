#pragma once

#include <cstdint>

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
  double ledge_reach = 0.4;           ///< m, from the hand to the edge of a ledge that it catches
  double ledge_speed = 3.0;           ///< m/s, at which it moves below a ledge that it has caught
  double step_speed = 1.0;            ///< m/s, upwards, at which the player leaves ground without a jump, at most
};

}  // namespace game
