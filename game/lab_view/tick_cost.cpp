#include "game/lab_view/tick_cost.h"

#include <algorithm>

namespace game::lab {

double TickCost::median_us() const {
  if (size() == 0) return 0.0;
  std::array<double, window> sorted = recent_us_;
  const auto end = sorted.begin() + static_cast<std::ptrdiff_t>(size());
  std::sort(sorted.begin(), end);
  return sorted[size() / 2];
}

double TickCost::worst_us() const {
  return size() == 0 ? 0.0
                     : *std::max_element(recent_us_.begin(), recent_us_.begin() + static_cast<std::ptrdiff_t>(size()));
}

}  // namespace game::lab
