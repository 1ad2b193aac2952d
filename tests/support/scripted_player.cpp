#include "tests/support/scripted_player.h"

#include <cmath>

#include "game/simulation/buttons.h"
#include "ribbon/box2d/convert.h"

namespace test_support {
namespace {

using game::Simulation;
using ribbon::Vec2;

Vec2 position(const Simulation& simulation) { return simulation.player().position(); }

Vec2 velocity(const Simulation& simulation) {
  return ribbon::box2d::to_double(simulation.player().body().GetLinearVelocity());
}

double sign(int side) { return side == game::button_left ? -1.0 : 1.0; }

bool holds_cord(const Simulation& simulation) {
  return simulation.scene().coupling().body(simulation.player().body()).held_place().has_value();
}

bool line_is_held(const Simulation& simulation) {
  return simulation.player().line().state() == game::Line::State::held;
}

/// Returns the position that the held cord hangs from, m.
Vec2 top_of_cord(const Simulation& simulation) {
  const ribbon::box2d::Coupling& coupling = simulation.scene().coupling();
  const auto held = coupling.body(simulation.player().body()).held_place();
  return held ? coupling.cord(held->cord).positions()[0] : position(simulation);
}

bool has_swung_out(const Simulation& simulation, Vec2 top, int side, double lean, double climb) {
  const Vec2 from_top = position(simulation) - top;
  const Vec2 v = velocity(simulation);
  return sign(side) * from_top.x > lean * length(from_top) && sign(side) * v.x > 0.0 && v.y > climb;
}

}  // namespace

int pumping(const Simulation& simulation, Vec2 top) {
  const Vec2 from_top = position(simulation) - top;
  const double v = velocity(simulation).x;
  const bool is_low = std::abs(from_top.x) < 0.3 * length(from_top);
  return !is_low || v == 0.0 ? 0 : v > 0.0 ? game::button_right : game::button_left;
}

Move wait(int ticks) {
  return hold(0, [ticks](const Simulation&, int k) { return k >= ticks; });
}

Move hold(int buttons, Move::Until until) {
  return {[buttons](const Simulation&) { return buttons; }, std::move(until)};
}

Move run_past(double x) {
  return {[x](const Simulation& s) { return position(s).x < x ? game::button_right : game::button_left; },
          [x, from = 0.0](const Simulation& s, int k) mutable {
            if (k == 0) from = position(s).x;
            return (from < x) == (position(s).x >= x);
          }};
}

Move stand() {
  return {[](const Simulation& s) {
            const double v = velocity(s).x;
            return v > 0.7 ? game::button_left : v < -0.7 ? game::button_right : 0;
          },
          [](const Simulation& s, int) { return s.player().is_on_ground() && std::abs(velocity(s).x) < 0.7; }};
}

Move jump(int side, int most_ticks) {
  return hold(side | game::button_jump, [most_ticks](const Simulation& s, int k) {
    return k >= most_ticks || (k > 10 && s.player().is_on_ground());
  });
}

Move jump_and_catch(int side, int ticks_before) {
  return {[side, ticks_before, k = 0](const Simulation&) mutable {
            return side | game::button_jump | (k++ >= ticks_before ? game::button_grab : 0);
          },
          [](const Simulation& s, int) { return holds_cord(s); }};
}

Move fly_and_catch(int side, int ticks_before) {
  return {[side, ticks_before, k = 0](const Simulation&) mutable {
            return side | (k++ >= ticks_before ? game::button_grab : 0);
          },
          [](const Simulation& s, int k) { return k > 0 && holds_cord(s); }};
}

Move pump_and_let_go(int side, double lean, double climb) {
  return {[](const Simulation& s) { return game::button_grab | pumping(s, top_of_cord(s)); },
          [=](const Simulation& s, int) { return has_swung_out(s, top_of_cord(s), side, lean, climb); }};
}

Move pump_for(int ticks) {
  return {[](const Simulation& s) { return game::button_grab | pumping(s, top_of_cord(s)); },
          [ticks](const Simulation&, int k) { return k >= ticks; }};
}

Move bounce(double x, double y) {
  return {[x, k = 0](const Simulation& s) mutable {
            const double ahead = position(s).x + 0.5 * velocity(s).x - x;
            const int steer = ahead > 0.2 ? game::button_left : ahead < -0.2 ? game::button_right : 0;
            return steer | (++k % 6 < 3 ? game::button_jump : 0);
          },
          [y](const Simulation& s, int) { return position(s).y > y; }};
}

Move jump_off(int side) {
  return hold(side | game::button_jump, [](const Simulation&, int k) { return k >= 1; });
}

Move climb(int button, int ticks) {
  return hold(game::button_grab | button, [ticks](const Simulation&, int k) { return k >= ticks; });
}

Move climb_past(double y) {
  return hold(game::button_grab | game::button_up,
              [y](const game::Simulation& s, int) { return s.player().position().y > y; });
}

Move tap(int button) {
  return hold(button, [](const game::Simulation&, int k) { return k >= 1; });
}

Move throw_at(Vec2 hook, int side) {
  Move move{[side, k = 0](const Simulation&) mutable { return side | (k++ == 0 ? game::button_throw : 0); },
            [](const Simulation& s, int k) { return k > 0 && line_is_held(s); }};
  move.pointer = hook;
  return move;
}

Move reel_to(double length, int side) {
  return {[=](const Simulation& s) {
            return side | (s.player().line().length() > length ? game::button_reel_in : game::button_reel_out);
          },
          [=, from = 0.0](const Simulation& s, int k) mutable {
            if (k == 0) from = s.player().line().length();
            return from > length ? s.player().line().length() <= length : s.player().line().length() >= length;
          }};
}

Move swing_line_and_let_go(int side, double lean, double climb) {
  return {[=, out = false](const Simulation& s) mutable {
            out = out || has_swung_out(s, s.player().line().end(), side, lean, climb);
            return out ? side | game::button_jump : pumping(s, s.player().line().end());
          },
          [](const Simulation& s, int) { return !line_is_held(s); }};
}

Move until_goal(int buttons) {
  return {[buttons](const Simulation& s) {
            const bool is_stuck = s.player().is_on_ground() && std::abs(velocity(s).x) < 0.1;
            return buttons | (is_stuck ? game::button_jump : 0);
          },
          [](const Simulation& s, int) { return s.goal_ticks().has_value(); }};
}

Move* ScriptedPlayer::Script::advance(const Simulation& simulation) {
  while (!is_done() && moves[next].until(simulation, ticks)) {
    ++next;
    ticks = 0;
  }
  if (is_done() || ticks > most_ticks) return nullptr;
  ++ticks;
  return &moves[next];
}

engine::TickInput ScriptedPlayer::input(const Simulation& simulation) {
  engine::TickInput input;
  if (const Move* move = scripts_[0].advance(simulation)) {
    input.buttons = static_cast<std::uint16_t>(move->buttons(simulation));
    engine::set_pointer(input, move->pointer);
  }
  if (const Move* move = scripts_[1].advance(simulation)) {
    input.second_buttons = static_cast<std::uint16_t>(move->buttons(simulation));
  }
  return input;
}

}  // namespace test_support
