#pragma once

#include <array>
#include <optional>
#include <vector>

#include "ribbon/vec2.h"

namespace game {

/// The part of a held cord near the hand.
struct HeldCord {
  std::vector<ribbon::Vec2> above;  ///< m, from the held position on, towards the end from which the figure hangs
  std::vector<ribbon::Vec2> below;  ///< m, from the held position on, to the other end
  double climbed = 0.0;             ///< m along the cord, increases upwards

  ribbon::Vec2 held() const { return above.front(); }
  /// Returns the position that is `up` m (≥ 0 above, < 0 below) from the held one along the cord, at most its end.
  ribbon::Vec2 at(double up) const;
};

/// The input of a pose.
struct FigureState {
  ribbon::Vec2 at;        ///< m, the centre of the body
  ribbon::Vec2 velocity;  ///< m/s
  bool faces_left = false;
  bool on_ground = true;
  std::optional<HeldCord> cord{};           ///< if it holds one
  bool climbs = false;                      ///< up or down the cord
  std::optional<ribbon::Vec2> ledge{};      ///< m, the edge from which it hangs, if it does
  std::optional<ribbon::Vec2> throws_at{};  ///< m, the hook at which its line flies
  std::optional<double> cheers{};           ///< s, since it reached the goal
  double time = 0.0;                        ///< s, for breath and wind
};

/// The joints of a figure 1.5 m high. The first limb of each pair is the far one.
struct Pose {
  ribbon::Vec2 head, neck, hip;
  std::array<ribbon::Vec2, 2> shoulder, elbow, hand, knee, foot;
  std::array<ribbon::Vec2, 6> scarf;
  double side = 1.0;  ///< −1 if it looks to the left

  /// The hand from which a thrown line flies: the near one, since the far one can hold a cord.
  ribbon::Vec2 throwing_hand() const { return hand[1]; }
};

/// Returns a pose: standing, running, in the air, hanging from a cord or a ledge; throwing a line, or cheering.
Pose pose_of(const FigureState& state);

}  // namespace game
