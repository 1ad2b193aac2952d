#pragma once

#include <array>
#include <optional>

#include "ribbon/vec2.h"

namespace game {

/// What a figure's pose follows from. Everything in metres and seconds.
struct FigureState {
  ribbon::Vec2 at;        ///< the middle of the body
  ribbon::Vec2 velocity;  ///< m/s
  bool faces_left = false;
  bool on_ground = true;
  std::optional<ribbon::Vec2> held;  ///< the place of a cord that the hands hold
  double climbing = 0.0;             ///< m/s along the cord, upwards
  double time = 0.0;                 ///< s, for breath and wind
};

/// The joints of a figure 1.5 m high. Of each pair the far limb comes first.
struct Pose {
  ribbon::Vec2 head, neck, hip;
  std::array<ribbon::Vec2, 2> elbow, hand, knee, foot;
  std::array<ribbon::Vec2, 6> scarf;
  double side = 1.0;  ///< −1 if it looks to the left
};

/// Standing, running, in the air, or hanging from what it holds with the legs trailing the swing.
Pose pose_of(const FigureState& state);

}  // namespace game
