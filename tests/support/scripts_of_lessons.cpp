// How the first levels are won, which teach the keys, the climb over the wall, and the balloons.

#include "tests/support/scripts_of_lessons.h"

#include "game/simulation/buttons.h"

namespace test_support {
namespace {

std::vector<Move> first_steps() {
  return {run_past(8.0),
          jump(right),
          run_past(19.6),
          jump_and_catch(right),
          pump_and_let_go(right, 0.5, 1.0),
          run_past(39.5),
          jump_and_catch(right, 0),
          climb_past(14.4),
          pump_and_let_go(right, 0.03, -2.0),
          jump_off(right),
          run_past(54.6),
          jump_and_catch(right),
          pump_and_let_go(right, 0.5, 1.0),
          until_goal(right)};
}

std::vector<Move> in_rhythm() {
  return {run_past(11.6),   jump_and_catch(right), pump_and_let_go(right, 0.66),
          run_past(35.6),   jump_and_catch(right), pump_and_let_go(right, 0.7),
          until_goal(right)};
}

std::vector<Move> line_and_knife() {
  return {run_past(16.2),
          stand(),
          throw_at({17.9, 13.8}),
          reel_to(1.2),
          jump_off(right),
          run_past(30.6),
          stand(),
          tap(game::button_cut),
          wait(40),
          run_past(44.4),
          throw_at({50.4, 17.4}, right),
          reel_to(6.4, right),
          swing_line_and_let_go(right, 0.6),
          until_goal(right)};
}

std::vector<Move> over_the_wall() {
  return {run_past(10.8),        jump_and_catch(right),       climb(game::button_up, 200), pump_and_let_go(right, 0.6),
          run_past(18.6),        jump_and_catch(right),       pump_and_let_go(right, 0.5), run_past(46.4),
          jump_and_catch(right), climb(game::button_up, 300), pump_and_let_go(right, 0.6), until_goal(right)};
}

/// Takes the low road, from balloon to balloon.
std::vector<Move> up_and_away() {
  return {run_past(15.6),   jump_and_catch(right), pump_and_let_go(right, 0.5),
          run_past(43.6),   jump_and_catch(right), pump_and_let_go(right, 0.78, 1.5),
          until_goal(right)};
}

}  // namespace

std::vector<Move> winning_script_of_lesson(const std::string& level) {
  if (level == "first_steps") return first_steps();
  if (level == "in_rhythm") return in_rhythm();
  if (level == "line_and_knife") return line_and_knife();
  if (level == "over_the_wall") return over_the_wall();
  if (level == "up_and_away") return up_and_away();
  return {};
}

}  // namespace test_support
