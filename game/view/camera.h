#pragma once

#include "engine/draw/canvas.h"

namespace game {

/// What the camera looks at after a tick.
struct CameraSubject {
  ribbon::Vec2 at;        ///< m, the player
  ribbon::Vec2 velocity;  ///< m/s
  bool faces_left = false;
  bool lands = false;   ///< in this tick
  double impact = 0.0;  ///< m/s, how hard
};

/// Follows the player, ahead of where he goes, by ticks and not by frames. It stays within the level, and shows more of
/// it when he is fast.
class Camera {
 public:
  /// `level` is the level's size in m, from (0, 0).
  explicit Camera(ribbon::Vec2 level) : level_(level) {}

  /// At once where it would come to rest.
  void jump_to(const CameraSubject& subject);
  /// A tick of 1/60 s on.
  void tick(const CameraSubject& subject);

  /// The view of a moment, `alpha` (0 … 1) of the way between the last two ticks, on a picture of this many pixels.
  engine::View view(double alpha, int width, int height, bool calm) const;

 private:
  struct Place {
    ribbon::Vec2 at{};
    double metres_high = 13.0;
    ribbon::Vec2 shake{};
  };
  static Place wanted(const CameraSubject& subject);

  ribbon::Vec2 level_;
  Place now_, before_;
  ribbon::Vec2 ahead_velocity_{};  // m/s, smoothed
  double shaking_ = 0.0;           // m
  int ticks_ = 0;
};

}  // namespace game
