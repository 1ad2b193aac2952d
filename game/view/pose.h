#pragma once

#include <array>
#include <optional>

#include "ribbon/vec2.h"

namespace game {

/// The input of a pose.
struct FigureState {
  ribbon::Vec2 at;        ///< m, the centre of the body
  ribbon::Vec2 velocity;  ///< m/s
  bool faces_left = false;
  bool on_ground = true;
  std::optional<ribbon::Vec2> held;  ///< m, the held position on a cord
  double climbing = 0.0;             ///< m/s along the cord, upwards
  double time = 0.0;                 ///< s, for breath and wind
};

/// The joints of a figure 1.5 m high. The first limb of each pair is the far one.
struct Pose {
  ribbon::Vec2 head, neck, hip;
  std::array<ribbon::Vec2, 2> elbow, hand, knee, foot;
  std::array<ribbon::Vec2, 6> scarf;
  double side = 1.0;  ///< −1 if it looks to the left
};

/// Returns a pose: standing, running, in the air, or hanging from a cord.
Pose pose_of(const FigureState& state);

}  // namespace game
