#pragma once

#include <box2d/box2d.h>

#include <cstddef>
#include <cstdint>
#include <optional>

#include "game/simulation/area.h"
#include "game/simulation/cord_hold.h"
#include "game/simulation/ledge.h"
#include "game/simulation/legs.h"
#include "game/simulation/lines.h"
#include "game/simulation/player_tuning.h"
#include "game/simulation/pump.h"
#include "game/simulation/target.h"
#include "ribbon/box2d/coupling.h"
#include "ribbon/box2d/state_hash.h"
#include "ribbon/vec2.h"

namespace game {

/// The player: a Box2D body with legs, hands that hold a cord or a ledge, and lines.
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
  void detect_ground(const ribbon::box2d::Coupling& coupling) { legs_.detect_ground(*body_, coupling, tuning_); }
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
  ribbon::Vec2 hand() const;                          ///< m, the target of a held cord point
  ribbon::Vec2 grip() const { return hold_.grip(); }  ///< m, the held point relative to the centre of the body
  const Line& line() const { return lines_.first(); }
  const Lines& lines() const { return lines_; }
  /// The edge of the ledge from which it hangs.
  const std::optional<Ledge>& ledge() const { return ledge_; }
  bool is_on_ground() const { return legs_.is_on_ground(); }
  /// Returns whether the player stands on level static ground.
  bool is_on_firm_ground() const { return legs_.is_on_firm_ground(); }
  bool is_climbing() const { return hold_.is_climbing(); }
  bool faces_left() const { return faces_left_; }
  const PlayerTuning& tuning() const { return tuning_; }
  /// Changes the parameters; size and mass of the body stay. Recordings do not include it.
  void set_tuning(const PlayerTuning& tuning) { tuning_ = tuning; }

  void add_to(ribbon::box2d::Hasher& hasher) const;

 private:
  struct Command;

  void handle_lines(const Command& command, const Targets& targets, ribbon::box2d::Coupling& coupling, double dt);
  void stay_on_cord(const Command& command, ribbon::box2d::Coupling& coupling, double dt);
  bool catch_cord(ribbon::box2d::Coupling& coupling);
  bool catch_ledge();
  void leave_ledge();
  void hang_from_ledge(const Command& command, double dt);
  void release_cord(ribbon::box2d::Coupling& coupling);

  PlayerTuning tuning_;
  b2Body* body_;
  Legs legs_;
  CordHold hold_;
  Pump pump_;
  Lines lines_;
  std::optional<Ledge> ledge_;
  std::optional<ribbon::box2d::GripId> tether_;  // of the rope at the waist; it stays with a piece of a cut one
  std::uint16_t buttons_before_ = 0;
  bool faces_left_ = false;
};

}  // namespace game
