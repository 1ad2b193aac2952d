#pragma once

#include <span>
#include <vector>

#include "engine/scene/scene.h"
#include "game/simulation/level_rules.h"
#include "ribbon/box2d/state_hash.h"
#include "ribbon/vec2.h"

namespace game {

/// Cuts the cords of a level, and the lines of players, where a link of them meets the edge of a blade in a tick. All
/// state is in the object.
class Blades {
 public:
  /// The ticks for which the pieces of a cut cord are not cut again: a piece that falls slides along the edge.
  static constexpr int rest_ticks = 20;

  /// Begins with a new scene of the level of these blades.
  void start(const std::vector<Blade>& blades, const engine::Scene& scene);
  /// Cuts what crossed an edge in the last tick. Call it after each tick of the scene.
  void cut(const std::vector<Blade>& blades, engine::Scene& scene);
  /// Returns the edge of a blade after the last tick, m.
  std::span<const ribbon::Vec2> edge(std::size_t blade) const { return edges_[blade]; }
  /// Returns it before that tick.
  std::span<const ribbon::Vec2> edge_before(std::size_t blade) const { return before_[blade]; }

  void add_to(ribbon::box2d::Hasher& hasher) const;

  /// Forgets how the cords moved: they were put where they are.
  void store(const engine::Scene& scene);
  /// Forgets how one cord moved, which was put where it is.
  void forget(ribbon::box2d::CordId cord);

 private:
  struct Piece {
    ribbon::box2d::CordId cord;
    int ticks_left;
  };
  using Points = std::vector<ribbon::Vec2>;

  void move(const std::vector<Blade>& blades, const engine::Scene& scene);
  void find_cuts(const engine::Scene& scene, ribbon::box2d::CordId cord);
  void cut_at_columns(engine::Scene& scene, ribbon::box2d::CordId cord);
  bool rests(ribbon::box2d::CordId cord) const;

  std::vector<Points> local_;   // the edges in the frames of their bodies, m; those without a body in the world
  std::vector<Points> edges_;   // in the world, after the last tick
  std::vector<Points> before_;  // before it
  std::vector<Points> cords_;   // the middle lines of the cords before the last tick, by id
  std::vector<Piece> pieces_;   // that rest
  std::vector<int> columns_;    // scratch: where a cord is to be cut
};

}  // namespace game
