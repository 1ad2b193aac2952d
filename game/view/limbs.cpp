#include "game/view/limbs.h"

#include <algorithm>
#include <cmath>

namespace game {
namespace {

using ribbon::Vec2;

struct SolvedLimb {
  Vec2 joint;
  Vec2 end;
};

/// Inverse kinematics of two bones of the same length from `root` to `target`, or towards it if it is too far. `bend`:
/// ±1, the side of the joint.
SolvedLimb solve_limb(Vec2 root, Vec2 target, double bone, double bend) {
  const Vec2 direction = unit(target - root, {0.0, -1.0});
  const double distance = std::min(length(target - root), 2.0 * bone);
  const double out = std::sqrt(std::max(bone * bone - 0.25 * distance * distance, 0.0));
  return {root + 0.5 * distance * direction + bend * out * perp(direction), root + distance * direction};
}

}  // namespace

Vec2 unit(Vec2 v, Vec2 fallback) {
  const double l = length(v);
  return l > 1e-6 ? (1.0 / l) * v : fallback;
}

Vec2 turned(Vec2 v, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}

void set_torso(Pose& pose, Vec2 hip, Vec2 up, double shrug) {
  pose.hip = hip;
  pose.neck = hip + torso * up;
  pose.head = pose.neck + neck_to_head * unit(up + Vec2{0.25 * pose.side, 0.6}, up);
  pose.shoulder.fill(pose.neck + Vec2{0.0, shrug - 0.06});
}

void set_leg(Pose& pose, std::size_t k, Vec2 foot) {
  const SolvedLimb leg = solve_limb(pose.hip, foot, leg_bone, pose.side);
  pose.knee[k] = leg.joint;
  pose.foot[k] = leg.end;
}

void set_arm(Pose& pose, std::size_t k, Vec2 hand, double bend) {
  const SolvedLimb arm = solve_limb(pose.shoulder[k], hand, arm_bone, bend);
  pose.elbow[k] = arm.joint;
  pose.hand[k] = arm.end;
}

void set_holding_arm(Pose& pose, std::size_t k, Vec2 hand, double bend) {
  const SolvedLimb arm =
      solve_limb(pose.shoulder[k], hand, std::max(arm_bone, 0.5 * length(hand - pose.shoulder[k])), bend);
  pose.elbow[k] = arm.joint;
  pose.hand[k] = arm.end;
}

}  // namespace game
