#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include "engine/replay/replay.h"
#include "engine/tick/input.h"
#include "game/simulation/drag.h"
#include "game/simulation/level.h"
#include "game/simulation/player.h"
#include "game/simulation/rules.h"
#include "game/simulation/saved_tick.h"
#include "game/simulation/snapshot.h"
#include "game/simulation/target.h"
#include "ribbon/box2d/state_hash.h"
#include "ribbon/box2d/step_watcher.h"

namespace game {

inline constexpr int ticks_per_second = 60;

/// Advances a scene by a tick of `dt` s.
using Mover = std::function<void(double dt)>;
/// Makes the mover of a new scene and its player, which outlive it.
using MakeMover = std::function<Mover(engine::Scene& scene, Player& player)>;

/// A run of a level by one player or two: a function of the level and the inputs of the ticks only.
class Simulation {
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
  const Player& player() const { return *players_[0]; }
  Player& player() { return *players_[0]; }  ///< recordings do not include changes of it
  /// The first player (0) or the second one (1) of `players`.
  const Player& player(int number) const { return *players_[static_cast<std::size_t>(number)]; }
  int players() const { return level_->players(); }  ///< 1 or 2
  /// The rope between the players; nothing if there is none.
  const std::optional<Tether>& tether() const { return tether_; }
  /// Whether that player touches the flag, where it waits for the other.
  bool is_at_flag(int number) const;
  /// After a fall, cords and bodies stay as they are, until a restart: the scene was changed by hand.
  void keep_changes() { keeps_changes_ = true; }
  const ribbon::box2d::StateHash& hash() const { return hash_; }  ///< after the last tick
  const Snapshot& previous() const { return previous_; }          ///< before the last tick
  const Snapshot& current() const { return current_; }            ///< after the last tick
  int ticks() const { return ticks_; }                            ///< since the start
  int run_ticks() const { return run_ticks_; }                    ///< since the last restart
  int falls() const { return falls_; }                            ///< out of the level, since the last restart
  std::optional<int> goal_ticks() const { return goal_ticks_; }   ///< run_ticks() when the goal was reached
  int last_fallen() const { return last_fall_.player; }           ///< the player that fell last
  bool died() const { return last_fall_.is_death; }               ///< by a danger, not out of the level
  /// The last checkpoint of the level that the player entered; it returns there after a fall.
  std::optional<std::size_t> checkpoint() const { return checkpoint_; }
  int coins() const { return rules_.coins(); }  ///< collected since the last restart
  const Rules& rules() const { return rules_; }
  const Drag& drag() const { return drag_; }
  /// What a line of a player would be thrown at now.
  const std::optional<Target>& target(int number = 0) const {
    return seats_[static_cast<std::size_t>(number)].targets.thrown;
  }

  /// Returns the header of a replay of this level.
  static engine::ReplayHeader replay_header(const Level& level);
  /// Sets the assists and the yard of the level to those that the replay declares. What it cannot have stays out, so
  /// that the headers differ.
  static void take_settings(Level& level, const engine::ReplayHeader& header);

 private:
  void restart();
  void make_players();
  void apply(int number, std::uint16_t buttons, unsigned pressed, std::optional<ribbon::Vec2> pointer);
  void follow_lines();
  void reel_tether(const engine::TickInput& input);
  bool drop_load(const Player& player);
  void put_players_back();
  void hold_buttons();
  void put_at(ribbon::Vec2 first, ribbon::Vec2 second);
  std::uint16_t buttons_after_goal(const Player& player) const;
  void check_players();
  void update_foothold(int number);
  void add_to(ribbon::box2d::Hasher& game, int number) const;
  void compute_hash();
  /// Returns references to what SavedTick::Progress has.
  template <typename Self>
  static auto progress_of(Self& self) {
    return std::tie(self.drag_, self.checkpoint_, self.seats_, self.ticks_, self.run_ticks_, self.falls_,
                    self.last_fall_, self.goal_ticks_);
  }

  const Level* level_;
  MakeMover make_mover_;
  ribbon::box2d::StepWatcher* watcher_ = nullptr;
  ribbon::ParallelFor parallel_for_;
  std::unique_ptr<engine::Scene> scene_;
  std::array<std::unique_ptr<Player>, 2> players_;  // the second one is null in a run of one
  std::optional<Tether> tether_;
  Mover move_;
  Snapshot previous_;
  Snapshot current_;
  ribbon::box2d::StateHash hash_;
  Drag drag_;
  Rules rules_;
  SavedTick start_;             // what cords and bodies return to after a fall
  bool keeps_changes_ = false;  // and they do not
  std::optional<std::size_t> checkpoint_;
  std::array<Seat, 2> seats_;
  int ticks_ = 0;
  int run_ticks_ = 0;
  int falls_ = 0;
  LastFall last_fall_;
  std::optional<int> goal_ticks_;
  int restarts_ = 0;
};

}  // namespace game
