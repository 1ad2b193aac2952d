#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "engine/tick/input.h"
#include "game/simulation/simulation.h"

namespace test_support {

/// One thing that a player does until it is done: what is pressed, by what is on screen, tick by tick.
struct Move {
  using Buttons = std::function<int(const game::Simulation&)>;
  using Until = std::function<bool(const game::Simulation&, int ticks)>;

  Buttons buttons;
  Until until;             ///< asked before each tick of the move, with how many it has had
  ribbon::Vec2 pointer{};  ///< m
};

// Moves, of which levels' scripts are made. `side` is game::button_left or game::button_right.
Move wait(int ticks);
Move hold(int buttons, Move::Until until);
/// Runs until its middle has passed x [m].
Move run_past(double x);
/// Comes to a stand.
Move stand();
/// Jumps and holds `side`, until it is on the ground again or has been so long in the air.
Move jump(int side, int most_ticks = 200);
/// Jumps towards a cord and catches the first one within reach; `ticks_before` of holding `side` without catching.
Move jump_and_catch(int side, int ticks_before = 10);
/// In the air, holding `side`: catches what comes within reach after so many ticks.
Move fly_and_catch(int side, int ticks_before);
/// Pumps until the cord leans to `side` by `lean` (the horizontal part of its unit vector) while it rises at `climb`
/// m/s or more; lets go.
Move pump_and_let_go(int side, double lean, double climb = 0.5);
/// Pumps for so many ticks.
Move pump_for(int ticks);
/// Stays about x [m] on what throws it up, and jumps each time, until it rises past y.
Move bounce(double x, double y);
/// Lets go of the cord by jumping off it.
Move jump_off(int side);
/// Climbs (button_up, button_down) for so many ticks.
Move climb(int button, int ticks);
/// Throws the line at a hook [m], and waits until it holds.
Move throw_at(ribbon::Vec2 hook, int side = 0);
/// Reels in or out until the line is `length` [m] long.
Move reel_to(double length, int side = 0);
/// On the line: pumps until it leans to `side` by `lean` while it rises, and lets go.
Move swing_line_and_let_go(int side, double lean, double climb = 0.5);
Move until_goal(int buttons);

/// Plays move after move; one that takes more than a minute has failed.
class ScriptedPlayer {
 public:
  explicit ScriptedPlayer(std::vector<Move> moves) : moves_(std::move(moves)) {}

  engine::TickInput input(const game::Simulation& simulation);
  bool is_done() const { return next_ >= moves_.size(); }
  bool is_stuck() const { return ticks_ > most_ticks; }
  std::size_t move() const { return next_; }

 private:
  static constexpr int most_ticks = 60 * game::ticks_per_second;
  std::vector<Move> moves_;
  std::size_t next_ = 0;
  int ticks_ = 0;
};

/// How to win a level of the game; empty for an unknown name.
std::vector<Move> winning_script(const std::string& level);

}  // namespace test_support
