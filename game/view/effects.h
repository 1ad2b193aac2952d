#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "game/simulation/simulation.h"
#include "game/view/camera.h"
#include "game/view/fall.h"
#include "game/view/particles.h"
#include "game/view/pen.h"
#include "game/view/trail.h"

namespace game {

/// Visual effects that are not part of the simulation: the motion of the camera, dust, leaves, sparks, confetti, the
/// trail of a fast player (the first one), and what is drawn after a fall. They follow a run by ticks and never change
/// it. Views of the same ticks are equal.
class Effects {
 public:
  explicit Effects(const Simulation& simulation);

  /// Advances to the run's last tick. Starts again if the run was restarted or more than 0.5 s were skipped.
  void follow(const Palette& palette, bool reduced_motion);
  engine::View view(double alpha, int width, int height, bool reduced_motion) const {
    return camera_.view(alpha, width, height, reduced_motion);
  }
  void draw(Pen& pen, double alpha) const;
  /// Draws the trail of the first player at `at` (m), behind it.
  void draw_trail(Pen& pen, ribbon::Vec2 at) const {
    if (!fall_.is_shown()) trail_.draw(pen, at, players_before_[0].velocity);
  }
  const Fall& fall() const { return fall_; }
  const Particles& particles() const { return particles_; }

 private:
  void start_again(const CameraSubject& now);
  void advance(const CameraSubject& now, int gap);
  CameraSubject subject() const;
  void add_particles(const CameraSubject& now, const Palette& palette);
  void add_dust_of(int number, const Palette& palette);
  bool lands(int number) const;

  const Simulation* simulation_;
  Camera camera_;
  Particles particles_;
  Trail trail_;
  Fall fall_;
  /// Where a player was after the last tick.
  struct Moving {
    ribbon::Vec2 at;        // m
    ribbon::Vec2 velocity;  // m/s
  };
  Moving player(int number) const;

  CameraSubject before_{};
  std::array<Moving, 2> players_before_{};
  std::array<bool, 2> was_on_ground_{true, true};
  bool had_goal_ = false;
  std::optional<std::size_t> checkpoint_{};
  int seen_ticks_ = -1;
  int seen_run_ticks_ = 0;
  int falls_ = 0;
};

}  // namespace game
