#pragma once

#include <cstddef>
#include <optional>

namespace game {

/// How far a run has come: its time, falls, checkpoint and goal.
class RunProgress {
 public:
  int ticks() const { return ticks_; }                           ///< since the start
  int run_ticks() const { return run_ticks_; }                   ///< since the last restart
  int falls() const { return falls_; }                           ///< out of the level, since the last restart
  std::optional<int> goal_ticks() const { return goal_ticks_; }  ///< run_ticks() when the goal was reached
  int last_fallen() const { return last_fallen_; }               ///< the player that fell last
  bool died() const { return died_; }                            ///< by a danger, not out of the level
  /// The last checkpoint of the level that a player entered; the players return there after a fall.
  std::optional<std::size_t> checkpoint() const { return checkpoint_; }

 protected:
  void begin_run() {
    checkpoint_.reset();
    run_ticks_ = 0;
    falls_ = 0;
    goal_ticks_.reset();
  }
  void count_tick() {
    ++ticks_;
    ++run_ticks_;
  }
  void reach_goal() { goal_ticks_ = run_ticks_; }
  void enter(std::size_t checkpoint) { checkpoint_ = checkpoint; }
  /// A player fell. `is_death`: a danger of the level killed it; else it fell out of the level.
  void fall(int player, bool is_death) {
    ++falls_;
    last_fallen_ = player;
    died_ = is_death;
  }

 private:
  int ticks_ = 0;
  int run_ticks_ = 0;
  int falls_ = 0;
  int last_fallen_ = 0;
  bool died_ = false;
  std::optional<int> goal_ticks_;
  std::optional<std::size_t> checkpoint_;
};

}  // namespace game
