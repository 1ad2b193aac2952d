#pragma once

#include <cstdint>
#include <vector>

#include "engine/scene/scene.h"
#include "game/simulation/level_rules.h"
#include "ribbon/box2d/state_hash.h"

namespace game {

/// Burns the cords of a level through where they stay in a fire. All state is in the object.
class Burning {
 public:
  /// The ticks in which a place that was about to burn through cools down outside of the fire.
  static constexpr int cooling_ticks = 120;

  /// Heats the columns of cords that are in a fire, cools the others, and cuts each cord at the column that has burnt
  /// through. Call it after each tick of the scene.
  void burn(const std::vector<Fire>& fires, engine::Scene& scene);
  /// Returns how far a column of a cord is heated, 0 … 1.
  double heat(ribbon::box2d::CordId cord, int column) const;
  /// Returns how far it was heated at most, 0 … 1: it stays black.
  double char_of(ribbon::box2d::CordId cord, int column) const;

  void add_to(ribbon::box2d::Hasher& hasher) const;

 private:
  struct Place {
    std::int64_t heat = 0;
    std::int64_t most = 0;
  };
  struct Cord {
    double link = 0.0;  // m, rest length
    std::vector<Place> columns;
  };

  void follow_cuts(const engine::Scene& scene);
  void inherit(const engine::Scene& scene, ribbon::box2d::CordId piece, const Cord& whole, int first_column);
  Cord& of(const engine::Scene& scene, ribbon::box2d::CordId cord);
  void heat_cord(const std::vector<Fire>& fires, engine::Scene& scene, ribbon::box2d::CordId cord);
  const Place* find(ribbon::box2d::CordId cord, int column) const;

  std::vector<Cord> cords_;  // by id
};

}  // namespace game
