#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "engine/replay/replay.h"
#include "engine/tick/input.h"
#include "game/simulation/drag.h"
#include "game/simulation/level.h"
#include "game/simulation/player.h"
#include "ribbon/box2d/state_hash.h"
#include "ribbon/box2d/step_watcher.h"

namespace game {

inline constexpr int ticks_per_second = 60;

/// Where everything is after a tick, for drawing between two of them.
struct Snapshot {
  struct Body {
    ribbon::Vec2 position;  ///< m
    double angle = 0.0;     ///< rad
  };
  std::vector<std::vector<ribbon::Vec2>> cords;  ///< m, by cord and point
  std::vector<Body> bodies;                      ///< in the order they were made
};

/// The moment `alpha` (0 … 1) of the way from one tick to the next. They must be of the same world.
Snapshot interpolate(const Snapshot& from, const Snapshot& to, double alpha);

/// Moves a scene for a tick of dt seconds.
using Mover = std::function<void(double dt)>;
/// Makes the mover of a new scene and its player, which outlive it.
using MakeMover = std::function<Mover(engine::Scene& scene, Player& player)>;

/// A run of a level: a function of the level and of the ticks' inputs, and of nothing else.
class Simulation {
 public:
  /// Keeps a reference to the level. `make_mover`, if there is one, says who moves its scenes instead of Scene::tick:
  /// another method that is compared with the cords. Such a run is neither recorded nor drawn: its hash and snapshots
  /// stay those of the start.
  explicit Simulation(const Level& level, MakeMover make_mover = {});
  explicit Simulation(Level&& level, MakeMover make_mover = {}) = delete;

  /// One tick of 1/60 s.
  void tick(const engine::TickInput& input);
  /// The same without what is to be seen of it: hash(), previous() and current() stay those of before. For who goes on
  /// to a later tick, and takes that one and the one before it by tick().
  void skip(const engine::TickInput& input);

  const Level& level() const { return *level_; }
  const engine::Scene& scene() const { return *scene_; }
  /// What is changed in it is in no recording.
  engine::Scene& scene() { return *scene_; }
  /// Is called around each step of the scene's cords, and of those of scenes to come: ribbon::box2d::Coupling::watch.
  void watch(ribbon::box2d::StepWatcher* watcher);
  /// Moves the cords of this scene, and of those to come, side by side: ribbon::box2d::Coupling::use.
  void use(const ribbon::ParallelFor& parallel_for);
  const Player& player() const { return *player_; }
  Player& player() { return *player_; }                           ///< as for the scene
  const ribbon::box2d::StateHash& hash() const { return hash_; }  ///< after the last tick
  const Snapshot& previous() const { return previous_; }          ///< before the last tick
  const Snapshot& current() const { return current_; }            ///< after it
  int ticks() const { return ticks_; }                            ///< since the beginning
  int run_ticks() const { return run_ticks_; }                    ///< since the last restart
  int falls() const { return falls_; }                            ///< out of the level, since the last restart
  std::optional<int> goal_ticks() const { return goal_ticks_; }   ///< of this run when the goal was reached
  /// Of the level's, the last one entered; a fall ends there.
  std::optional<std::size_t> checkpoint() const { return checkpoint_; }
  const Drag& drag() const { return drag_; }
  /// Of the level's hooks, the one that a line thrown now goes for.
  std::optional<std::size_t> aimed_hook() const { return aimed_hook_; }

  /// What a replay of this level has to agree with.
  static engine::ReplayHeader replay_header(const Level& level);
  /// Gives a level the assists, and no others, that a replay of it declares.
  static void take_assists(Level& level, const engine::ReplayHeader& header);

 private:
  void restart();
  void aim(ribbon::Vec2 pointer);
  bool drop_load();
  void put_player_back();
  void watch_the_player();
  void remember_where_he_stands();
  void take_snapshot(Snapshot& snapshot) const;
  void compute_hash();

  const Level* level_;
  MakeMover make_mover_;
  ribbon::box2d::StepWatcher* watcher_ = nullptr;
  ribbon::ParallelFor parallel_for_;
  std::unique_ptr<engine::Scene> scene_;
  std::unique_ptr<Player> player_;
  Mover move_;
  Snapshot previous_;
  Snapshot current_;
  ribbon::box2d::StateHash hash_;
  Drag drag_;
  std::optional<std::size_t> checkpoint_;
  std::optional<std::size_t> aimed_hook_;
  ribbon::Vec2 stood_at_;   // m, feet: where a fall ends, with that assist
  ribbon::Vec2 stands_at_;  // m, feet: where it will, if he stands on
  int standing_ticks_ = 0;  // on firm ground
  std::uint16_t buttons_before_ = 0;
  int ticks_ = 0;
  int run_ticks_ = 0;
  int falls_ = 0;
  std::optional<int> goal_ticks_;
};

}  // namespace game
