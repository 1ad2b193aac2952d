// How the levels for two are won. The moves of each player wait for what the other one does.

#include "tests/support/scripts_for_two.h"

#include <cmath>
#include <functional>
#include <utility>

#include "game/simulation/buttons.h"

namespace test_support {
namespace {

using game::Simulation;

constexpr int hop = game::button_jump;
constexpr int grab = game::button_grab;
constexpr int reel_in = game::button_reel_in;

double x(const Simulation& s, int player) { return s.player(player).position().x; }
double y(const Simulation& s, int player) { return s.player(player).position().y; }

/// Holds buttons until something is so.
Move until(int buttons, std::function<bool(const Simulation&)> so) {
  return hold(buttons, [so = std::move(so)](const Simulation& s, int) { return so(s); });
}
Move for_ticks(int buttons, int ticks) {
  return hold(buttons, [ticks](const Simulation&, int k) { return k >= ticks; });
}
Move left_of(int player, double place, int more = 0) {
  return until(left | more, [=](const Simulation& s) { return x(s, player) < place; });
}
/// Stops on the ground.
Move halt(int player) {
  const auto speed = [player](const Simulation& s) {
    return static_cast<double>(s.player(player).body().GetLinearVelocity().x);
  };
  return {[speed](const Simulation& s) { return speed(s) > 0.7    ? left
                                                : speed(s) < -0.7 ? right
                                                                  : 0; },
          [speed, player](const Simulation& s, int) {
            return s.player(player).is_on_ground() && std::abs(speed(s)) < 0.7;
          }};
}
/// Runs to the flag at a place and waits there for the other; jumps where it is stuck.
Move to_flag(int player, double place) {
  return {[=, k = 0](const Simulation& s) mutable {
            ++k;
            const double off = place - x(s, player);
            const bool is_stuck = s.player(player).is_on_ground() && std::abs(off) > 0.6 && k % 20 < 10 &&
                                  std::abs(s.player(player).body().GetLinearVelocity().x) < 0.1F;
            return (off > 0.4 ? right : off < -0.4 ? left : 0) | (is_stuck ? hop : 0);
          },
          [](const Simulation& s, int) { return s.goal_ticks().has_value(); }};
}

std::vector<Move> over_you_go(int player) {
  const std::vector<Move> way_to_flag = {left_of(player, 15.6), for_ticks(left | hop, 50), left_of(player, 7.6),
                                         for_ticks(left | hop, 50), to_flag(player, 2.3)};
  std::vector<Move> moves = {until(0, [](const Simulation& s) { return y(s, 0) > 10.5; }), left_of(0, 19.5)};
  if (player == 1) {
    moves = {left_of(1, 23.0), until(left, [](const Simulation& s) { return y(s, 0) > 9.0; }), halt(1),
             until(0, [](const Simulation& s) { return x(s, 0) < 20.5 && s.player(0).is_on_ground(); })};
  }
  moves.insert(moves.end(), way_to_flag.begin(), way_to_flag.end());
  return moves;
}

std::vector<Move> pull_me_up(int player) {
  const auto is_up = [](const Simulation& s) { return y(s, 1) > 8.7 && s.player(1).is_on_ground(); };
  if (player == 1) {
    return {left_of(1, 9.6), until(left, is_up), to_flag(1, 2.6)};
  }
  return {left_of(0, 16.0), for_ticks(left | hop, 60),
          left_of(0, 9.0),  until(left | hop, [](const Simulation& s) { return x(s, 0) < 6.6; }),
          halt(0),          until(reel_in, is_up),
          to_flag(0, 2.6)};
}

/// Stays left of a place [m], against the pull of the rope, until something is so.
Move stay_left_of(int player, double place, std::function<bool(const Simulation&)> so) {
  return {[=](const Simulation& s) { return x(s, player) > place ? left : 0; },
          [so = std::move(so)](const Simulation& s, int) { return so(s); }};
}

std::vector<Move> swing_me_across(int player) {
  if (player == 1) {
    return {until(0, [](const Simulation& s) { return x(s, 0) < 28.0; }),
            for_ticks(left | hop, 50),
            stay_left_of(1, 7.9, [](const Simulation& s) { return x(s, 0) < 15.0 && y(s, 0) > 7.5; }),
            until(right, [](const Simulation& s) { return x(s, 1) > 12.2 || s.player(0).is_on_ground(); }),
            halt(1),
            until(0, [](const Simulation& s) { return s.player(0).is_on_ground(); }),
            to_flag(1, 13.2)};
  }
  return {left_of(0, 27.0),
          halt(0),
          until(0, [](const Simulation& s) { return x(s, 1) < 9.0 && s.player(1).is_on_ground(); }),
          for_ticks(0, 30),
          left_of(0, 13.0),
          until(0, [](const Simulation& s) { return s.player(0).is_on_ground(); }),
          to_flag(0, 13.2)};
}

std::vector<Move> the_light_one_first(int player) {
  const auto is_up = [](const Simulation& s) { return y(s, 1) > 8.7 && s.player(1).is_on_ground(); };
  if (player == 1) {
    return {left_of(1, 13.5),
            halt(1),
            until(0, [](const Simulation& s) { return x(s, 0) < 9.0; }),
            left_of(1, 9.6),
            until(left, is_up),
            to_flag(1, 2.9)};
  }
  return {until(0, [](const Simulation& s) { return x(s, 1) < 14.0; }),
          left_of(0, 11.1),
          halt(0),
          for_ticks(grab, 20),
          until(grab | game::button_up, [](const Simulation& s) { return y(s, 0) > 10.2; }),
          for_ticks(left | hop, 1),
          left_of(0, 8.6),
          until(left | hop, [](const Simulation& s) { return x(s, 0) < 6.6; }),
          halt(0),
          until(reel_in, is_up),
          to_flag(0, 2.9)};
}

}  // namespace

std::vector<Move> winning_script_for_two(const std::string& level, int player) {
  if (level == "over_you_go") return over_you_go(player);
  if (level == "pull_me_up") return pull_me_up(player);
  if (level == "the_light_one_first") return the_light_one_first(player);
  if (level == "swing_me_across") return swing_me_across(player);
  return {};
}

}  // namespace test_support
