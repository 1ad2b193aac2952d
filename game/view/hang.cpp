#include "game/view/hang.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "game/view/limbs.h"

namespace game {
namespace {

using ribbon::Vec2;

constexpr double reach = 0.42;          // m, from the shoulder to the middle between the hands at rest
constexpr double hanging_shrug = 0.06;  // m, of the shoulders while hanging
constexpr double hand_gap = 0.13;       // m, between the hands at rest
constexpr double max_shift = 0.28;      // m, of the drawn figure from its body, towards the held position
constexpr double max_tilt = 0.20;       // rad, along the cord
constexpr double max_lean = 0.7;        // rad, towards a held position that is being pulled in
constexpr double full_climb = 0.9;      // m/s, at which hands and feet move in full
constexpr double pull = 0.28;           // m, by which a hand goes down with the cord in a climb
constexpr double lift = 0.17;           // m of climb in which it goes up again
constexpr double feet_below = 1.40;     // m of cord from the held position to the feet
constexpr double min_tail = 1.10;       // m of cord below the held position for the feet to find it
constexpr double easy_reach = 0.55;     // m, from the hip to the cord: the feet hold it
constexpr double leg_reach = 0.66;      // m: they leave it

double length_of(const std::vector<Vec2>& way) {
  double sum = 0.0;
  for (std::size_t k = 1; k < way.size(); ++k) sum += length(way[k] - way[k - 1]);
  return sum;
}

/// Returns how far a hand is below its upper position, m, after `climbed` m of its part of a climb: it stays on the
/// cord, which passes the body downwards, and then goes up.
double below_top(double climbed) {
  return climbed < pull ? climbed : pull * std::max(1.0 - (climbed - pull) / lift, 0.0);
}

/// Returns the positions of the hands, m up the cord. One of them is 0. `climbing`: 0 at rest … 1.
std::array<double, 2> hands_of(const HeldCord& cord, double climbing) {
  if (length_of(cord.below) < hand_gap) return {hand_gap, 0.0};  // at the end of the cord
  std::array<double, 2> up{-hand_gap * (1.0 - climbing), 0.0};
  const double turns = cord.climbed / (2.0 * (pull + lift));
  const double phase = 2.0 * (pull + lift) * (turns - std::floor(turns));
  const bool near_pulls = phase >= pull + lift;
  up[near_pulls ? 1 : 0] -= climbing * below_top(near_pulls ? phase - (pull + lift) : phase);
  const double top = std::max(up[0], up[1]);
  return {up[0] - top, up[1] - top};
}

/// Places the feet on the cord below the figure, as far as they reach it. `held`: 0 … 1, by how much they leave their
/// free position for it.
void set_feet_on_cord(Pose& pose, const HeldCord& cord, double climbing, double held) {
  const double tail = length_of(cord.below);
  const double turns = cord.climbed / (pull + lift);
  const double cycle = below_top((pull + lift) * (turns - std::floor(turns)));
  double down = std::min(feet_below - climbing * (pull - cycle), tail);
  while (down > min_tail && length(cord.at(-down) - pose.hip) > easy_reach) down -= 0.01;
  held *= std::clamp((tail - min_tail) / 0.1, 0.0, 1.0);
  for (const std::size_t k : {0U, 1U}) {
    const Vec2 place = cord.at(-down + (k == 0 ? 0.08 : 0.0));
    const double reached = (leg_reach - length(place - pose.hip)) / (leg_reach - easy_reach);
    set_leg(pose, k, pose.foot[k] + held * std::clamp(reached, 0.0, 1.0) * (place - pose.foot[k]));
  }
}

/// Sets legs that trail behind the motion across the cord.
void set_trailing_legs(Pose& pose, const FigureState& state, Vec2 up, Vec2 rope) {
  const double across = dot(state.velocity, perp(-rope));
  const double trail = std::clamp(-0.16 * across, -1.05, 1.05);
  const double sway = 0.05 * std::sin(2.0 * state.time);
  const Vec2 legs = turned(-up, trail + sway);
  set_leg(pose, 0, pose.hip + 0.62 * turned(legs, -0.16 * pose.side));
  set_leg(pose, 1, pose.hip + 0.60 * turned(legs, 0.20 * pose.side));
}

}  // namespace

std::size_t holding_hand(const FigureState& state) { return state.throws_at || state.cheers ? 0 : 1; }

void hang(Pose& pose, const FigureState& state) {
  const HeldCord& cord = *state.cord;
  const Vec2 to_held = cord.held() - state.at;
  const Vec2 rope = unit(cord.at(0.5) - cord.held(), unit(to_held, {0.0, 1.0}));
  const double climbing = state.climbs ? std::clamp(dot(state.velocity, rope) / full_climb, -1.0, 1.0) : 0.0;
  const double climbing_up = std::max(climbing, 0.0);
  const std::array<double, 2> hands = hands_of(cord, climbing_up);
  const double tilt = std::clamp(-0.5 * rope.x, -max_tilt, max_tilt);
  const double lean = std::clamp(-0.5 * std::atan2(to_held.x, std::max(to_held.y, 0.4)), -max_lean, max_lean);
  const Vec2 up = turned({0.0, 1.0}, tilt + lean);
  // The shoulder is within reach of the hands, unless the figure would be drawn too far from its body.
  const Vec2 standing = state.at + Vec2{0.0, hip_height};
  const double upper = std::max(hands[0], hands[1]);
  const Vec2 middle = 0.5 * (cord.at(upper) + cord.at(upper - hand_gap));
  const Vec2 shift = middle - (reach + torso) * up - standing;
  set_torso(pose, standing + std::min(1.0, max_shift / std::max(length(shift), max_shift)) * shift, up, hanging_shrug);
  if (holding_hand(state) == 0) {
    set_holding_arm(pose, 0, cord.held(), pose.side);
    set_arm(pose, 1, pose.shoulder[1] + Vec2{0.2 * pose.side, -0.4}, -pose.side);
  } else {
    for (const std::size_t k : {0U, 1U}) set_holding_arm(pose, k, cord.at(hands[k]), k == 0 ? -pose.side : pose.side);
  }
  set_trailing_legs(pose, state, up, rope);
  if (climbing != 0.0) set_feet_on_cord(pose, cord, climbing_up, std::abs(climbing));
}

}  // namespace game
