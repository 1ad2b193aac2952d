// How each level of the game is won.

#include "game/simulation/buttons.h"
#include "tests/support/autopilot.h"
#include "tests/support/scripted_player.h"

namespace test_support {
namespace {

constexpr int left = game::button_left;
constexpr int right = game::button_right;

std::vector<Move> first_swing() {
  Move move{[autopilot = Autopilot()](const game::Simulation& s) mutable { return autopilot.buttons(s); },
            [](const game::Simulation& s, int) { return s.goal_ticks().has_value(); }};
  return {move};
}

std::vector<Move> pump_it_up() {
  return {run_past(7.0), jump_and_catch(right), pump_and_let_go(right, 0.88), until_goal(right)};
}

std::vector<Move> round_the_pegs() {
  return {run_past(7.4),  jump_and_catch(right), pump_and_let_go(right, 0.45, 2.0), jump(right),
          run_past(26.2), jump_and_catch(right), pump_and_let_go(right, 0.5, 4.0), until_goal(right)};
}

std::vector<Move> rolling_bridge() {
  return {run_past(29.0),
          run_past(46.0),
          jump_and_catch(right),
          climb(game::button_up, 230),
          pump_and_let_go(left, 0.5),
          run_past(31.0),
          jump(left, 60),
          run_past(24.0),
          jump(left, 60),
          until_goal(left)};
}

std::vector<Move> over_the_wall() {
  return {run_past(10.8),         jump_and_catch(right),           climb(game::button_up, 200),
          pump_and_let_go(right, 0.6), run_past(18.6), jump_and_catch(right), pump_and_let_go(right, 0.5), until_goal(right)};
}

std::vector<Move> gently() {
  return {run_past(7.2), stand(), jump_and_catch(right), pump_and_let_go(right, 0.25),
          fly_and_catch(right, 0), pump_and_let_go(right, 0.25), fly_and_catch(right, 0), pump_and_let_go(right, 0.25), run_past(24.2), stand(),
          jump_and_catch(right), pump_and_let_go(right, 0.25), fly_and_catch(right, 0), pump_and_let_go(right, 0.25), until_goal(right)};
}

std::vector<Move> open_the_gate() {
  return {run_past(10.2), jump_and_catch(right), hold(game::button_grab, [](const game::Simulation&, int k) { return k >= 240; }), until_goal(right)};
}

std::vector<Move> trampoline() {
  return {run_past(6.2), jump(right, 44), bounce(13.0, 12.9), run_past(24.2), jump(right), until_goal(right)};
}

std::vector<Move> curtains() {
  return {run_past(23.5), jump_and_catch(right), climb(game::button_up, 110), pump_and_let_go(right, 0.6),
          until_goal(right)};
}

std::vector<Move> heavy_load() {
  return {run_past(4.3),
          jump(right, 30),
          run_past(8.0),
          jump_and_catch(right),
          pump_for(420),
          hold(game::button_grab | game::button_throw, [](const game::Simulation&, int k) { return k >= 2; }),
          jump_off(left),
          jump(left, 60),
          run_past(21.0),
          jump(right, 60),
          wait(5),
          jump(right, 60),
          until_goal(right)};
}

std::vector<Move> long_line() {
  return {run_past(7.0),
          jump(right, 25),
          throw_at({13.0, 13.5}, right),
          swing_line_and_let_go(right, 0.6),
          throw_at({24.0, 14.0}, right),
          swing_line_and_let_go(right, 0.6),
          throw_at({34.0, 14.5}, right),
          swing_line_and_let_go(right, 0.6),
          run_past(44.5),
          stand(),
          throw_at({45.5, 16.5}),
          reel_to(2.5),
          swing_line_and_let_go(right, 0.3),
          throw_at({50.0, 21.5}),
          reel_to(3.5),
          swing_line_and_let_go(right, 0.6),
          until_goal(right)};
}

/// There is no flag: it runs through the yard.
std::vector<Move> sandbox() { return {run_past(46.0), wait(30)}; }

}  // namespace

std::vector<Move> winning_script(const std::string& level) {
  if (level == "first_swing") return first_swing();
  if (level == "pump_it_up") return pump_it_up();
  if (level == "round_the_pegs") return round_the_pegs();
  if (level == "rolling_bridge") return rolling_bridge();
  if (level == "trampoline") return trampoline();
  if (level == "over_the_wall") return over_the_wall();
  if (level == "gently") return gently();
  if (level == "open_the_gate") return open_the_gate();
  if (level == "curtains") return curtains();
  if (level == "heavy_load") return heavy_load();
  if (level == "long_line") return long_line();
  if (level == "sandbox") return sandbox();
  return {};
}

}  // namespace test_support
