#include "engine/sound/waves.h"

#include <algorithm>
#include <cmath>

namespace engine {

double sine(double turns) {
  double x = turns - std::floor(turns);  // 0 … 1
  const double sign = x < 0.5 ? 1.0 : -1.0;
  if (x >= 0.5) x -= 0.5;
  if (x > 0.25) x = 0.5 - x;
  const double a = 6.283185307179586 * x;  // 0 … π/2, where the series is exact to 1e-9
  const double b = a * a;
  return sign * a *
         (1.0 -
          b / 6.0 * (1.0 - b / 20.0 * (1.0 - b / 42.0 * (1.0 - b / 72.0 * (1.0 - b / 110.0 * (1.0 - b / 156.0))))));
}

double smooth_step(double x) {
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

}  // namespace engine
