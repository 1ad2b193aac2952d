// How each level of the game is won.

#include "game/simulation/buttons.h"
#include "tests/support/autopilot.h"
#include "tests/support/scripted_player.h"
#include "tests/support/scripts_for_two.h"
#include "tests/support/scripts_of_lessons.h"

namespace test_support {
namespace {

using ribbon::Vec2;

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
          run_past(26.2), jump_and_catch(right), pump_and_let_go(right, 0.5, 4.0),  until_goal(right)};
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

/// Swings without more speed than a weak rope bears [m/s], until the cord leans to the right by `lean`.
Move swing_gently(double lean, double most_speed) {
  Move move = pump_and_let_go(right, lean, -1.0);
  move.buttons = [most_speed, pumped = move.buttons](const game::Simulation& s) {
    return static_cast<double>(s.player().body().GetLinearVelocity().Length()) < most_speed ? pumped(s)
                                                                                            : game::button_grab;
  };
  return move;
}

/// Swings gently along weak ropes, from a stand at x [m].
void cross_gently(std::vector<Move>& moves, double x, int ropes) {
  for (const Move& move : {run_past(x), stand(), jump(right, 12)}) moves.push_back(move);
  for (int rope = 0; rope < ropes; ++rope) {
    moves.push_back(rope == 0 ? fly_and_catch(0, 20) : fly_and_catch(right, 4));
    moves.push_back(swing_gently(0.33, 3.8));
  }
}

std::vector<Move> gently() {
  std::vector<Move> moves;
  cross_gently(moves, 7.2, 3);
  cross_gently(moves, 24.2, 2);
  cross_gently(moves, 37.2, 3);
  moves.push_back(until_goal(right));
  return moves;
}

std::vector<Move> open_the_gate() {
  return {run_past(6.6),
          stand(),
          jump_and_catch(right, 25),
          hold(game::button_grab, [](const game::Simulation&, int k) { return k >= 400; }),
          wait(4),
          jump(right, 60),
          until_goal(right)};
}

/// Holds buttons until the player is on one side of x [m].
Move hold_past(int buttons, double x) {
  return hold(buttons, [x, from = 0.0](const game::Simulation& s, int k) mutable {
    const double at = s.player().position().x;
    if (k == 0) from = at;
    return (from < x) == (at >= x);
  });
}

/// Waits until the end of a cord is left of x [m] and on its way to the left.
Move wait_for_tip(int cord, double x) {
  return hold(0, [=, last = 1e9](const game::Simulation& s, int) mutable {
    const double at = s.scene().coupling().cord(cord).positions().back().x;
    const bool comes = at < last;
    last = at;
    return comes && at < x;
  });
}

/// Pumps until the player moves to the right past x, above y [m].
Move pump_past(double x, double y) {
  Move move = pump_for(0);
  move.until = [x, y](const game::Simulation& s, int) {
    const b2Vec2 v = s.player().body().GetLinearVelocity();
    return v.x > 0.0F && s.player().position().x > x && s.player().position().y > y;
  };
  return move;
}

std::vector<Move> up_the_shaft() {
  return {throw_at({7.6, 15.0}),
          reel_to(1.8),
          swing_line_and_let_go(left, 0.45),
          stand(),
          run_past(4.2),
          stand(),
          throw_at({11.5, 19.5}),
          reel_to(3.0, right),
          swing_line_and_let_go(right, 0.2),
          throw_at({15.0, 24.0}),
          reel_to(1.5),
          swing_line_and_let_go(right, 0.4),
          until_goal(right)};
}

std::vector<Move> hand_over_hand() {
  return {run_past(9.0),    jump_and_catch(right, 0), hold_past(game::button_grab | game::button_up, 28.4),
          run_past(31.8),   jump_and_catch(right),    hold_past(game::button_grab | game::button_up, 46.8),
          until_goal(right)};
}

std::vector<Move> zip_line() {
  return {run_past(3.6),
          jump_and_catch(left),
          climb_past(12.4),
          pump_and_let_go(right, 0.2),
          run_past(8.4),
          jump_and_catch(right),
          hold_past(game::button_grab, 40.5),
          until_goal(right)};
}

std::vector<Move> the_lift() {
  return {hold_past(left, 4.6), run_past(14.6), jump_and_catch(right, 5), pump_past(16.8, 12.2), until_goal(right)};
}

std::vector<Move> wait_for_the_wind() {
  return {run_past(3.0),         stand(),
          wait_for_tip(0, 15.0), run_past(8.7),
          jump_and_catch(right), pump_and_let_go(right, 0.6),
          run_past(30.0),        stand(),
          wait_for_tip(2, 42.5), run_past(36.2),
          jump_and_catch(right), pump_and_let_go(right, 0.6),
          until_goal(right)};
}

std::vector<Move> wrecking_ball() {
  return {run_past(3.8),
          jump_and_catch(left),
          climb_past(12.2),
          pump_and_let_go(right, 0.25),
          run_past(8.2),
          jump_and_catch(right),
          hold(game::button_grab, [](const game::Simulation&, int k) { return k >= 20; }),
          wait(240),
          run_past(24.0),
          jump(right),
          jump(right),
          until_goal(right)};
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

/// Reels in with the feet on the ground, for a number of ticks, and jumps.
std::vector<Move> charge(Vec2 ring, int ticks) {
  return {throw_at(ring), hold(game::button_reel_in, [ticks](const auto&, int t) { return t >= ticks; }),
          hold(game::button_jump | right,
               [ring](const game::Simulation& s, int) { return s.player().position().x > ring.x - 5.0; }),
          hold(right, [](const auto&, int t) { return t >= 1; }), jump_off(right)};
}

std::vector<Move> slingshot() {
  std::vector<Move> moves = {run_past(8.0), stand()};
  for (Move& move : charge({17.4, 2.9}, 78)) moves.push_back(move);
  moves.push_back(hold(right, [](const game::Simulation& s, int) { return s.player().is_on_ground(); }));
  moves.push_back(run_past(23.2));
  moves.push_back(stand());
  for (Move& move : charge({32.6, 2.9}, 78)) moves.push_back(move);
  moves.push_back(hold(right, [](const game::Simulation& s, int) { return s.player().is_on_ground(); }));
  moves.push_back(jump(right, 40));
  moves.push_back(run_past(38.3));
  moves.push_back(stand());
  moves.push_back(wait(20));
  for (Move& move : charge({48.1, 2.9}, 70)) moves.push_back(move);
  moves.push_back(until_goal(right));
  return moves;
}

/// Throws the line of a hand (0 or 1) at a place, and waits until it holds.
Move throw_by_hand(std::size_t hand, Vec2 place) {
  const int button = hand == 0 ? game::button_throw : game::button_throw_second;
  return {[button, k = 0](const game::Simulation&) mutable { return k++ == 0 ? button : 0; },
          [hand](const game::Simulation& s, int k) { return k > 0 && s.player().lines().all()[hand].is_held(); },
          place};
}

/// Lets go of the line of a hand, and swings on the other one until the player rises above y past x.
Move swing_on_the_other(std::size_t hand, double x, double y) {
  const int button = hand == 0 ? game::button_throw : game::button_throw_second;
  return {
      [button, k = 0](const game::Simulation&) mutable { return k++ == 0 ? button : right; },
      [x, y](const game::Simulation& s, int) { return s.player().position().x > x && s.player().position().y > y; }};
}

std::vector<Move> bound_beams() {
  const auto past = [](double x) {
    return hold(right, [x](const game::Simulation& s, int) { return s.player().position().x > x; });
  };
  return {run_past(6.0),
          stand(),
          throw_by_hand(0, {11.3, 15.0}),
          reel_to(6.0),
          past(11.0),
          throw_by_hand(1, {17.8, 14.6}),
          swing_on_the_other(0, 20.0, 7.0),
          throw_by_hand(0, {24.3, 15.0}),
          swing_on_the_other(1, 26.0, 7.0),
          throw_by_hand(1, {31.3, 14.4}),
          swing_on_the_other(0, 34.0, 7.5),
          jump_off(right),
          until_goal(right)};
}

std::vector<Move> tie_it_down() {
  return {run_past(8.6),
          stand(),
          throw_at({9.0, 7.4}),
          reel_to(1.1),
          hold(0, [](const game::Simulation& s, int ticks) { return s.player().is_on_ground() && ticks > 60; }),
          hold(game::button_tie, [](const game::Simulation&, int ticks) { return ticks > 0; }),
          until_goal(right)};
}

std::vector<Move> long_line() {
  return {run_past(7.0),
          jump(right, 25),
          throw_at({13.0, 13.5}, right),
          swing_line_and_let_go(right, 0.62),
          throw_at({24.0, 14.0}, right),
          swing_line_and_let_go(right, 0.5),
          throw_at({34.0, 14.5}, right),
          swing_line_and_let_go(right, 0.5),
          run_past(44.5),
          stand(),
          throw_at({45.5, 16.5}),
          reel_to(2.5),
          swing_line_and_let_go(right, 0.3),
          throw_at({50.0, 21.5}),
          reel_to(3.5),
          swing_line_and_let_go(right, 0.5),
          until_goal(right)};
}

std::vector<Move> cut_the_bridge() {
  return {run_past(26.1),        stand(),          tap(game::button_cut),       run_past(28.9),
          jump_and_catch(right), climb_past(11.4), pump_and_let_go(right, 0.2), until_goal(right)};
}

/// Holds buttons until a circle of the level is past x [m] on its way to the right, or to the left.
Move wait_for_circle(int buttons, int number, double x, bool to_the_right) {
  return hold(buttons, [=](const game::Simulation& s, int) {
    int before = number;
    for (const engine::SceneBody& made : s.scene().bodies()) {
      if (made.kind != engine::BodyKind::circle || before-- > 0) continue;
      const bool is_past = (made.body->GetPosition().x > static_cast<float>(x)) == to_the_right;
      return is_past && (made.body->GetLinearVelocity().x > 0.0F) == to_the_right;
    }
    return false;
  });
}

std::vector<Move> the_cranes() {
  return {run_past(6.9),
          stand(),
          wait_for_circle(0, 0, 10.2, true),
          jump_and_catch(right),
          wait_for_circle(game::button_grab, 1, 24.5, false),
          pump_and_let_go(right, 0.25),
          fly_and_catch(right, 4),
          wait_for_circle(game::button_grab, 1, 31.0, true),
          pump_and_let_go(right, 0.25),
          stand(),
          run_past(49.9),
          stand(),
          wait_for_circle(0, 2, 53.2, true),
          jump_and_catch(right),
          wait_for_circle(game::button_grab, 3, 67.5, false),
          pump_and_let_go(right, 0.25),
          fly_and_catch(right, 4),
          wait_for_circle(game::button_grab, 3, 74.0, true),
          pump_and_let_go(right, 0.25),
          until_goal(right)};
}

/// Swims towards x [m] and leaps at the surface, until it holds a rope.
Move swim_and_catch(double x) {
  return {[x, k = 0](const game::Simulation& s) mutable {
            const int side = s.player().position().x < x ? right : left;
            return side | game::button_grab | (++k % 30 < 4 ? game::button_jump : 0);
          },
          [](const game::Simulation& s, int) {
            return s.scene().coupling().body(s.player().body()).held_place().has_value();
          }};
}

std::vector<Move> the_harbour() {
  return {run_past(12.0), swim_and_catch(32.6), climb_past(10.2), pump_and_let_go(right, 0.2, 0.0), until_goal(right)};
}

std::vector<Move> before_it_burns() {
  return {run_past(7.0),    jump_and_catch(right), pump_and_let_go(right, 0.62),
          run_past(24.5),   jump_and_catch(right), pump_and_let_go(right, 0.62),
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
  if (level == "gently") return gently();
  if (level == "open_the_gate") return open_the_gate();
  if (level == "curtains") return curtains();
  if (level == "up_the_shaft") return up_the_shaft();
  if (level == "hand_over_hand") return hand_over_hand();
  if (level == "zip_line") return zip_line();
  if (level == "the_lift") return the_lift();
  if (level == "wait_for_the_wind") return wait_for_the_wind();
  if (level == "wrecking_ball") return wrecking_ball();
  if (level == "heavy_load") return heavy_load();
  if (level == "bound_beams") return bound_beams();
  if (level == "tie_it_down") return tie_it_down();
  if (level == "slingshot") return slingshot();
  if (level == "long_line") return long_line();
  if (level == "cut_the_bridge") return cut_the_bridge();
  if (level == "the_cranes") return the_cranes();
  if (level == "the_harbour") return the_harbour();
  if (level == "before_it_burns") return before_it_burns();
  if (level == "sandbox") return sandbox();
  if (std::vector<Move> moves = winning_script_of_lesson(level); !moves.empty()) return moves;
  return winning_script_for_two(level, 0);
}

std::vector<Move> second_winning_script(const std::string& level) { return winning_script_for_two(level, 1); }

}  // namespace test_support
