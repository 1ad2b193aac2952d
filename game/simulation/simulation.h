#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "engine/tick/input.h"
#include "game/simulation/drag.h"
#include "game/simulation/level.h"
#include "game/simulation/player.h"
#include "game/simulation/players.h"
#include "game/simulation/rules.h"
#include "game/simulation/run_progress.h"
#include "game/simulation/saved_tick.h"
#include "game/simulation/snapshot.h"
#include "game/simulation/target.h"
#include "game/simulation/tick_rate.h"
#include "ribbon/box2d/state_hash.h"
#include "ribbon/box2d/step_watcher.h"

namespace game {

/// Advances a scene by a tick of `dt` s.
using Mover = std::function<void(double dt)>;
/// Makes the mover of a new scene and its player, which outlive it.
using MakeMover = std::function<Mover(engine::Scene& scene, Player& player)>;

/// A run of a level by one player or two: a function of the level and the inputs of the ticks only.
class Simulation : public RunProgress {
 public:
  /// Stores a reference to the level. `make_mover` replaces Scene::tick, to compare another method with the cords. Such
  /// a run cannot be recorded or drawn: its hash and snapshots stay those of the start.
  explicit Simulation(const Level& level, MakeMover make_mover = {});
  explicit Simulation(Level&& level, MakeMover make_mover = {}) = delete;

  /// Runs one tick of 1/60 s.
  void tick(const engine::TickInput& input);
  /// Runs one tick without an update of hash(), previous() and current(), for a seek; run the last two ticks of it with
  /// tick().
  void skip(const engine::TickInput& input);

  /// Saves the state. It allocates nothing if the object held a state of this level before.
  void save(SavedTick& saved) const;
  /// Goes back to a state, as exactly as ribbon::box2d::WorldSnapshot does. `before` is that of the tick before, or
  /// null. Returns false, and changes nothing, if the level was restarted since then. Not for a run with a mover.
  bool restore(SavedTick& saved, const SavedTick* before);

  const Level& level() const { return *level_; }
  const engine::Scene& scene() const { return *scene_; }
  /// Recordings do not include changes of the scene.
  engine::Scene& scene() { return *scene_; }
  /// Calls the watcher around each step of the cords of this scene and of later ones: ribbon::box2d::Coupling::watch.
  void watch(ribbon::box2d::StepWatcher* watcher);
  /// Steps the cords of this scene and of later ones in parallel: ribbon::box2d::Coupling::use.
  void use(const ribbon::ParallelFor& parallel_for);
  /// The first player (0) or the second one (1) of `players`.
  const Player& player(int number = 0) const { return players_[number]; }
  Player& player() { return players_[0]; }           ///< recordings do not include changes of it
  int players() const { return level_->players(); }  ///< 1 or 2
  /// The rope between the players; nothing if there is none.
  const std::optional<Tether>& tether() const { return players_.tether(); }
  /// Whether that player touches the flag, where it waits for the other.
  bool is_at_flag(int number) const;
  /// After a fall, cords and bodies stay as they are, until a restart: the scene was changed by hand.
  void keep_changes() { keeps_changes_ = true; }
  const ribbon::box2d::StateHash& hash() const { return hash_; }  ///< after the last tick
  const Snapshot& previous() const { return previous_; }          ///< before the last tick
  const Snapshot& current() const { return current_; }            ///< after the last tick
  int coins() const { return rules_.coins(); }                    ///< collected since the last restart
  const Rules& rules() const { return rules_; }
  const Drag& drag() const { return drag_; }
  /// What a line of a player would be thrown at now.
  const std::optional<Target>& target(int number = 0) const { return players_.seat(number).targets.thrown; }

 private:
  void restart();
  void apply(int number, std::uint16_t buttons, unsigned pressed, std::optional<ribbon::Vec2> pointer);
  void follow_lines();
  void put_players_back();
  void put_at(ribbon::Vec2 first, ribbon::Vec2 second);
  void check_players();
  void compute_hash();

  const Level* level_;
  MakeMover make_mover_;
  ribbon::box2d::StepWatcher* watcher_ = nullptr;
  ribbon::ParallelFor parallel_for_;
  std::unique_ptr<engine::Scene> scene_;
  Players players_;
  Mover move_;
  Snapshot previous_;
  Snapshot current_;
  ribbon::box2d::StateHash hash_;
  Drag drag_;
  Rules rules_;
  SavedTick start_;             // what cords and bodies return to after a fall
  bool keeps_changes_ = false;  // and they do not
  int restarts_ = 0;
};

}  // namespace game
