#pragma once

#include <box2d/box2d.h>

#include <array>
#include <span>

#include "game/simulation/player.h"
#include "ribbon/box2d/coupling.h"
#include "ribbon/box2d/state_hash.h"

namespace game {

/// The rope between two players: a cord of the level whose ends they hold at the waist. It is inextensible, unless the
/// level says otherwise, and meets what cords meet, so never a player.
class Tether {
 public:
  static constexpr double min_length = 1.0;     ///< m, by reeling in
  static constexpr double reel_in_speed = 1.5;  ///< m/s
  static constexpr double reel_out_speed = 3.0;
  static constexpr double max_pull = 3000.0;    ///< N, of the cord at a player, above which it is not reeled in
  static constexpr double foot_friction = 1.0;  ///< of a tied player that stands still: it bears a pull of its weight
  static constexpr double max_gap = 0.5;        ///< m, from an end of the cord to the waist that holds it

  /// Ties both players to the ends of a cord of the direct solver: the first one to the first point.
  Tether(ribbon::box2d::CordId cord, Player& first, Player& second, ribbon::box2d::Coupling& coupling);

  ribbon::box2d::CordId cord() const { return cord_; }
  /// The rest length between the players in m.
  double length() const { return length_; }

  /// Reels: −1 in, 1 out, 0 not. It does nothing once the cord was cut.
  void reel(int direction, ribbon::box2d::Coupling& coupling, double dt);
  /// Lays the cord anew at its whole length, in narrow folds from waist to waist, at rest, and ties both again. For
  /// players that were put elsewhere. It does nothing once the cord was cut.
  void lay(Player& first, Player& second, ribbon::box2d::Coupling& coupling);

  void add_to(ribbon::box2d::Hasher& hasher) const;

 private:
  double pull(const ribbon::box2d::Coupling& coupling) const;
  void tie(Player& first, Player& second, ribbon::box2d::Coupling& coupling);

  ribbon::box2d::CordId cord_;
  double length_;
  std::array<ribbon::box2d::GripId, 2> grips_{};
};

/// Gives the feet of a tied player friction on level ground while no direction is held, so that the pull of a partner
/// does not drag it along. Call it in each tick before the step.
void brace(Player& player, bool stands_still);

}  // namespace game
