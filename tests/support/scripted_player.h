#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "engine/tick/input.h"
#include "game/simulation/buttons.h"
#include "game/simulation/simulation.h"

namespace test_support {

/// One move of a player: the buttons for each tick, by what is on screen, until it ends.
struct Move {
  using Buttons = std::function<int(const game::Simulation&)>;
  using Until = std::function<bool(const game::Simulation&, int ticks)>;

  Buttons buttons;
  Until until;             ///< called before each tick of the move, with the number of its ticks so far
  ribbon::Vec2 pointer{};  ///< m
};

/// Returns the key that pumps a swing below `top` [m]: that of its direction as it passes below, none on the way up.
int pumping(const game::Simulation& simulation, ribbon::Vec2 top);

// Moves for the scripts of levels. `side` is left or right.
inline constexpr int left = game::button_left;
inline constexpr int right = game::button_right;
Move wait(int ticks);
Move hold(int buttons, Move::Until until);
/// Runs until the player's middle has passed x [m].
Move run_past(double x);
/// Stops.
Move stand();
/// Jumps and holds `side`, until the player is on the ground again, or for a number of ticks.
Move jump(int side, int most_ticks = 200);
/// Jumps and catches the first cord within the grab range, after `ticks_before` ticks of holding `side`.
Move jump_and_catch(int side, int ticks_before = 10);
/// In the air, while holding `side`: catches the first cord within the grab range after a number of ticks.
Move fly_and_catch(int side, int ticks_before);
/// Pumps until the cord leans to `side` by `lean` (the horizontal part of its unit vector) while the player rises at
/// `climb` m/s or more; then releases it.
Move pump_and_let_go(int side, double lean, double climb = 0.5);
/// Pumps for a number of ticks.
Move pump_for(int ticks);
/// Stays near x [m] on a trampoline and jumps each time, until the player rises past y.
Move bounce(double x, double y);
/// Releases the cord by a jump.
Move jump_off(int side);
/// Climbs (button_up, button_down) for a number of ticks.
Move climb(int button, int ticks);
/// Climbs until the player's middle has risen past y [m].
Move climb_past(double y);
/// Presses a button for a tick.
Move tap(int button);
/// Throws the line at a hook [m], and waits until it holds.
Move throw_at(ribbon::Vec2 hook, int side = 0);
/// Reels in or out until the line is `length` [m] long.
Move reel_to(double length, int side = 0);
/// On the line: pumps until it leans to `side` by `lean` while the player rises, then releases it.
Move swing_line_and_let_go(int side, double lean, double climb = 0.5);
/// Holds buttons until the goal is reached, and jumps where it is stuck.
Move until_goal(int buttons);

/// Plays one move after another; one that takes more than a minute has failed. In a level for two it plays both
/// players, each by its own moves.
class ScriptedPlayer {
 public:
  explicit ScriptedPlayer(std::vector<Move> moves, std::vector<Move> second = {})
      : scripts_{Script{std::move(moves)}, Script{std::move(second)}} {}

  engine::TickInput input(const game::Simulation& simulation);
  bool is_done() const { return scripts_[0].is_done() && scripts_[1].is_done(); }
  bool is_stuck() const { return scripts_[0].ticks > most_ticks || scripts_[1].ticks > most_ticks; }
  std::size_t move(std::size_t player = 0) const { return scripts_[player].next; }

 private:
  static constexpr int most_ticks = 60 * game::ticks_per_second;
  struct Script {
    std::vector<Move> moves;
    std::size_t next = 0;
    int ticks = 0;

    bool is_done() const { return next >= moves.size(); }
    /// Goes on to the move of this tick, or returns null if there is none.
    Move* advance(const game::Simulation& simulation);
  };
  std::array<Script, 2> scripts_;
};

/// Returns the script that wins a level of the game; empty for an unknown name.
std::vector<Move> winning_script(const std::string& level);
/// Returns that of the second player; empty for a level for one.
std::vector<Move> second_winning_script(const std::string& level);
/// Returns the player, or both players, that win a level of the game.
inline ScriptedPlayer winner_of(const std::string& level) {
  return ScriptedPlayer(winning_script(level), second_winning_script(level));
}

}  // namespace test_support
