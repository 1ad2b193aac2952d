#include "game/view/pose.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace game {
namespace {

using ribbon::Vec2;

constexpr double half_height = 0.75;
constexpr double hip_height = -0.045;  // above the centre of a standing figure
constexpr double torso = 0.44;
constexpr double neck_to_head = 0.22;
constexpr double upper_arm = 0.27;
constexpr double forearm = 0.27;
constexpr double thigh = 0.34;
constexpr double shin = 0.34;
constexpr double stride = 2.7;    // rad/m, phase of the run
constexpr double full_run = 6.0;  // m/s

Vec2 unit(Vec2 v, Vec2 fallback) {
  const double l = length(v);
  return l > 1e-6 ? (1.0 / l) * v : fallback;
}

Vec2 turned(Vec2 v, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}

struct Bone {
  Vec2 joint;
  Vec2 end;
};

/// Inverse kinematics of two bones from `root` to `target`, or towards it if it is too far. `bend`: ±1, the side of the
/// joint.
Bone solve_limb(Vec2 root, Vec2 target, double upper, double lower, double bend) {
  const Vec2 direction = unit(target - root, {0.0, -1.0});
  const double distance = std::clamp(length(target - root), std::abs(upper - lower) + 0.01, upper + lower - 1e-3);
  const double along = (distance * distance + upper * upper - lower * lower) / (2.0 * distance);
  const double out = std::sqrt(std::max(upper * upper - along * along, 0.0));
  return {root + along * direction + bend * out * perp(direction), root + distance * direction};
}

void set_leg(Pose& pose, std::size_t k, Vec2 foot) {
  const Bone leg = solve_limb(pose.hip, foot, thigh, shin, pose.side);
  pose.knee[k] = leg.joint;
  pose.foot[k] = leg.end;
}

void set_arm(Pose& pose, std::size_t k, Vec2 hand, double bend) {
  const Bone arm = solve_limb(pose.neck - Vec2{0.0, 0.06}, hand, upper_arm, forearm, bend);
  pose.elbow[k] = arm.joint;
  pose.hand[k] = arm.end;
}

/// Sets hip, neck and head. `up`: the direction of the torso.
void set_torso(Pose& pose, Vec2 hip, Vec2 up) {
  pose.hip = hip;
  pose.neck = hip + torso * up;
  pose.head = pose.neck + neck_to_head * unit(up + Vec2{0.25 * pose.side, 0.6}, up);
}

void stand_or_run(Pose& pose, const FigureState& state) {
  const double run = std::min(std::abs(state.velocity.x) / full_run, 1.0);
  const double phase = stride * state.at.x * pose.side;
  const double breath = 0.012 * std::sin(2.4 * state.time) * (1.0 - run);
  const double bob = 0.05 * run * std::abs(std::sin(phase));
  const Vec2 lean = turned({0.0, 1.0}, -0.26 * run * pose.side);
  set_torso(pose, state.at + Vec2{0.0, hip_height + bob + breath - 0.02 * run}, lean);
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

void hang(Pose& pose, const FigureState& state) {
  const Vec2 held = *state.held;
  const Vec2 down = unit(state.at - held, {0.0, -1.0});
  const Vec2 up = unit(-0.75 * down + Vec2{0.0, 0.45}, {0.0, 1.0});
  set_torso(pose, state.at - 0.16 * up, up);
  const double pull = 0.12 * std::sin(9.0 * state.time) * std::clamp(state.climbing, -1.0, 1.0);
  const Vec2 rope = -down;
  set_arm(pose, 0, held + (0.06 + pull) * rope, pose.side);
  set_arm(pose, 1, held - (0.08 + pull) * rope, -pose.side);
  // The legs trail behind the motion across the cord.
  const double across = dot(state.velocity, perp(down));
  const double trail = std::clamp(-0.16 * across, -1.05, 1.05);
  const double sway = 0.05 * std::sin(2.0 * state.time);
  const Vec2 legs = turned(-up, trail + sway);
  const double tuck = 0.16 * std::abs(state.climbing > 0.0 ? std::sin(4.5 * state.time) : 0.0);
  set_leg(pose, 0, pose.hip + (0.62 - tuck) * turned(legs, -0.16 * pose.side));
  set_leg(pose, 1, pose.hip + (0.60 - 2.0 * tuck) * turned(legs, 0.20 * pose.side));
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

Pose pose_of(const FigureState& state) {
  Pose pose;
  pose.side = state.faces_left ? -1.0 : 1.0;
  if (state.held) {
    hang(pose, state);
  } else if (state.on_ground) {
    stand_or_run(pose, state);
  } else {
    fly(pose, state);
  }
  wave_scarf(pose, state);
  return pose;
}

}  // namespace game
