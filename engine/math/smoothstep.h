#pragma once

#include <algorithm>

namespace engine {

/// Rises smoothly from 0 at x = `from` to 1 at x = `to`, and stays there; `from` and `to` differ.
inline double smoothstep(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

}  // namespace engine
