#pragma once

#include <cstdint>

#include "engine/draw/canvas.h"

namespace game {

/// Darkens the whole canvas; `darkness`: 0 … 1, where 1 is black.
void draw_darkness(engine::Canvas& canvas, double darkness);

/// Draws black with a round hole around `center` (px). `open`: 0 … 1; at 1 the hole has all of the canvas.
void draw_iris(engine::Canvas& canvas, ribbon::Vec2 center, double open);

/// A short fade from dark, which shows that another screen was opened. It needs no motion.
class ScreenFade {
 public:
  static constexpr std::int64_t length_ns = 180'000'000;

  void begin() { left_ns_ = length_ns; }
  void advance(std::int64_t elapsed_ns) { left_ns_ = elapsed_ns < left_ns_ ? left_ns_ - elapsed_ns : 0; }
  /// 0 … 1.
  double darkness() const { return 0.8 * static_cast<double>(left_ns_) / length_ns; }
  void draw(engine::Canvas& canvas) const { draw_darkness(canvas, darkness()); }

 private:
  std::int64_t left_ns_ = 0;
};

}  // namespace game
