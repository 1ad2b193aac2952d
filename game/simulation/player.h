#pragma once

#include <box2d/box2d.h>

#include <cstddef>
#include <cstdint>
#include <optional>

#include "game/simulation/area.h"
#include "game/simulation/ledge.h"
#include "game/simulation/lines.h"
#include "game/simulation/player_tuning.h"
#include "game/simulation/target.h"
#include "ribbon/box2d/coupling.h"
#include "ribbon/box2d/state_hash.h"
#include "ribbon/vec2.h"

namespace game {

/// The player: a Box2D body, its lines, and the state of its controls.
class Player {
 public:
  /// `feet`: the middle of the soles, m.
  /// `lines`: how many it can hold at once, 1 … Lines::most.
  Player(b2World& world, ribbon::Vec2 feet, const PlayerTuning& tuning = {}, std::size_t lines = 1,
         const LineTuning& line_tuning = {});

  /// Applies the buttons of one tick (game/simulation/buttons.h): run, jump, catch, climb, pump, release, and use the
  /// lines.
  void apply(std::uint16_t buttons, const Targets& targets, ribbon::box2d::Coupling& coupling, double dt);
  /// Lets go of lines that were cut. Call it after each tick in which something can cut.
  void follow_cuts(ribbon::box2d::Coupling& coupling) { lines_.follow_cuts(coupling); }
  /// Detects ground from the contacts of the world's last step; the next apply() uses the result instead of its own.
  /// For callers that step the world several times per tick.
  void detect_ground(const ribbon::box2d::Coupling& coupling);
  /// Declares which buttons are down already: they are no presses in the next apply().
  void hold_buttons(std::uint16_t buttons) { buttons_before_ = buttons; }
  /// Releases everything and places the player at rest at `feet`, m.
  void put(ribbon::Vec2 feet, ribbon::box2d::Coupling& coupling);

  /// Declares that the body also holds a cord at its waist, by this grip. The player never catches or releases it,
  /// except in put().
  void set_tether(ribbon::box2d::GripId grip) { tether_ = grip; }
  /// Returns the place of a cord or line that the player holds in its hand; not of the tether.
  std::optional<ribbon::box2d::CordPoint> held_place(const ribbon::box2d::Coupling& coupling) const;

  b2Body& body() { return *body_; }
  const b2Body& body() const { return *body_; }
  ribbon::Vec2 position() const;  ///< m, the centre of the body
  /// Returns whether the body overlaps the area.
  bool touches(const Area& area) const;
  ribbon::Vec2 hand() const;                   ///< m, the target of a held cord point
  ribbon::Vec2 grip() const { return grip_; }  ///< m, the held point relative to the centre of the body
  const Line& line() const { return lines_.first(); }
  const Lines& lines() const { return lines_; }
  /// The edge of the ledge from which it hangs.
  const std::optional<Ledge>& ledge() const { return ledge_; }
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
  void stay_low();
  void update_ground(const ribbon::box2d::Coupling& coupling);
  void handle_lines(const Command& command, const Targets& targets, ribbon::box2d::Coupling& coupling, double dt);
  void run(int direction, double dt);
  void jump_if_possible();
  void cut_jump(bool key_is_down);
  bool catch_cord(ribbon::box2d::Coupling& coupling);
  bool catch_ledge();
  void leave_ledge();
  void hang_from_ledge(const Command& command, double dt);
  void hang(const Command& command, ribbon::box2d::Coupling& coupling, double dt);
  void climb(int direction, const ribbon::box2d::CordPoint& held, ribbon::box2d::Coupling& coupling);
  void pump(ribbon::Vec2 from, double dt);
  void release_cord(ribbon::box2d::Coupling& coupling);
  void leave(ribbon::box2d::CordId cord);
  void forget_left_cord(const ribbon::box2d::Coupling& coupling);
  void hop();

  PlayerTuning tuning_;
  b2Body* body_;
  Lines lines_;
  std::optional<Ledge> ledge_;
  std::optional<ribbon::box2d::GripId> grip_id_;  // of the held cord, not of a line
  std::optional<ribbon::box2d::GripId> tether_;   // of the rope at the waist; it stays with a piece of a cut one
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
