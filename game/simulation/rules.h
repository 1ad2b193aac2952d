#pragma once

#include <cstdint>
#include <vector>

#include "engine/scene/scene.h"
#include "game/simulation/blades.h"
#include "game/simulation/burning.h"
#include "game/simulation/chase.h"
#include "game/simulation/level_rules.h"
#include "game/simulation/player.h"
#include "game/simulation/water_forces.h"
#include "ribbon/box2d/state_hash.h"

namespace game {

/// The rules of a level in a run: blades, fires, spikes, chasers, coins, water, and the player's knife. It has all of
/// their state; a copy of it is a saved state. The level must outlive it.
class Rules {
 public:
  /// Begins a run in a new scene of the level.
  void start(const LevelRules& level, const engine::Scene& scene);
  /// What a player does in a tick, before the tick of the scene; once for each player. `number`: of the player, 0 or 1;
  /// `pressed`: the buttons that it did not hold before.
  void act(std::size_t number, unsigned pressed, Player& player, engine::Scene& scene);
  /// What the water does in a tick, before the tick of the scene of `dt` s.
  void before(engine::Scene& scene, double dt);
  /// What blades, fires and chasers do in a tick, after the tick of the scene.
  void after(engine::Scene& scene);
  /// A player meets coins and dangers at its place after a tick. Returns whether it dies.
  bool meet(const Player& player);
  /// After a fall: all is as at the start of the run, but the coins stay collected.
  void return_to(const Rules& start);
  /// Cords were put elsewhere since the last tick, which no blade has cut on their way.
  void cords_were_put(const engine::Scene& scene);
  /// Does so for one cord.
  void cord_was_put(ribbon::box2d::CordId cord) { blades_.forget(cord); }
  /// Sends the chasers back, for a player that is put back in a scene that goes on.
  void send_chasers_back() { chase_.go_back(level_->chasers); }

  const Blades& blades() const { return blades_; }
  const Burning& burning() const { return burning_; }
  const Chase& chase() const { return chase_; }
  /// Returns whether a coin of the level is collected.
  bool has_coin(std::size_t coin) const { return coins_[coin] != 0; }
  int coins() const;  ///< the number of collected ones

  /// Adds the state, if the level has rules.
  void add_to(ribbon::box2d::Hasher& hasher, const engine::Scene& scene) const;

 private:
  static const ribbon::WeatherDef* water_of(const engine::Scene& scene);

  const LevelRules* level_ = nullptr;
  Blades blades_;
  Burning burning_;
  Chase chase_;
  WaterForces water_;
  std::vector<std::uint8_t> coins_;  // 1: collected
};

}  // namespace game
