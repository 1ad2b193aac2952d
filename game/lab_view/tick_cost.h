#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace game::lab {

/// What the ticks of a bench cost in the last second, by the clock on the wall. It influences nothing.
class TickCost {
 public:
  void add(std::int64_t nanoseconds) { recent_us_[count_++ % window] = 1e-3 * static_cast<double>(nanoseconds); }
  void forget() { count_ = 0; }
  /// Return the median and the maximum in µs; 0 before the first tick.
  double median_us() const;
  double worst_us() const;

 private:
  static constexpr std::size_t window = 60;  // ticks
  std::size_t size() const { return count_ < window ? count_ : window; }

  std::array<double, window> recent_us_{};
  std::size_t count_ = 0;  // of all since forget()
};

}  // namespace game::lab
