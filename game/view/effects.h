#pragma once

#include <cstddef>
#include <optional>

#include "game/simulation/simulation.h"
#include "game/view/camera.h"
#include "game/view/particles.h"
#include "game/view/pen.h"

namespace game {

/// What the eye is given besides the world: the camera's way, and dust, leaves and sparks. It watches a run, tick by
/// tick, and never changes it. Two views that are shown the same moments show the same.
class Effects {
 public:
  explicit Effects(const Simulation& simulation);

  /// Goes on to the run's last tick. A run that was set back, or has gone on for more than half a second, is seen as if
  /// nothing had been before.
  void follow(const Palette& palette, bool calm);
  engine::View view(double alpha, int width, int height, bool calm) const {
    return camera_.view(alpha, width, height, calm);
  }
  void draw(Pen& pen, double alpha) const;

 private:
  CameraSubject subject() const;
  void watch(const CameraSubject& now, const Palette& palette);

  const Simulation* simulation_;
  Camera camera_;
  Particles particles_;
  CameraSubject before_{};
  bool was_on_ground_ = true;
  bool had_goal_ = false;
  std::optional<std::size_t> checkpoint_{};
  int seen_ticks_ = -1;
  int seen_run_ticks_ = 0;
};

}  // namespace game
