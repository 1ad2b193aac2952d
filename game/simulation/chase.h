#pragma once

#include <vector>

#include "engine/scene/scene.h"
#include "game/simulation/level_rules.h"
#include "game/simulation/player.h"
#include "ribbon/box2d/state_hash.h"

namespace game {

/// The chasers of a level on their tracks. All state is in the object.
class Chase {
 public:
  /// Begins with a new scene of the level of these chasers.
  void start(const std::vector<Chaser>& chasers, const engine::Scene& scene);
  /// Sets off the chasers that wait for a player at this x [m].
  void notice(const std::vector<Chaser>& chasers, double x);
  /// Moves the chasers by a tick. Call it after each tick of the scene.
  void advance(const std::vector<Chaser>& chasers, const engine::Scene& scene);
  /// Sends all chasers back to their starts, where they wait for what sets them off.
  void go_back(const std::vector<Chaser>& chasers);

  /// Returns whether a chaser touches the player.
  bool touches(const std::vector<Chaser>& chasers, const Player& player) const;
  /// Returns the centre of a chaser between the tick before the last (0) and the last one (1), m.
  ribbon::Vec2 position(std::size_t chaser, double alpha) const;
  bool is_running(std::size_t chaser) const { return places_[chaser].runs; }
  bool has_fallen(std::size_t chaser) const { return places_[chaser].falling_ticks > 0; }

  void add_to(ribbon::box2d::Hasher& hasher) const;

 private:
  struct Place {
    bool runs = false;
    int ticks = 0;          // on its track
    int falling_ticks = 0;  // since it lost the cord below it
    ribbon::Vec2 at;        // m
    ribbon::Vec2 before;    // m
  };
  /// The ends of the cord that a chaser needs, m.
  struct Bridge {
    double left = 0.0;
    double right = 0.0;
  };

  std::vector<Place> places_;
  std::vector<Bridge> bridges_;
};

}  // namespace game
