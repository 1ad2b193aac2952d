#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "engine/draw/canvas.h"

namespace game {

/// The state of the player after a tick, for the camera.
struct CameraSubject {
  ribbon::Vec2 at;        ///< m, the player
  ribbon::Vec2 velocity;  ///< m/s
  bool faces_left = false;
  bool on_ground = false;
  bool hangs = false;   ///< from a cord
  bool lands = false;   ///< in this tick
  double impact = 0.0;  ///< m/s, the speed of the landing
  /// m, of two players, in the middle of which `at` is: half their distance, across and up; both are in the picture.
  std::optional<ribbon::Vec2> spread{};
};

/// Follows the player with a lead in its direction of motion, as a critically damped spring does. A jump does not move
/// it up or down, and the ground from which the player jumped stays in the picture, as far as it has room for both. It
/// moves by ticks, not by frames, stays within the level, and shows more of it at high speed.
class Camera {
 public:
  /// `level`: the size of the level in m, from (0, 0). `targets`: places at which a line can be thrown, m. Those just
  /// above the picture come into it while the player is on the ground.
  explicit Camera(ribbon::Vec2 level, std::vector<ribbon::Vec2> targets = {})
      : level_(level), targets_(std::move(targets)) {}

  /// Jumps to the position at which it would come to rest.
  void jump_to(const CameraSubject& subject);
  /// Advances by a tick of 1/60 s.
  void tick(const CameraSubject& subject);

  /// Returns the view for a canvas of width × height pixels, interpolated between the last two ticks with `alpha`,
  /// 0 … 1. `reduced_motion`: without shake and zoom.
  engine::View view(double alpha, int width, int height, bool reduced_motion) const;

 private:
  struct Place {
    ribbon::Vec2 at{};
    double height = 13.0;  // m, of the view
    double least = 0.0;    // m, its height that shows both players; 0 for one
    ribbon::Vec2 shake{};
  };
  Place wanted(const CameraSubject& subject) const;
  double follow_height(const CameraSubject& subject);
  double rise_to_targets(ribbon::Vec2 center) const;

  ribbon::Vec2 level_;
  std::vector<ribbon::Vec2> targets_;
  Place now_, before_;
  ribbon::Vec2 velocity_{};          // m/s, of the camera
  ribbon::Vec2 subject_velocity_{};  // m/s, smoothed; vertically that of level_height_
  double facing_ = 1.0;              // −1 left … 1 right, smoothed
  double level_height_ = 0.0;        // m, the height that it follows: of the player, but not of its jumps
  std::optional<double> ground_{};   // m, the soles of the player when it was last on the ground, until it hangs
  double shaking_ = 0.0;             // m, amplitude
  int ticks_ = 0;
};

}  // namespace game
