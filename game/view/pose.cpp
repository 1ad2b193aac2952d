#include "game/view/pose.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "game/view/hang.h"
#include "game/view/limbs.h"

namespace game {
namespace {

using ribbon::Vec2;

constexpr double half_height = 0.75;
constexpr double stride = 2.7;           // rad/m, phase of the run
constexpr double full_run = 6.0;         // m/s
constexpr double arms_up = 0.25;         // s, until the arms are up in a cheer
constexpr double cheer_rate = 8.0;       // rad/s
constexpr double standing_shrug = 0.08;  // m, of the shoulders of a figure that stands and holds a cord above it
constexpr double throwing_arm = 0.52;    // m, from the shoulder to the hand

void stand_or_run(Pose& pose, const FigureState& state) {
  const double run = std::min(std::abs(state.velocity.x) / full_run, 1.0);
  const double phase = stride * state.at.x * pose.side;
  const double breath = 0.012 * std::sin(2.4 * state.time) * (1.0 - run);
  const double bob = 0.05 * run * std::abs(std::sin(phase));
  const Vec2 lean = turned({0.0, 1.0}, -0.26 * run * pose.side);
  const double bounce = state.cheers ? 0.06 * std::pow(std::sin(0.5 * cheer_rate * *state.cheers), 2) : 0.0;
  set_torso(pose, state.at + Vec2{0.0, hip_height + bob + breath - 0.02 * run - bounce}, lean,
            state.cord ? standing_shrug : 0.0);
  const double ground = state.at.y - half_height + 0.06;
  for (const std::size_t k : {0U, 1U}) {
    const double leg = phase + (k == 0 ? std::numbers::pi : 0.0);
    const double still = (k == 0 ? -0.10 : 0.10) * (1.0 - std::min(4.0 * run, 1.0));
    const double x = state.at.x + pose.side * (still + 0.46 * run * std::cos(leg) - 0.06 * run);
    set_leg(pose, k, {x, ground + 0.30 * run * std::max(-std::sin(leg), 0.0)});
    const double arm = -std::cos(leg) * run;
    set_arm(pose, k,
            pose.neck +
                Vec2{pose.side * (0.36 * arm + 0.10 + (k == 0 ? -0.06 : 0.02)), -0.44 + 0.16 * run + 0.10 * arm * run},
            -pose.side);
  }
}

void fly(Pose& pose, const FigureState& state) {
  const double rise = std::clamp(state.velocity.y / 6.0, -1.0, 1.0);
  const double forward = std::clamp(state.velocity.x / 8.0, -1.0, 1.0);
  set_torso(pose, state.at + Vec2{0.0, hip_height}, turned({0.0, 1.0}, -0.22 * forward));
  // One knee is up while the figure rises; both feet point to the ground while it falls.
  const double fall = 0.5 - 0.5 * rise;
  set_leg(pose, 0, pose.hip + Vec2{pose.side * (-0.34 + 0.18 * fall), -0.50 - 0.06 * fall});
  set_leg(pose, 1, pose.hip + Vec2{pose.side * (0.30 - 0.10 * fall), -0.34 - 0.22 * fall});
  const double flap = 0.05 * std::sin(14.0 * state.time) * fall;
  set_arm(pose, 0, pose.neck + Vec2{-0.40 * pose.side, 0.02 + 0.30 * fall + flap}, pose.side);
  set_arm(pose, 1, pose.neck + Vec2{0.42 * pose.side, 0.10 + 0.26 * fall - flap}, -pose.side);
}

void hang_from_ledge(Pose& pose, const FigureState& state) {
  const double sway = 0.04 * std::sin(2.0 * state.time);
  set_torso(pose, state.at + Vec2{0.0, hip_height}, {0.0, 1.0}, standing_shrug);
  for (const std::size_t k : {0U, 1U}) {
    const Vec2 foot = pose.hip + Vec2{pose.side * (k == 0 ? 0.12 : 0.02) + sway, k == 0 ? -0.58 : -0.66};
    set_leg(pose, k, foot);
    const double behind = k == 0 ? 0.14 : 0.03;
    set_holding_arm(pose, k, *state.ledge + Vec2{pose.side * behind, 0.0}, k == 0 ? -pose.side : pose.side);
  }
}

/// Raises the arms that hold nothing, and waves them.
void cheer(Pose& pose, const FigureState& state) {
  const double raised = std::min(*state.cheers / arms_up, 1.0);
  for (const std::size_t k : {0U, 1U}) {
    if (state.cord && k == holding_hand(state)) continue;
    const double outwards = k == 0 ? -pose.side : pose.side;
    const Vec2 up = turned({0.0, 0.5}, -outwards * (0.7 + 0.2 * std::sin(cheer_rate * *state.cheers)));
    set_arm(pose, k, pose.hand[k] + raised * (pose.shoulder[k] + up - pose.hand[k]), -outwards);
  }
}

void wave_scarf(Pose& pose, const FigureState& state) {
  // The relative wind, a breeze from the left, and the weight of the scarf.
  const Vec2 air = Vec2{0.7, 0.0} - 0.34 * state.velocity + Vec2{-1.0 * pose.side, -0.9};
  const Vec2 along = unit(air, {0.0, -1.0});
  const double wind = std::min(length(state.velocity) / 8.0, 1.0);
  Vec2 at = pose.neck + Vec2{-0.07 * pose.side, 0.01};
  for (std::size_t k = 0; k < pose.scarf.size(); ++k) {
    pose.scarf[k] = at;
    const double flutter =
        (0.12 + 0.3 * wind) * std::sin((6.0 + 8.0 * wind) * state.time - 1.1 * static_cast<double>(k));
    at += 0.115 * turned(along, flutter);
  }
}

}  // namespace

Vec2 HeldCord::at(double up) const {
  const std::vector<Vec2>& way = up < 0.0 ? below : above;
  double left = std::abs(up);
  for (std::size_t k = 1; k < way.size(); ++k) {
    const Vec2 piece = way[k] - way[k - 1];
    const double l = length(piece);
    if (l >= left && l > 0.0) return way[k - 1] + (left / l) * piece;
    left -= l;
  }
  return way.back();
}

Pose pose_of(const FigureState& state) {
  Pose pose;
  pose.side = state.faces_left ? -1.0 : 1.0;
  if (state.ledge) {
    hang_from_ledge(pose, state);
  } else if (state.on_ground) {
    stand_or_run(pose, state);
    if (state.cord) {
      const std::size_t k = holding_hand(state);
      set_holding_arm(pose, k, state.cord->held(), k == 0 ? pose.side : -pose.side);
    }
  } else if (state.cord) {
    hang(pose, state);
  } else {
    fly(pose, state);
  }
  if (state.throws_at) {
    const Vec2 shoulder = pose.shoulder[1];
    set_arm(pose, 1, shoulder + throwing_arm * unit(*state.throws_at - shoulder, {0.0, 1.0}), -pose.side);
  } else if (state.cheers && (state.on_ground || state.cord)) {
    cheer(pose, state);
  }
  wave_scarf(pose, state);
  return pose;
}

}  // namespace game
