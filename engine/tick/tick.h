#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace engine {

/// Converts the time between two drawn frames to a whole number of simulation ticks.
///
/// Each frame runs advance(elapsed) ticks and draws once at alpha(). Time is stored as an integer in units of
/// 1 / (10⁹ · ticks_per_second) s: nothing is rounded, so there is no drift.
class FixedTick {
 public:
  static constexpr int max_ticks_per_second = 1'000'000;

  /// `ticks_per_second`: 1 … 1'000'000. `max_ticks_per_frame`: 1 or more; a frame that took longer runs this many ticks
  /// and drops the rest of its time, so that the game slows down on a slow machine instead of falling further and
  /// further behind. Throws std::invalid_argument for other values.
  explicit FixedTick(int ticks_per_second = 60, int max_ticks_per_frame = 8)
      : rate_(ticks_per_second), max_ticks_(max_ticks_per_frame) {
    if (rate_ < 1 || rate_ > max_ticks_per_second) {
      throw std::invalid_argument("ticks per second is " + std::to_string(rate_) + ", accepted is 1 to " +
                                  std::to_string(max_ticks_per_second));
    }
    if (max_ticks_ < 1) {
      throw std::invalid_argument("ticks a frame is " + std::to_string(max_ticks_) + ", accepted is 1 or more");
    }
  }

  /// Adds `elapsed_ns` nanoseconds of real time and returns the number of ticks to run now, 0 … max_ticks_per_frame.
  /// Negative times, from a clock that was set back, count as 0.
  int advance(std::int64_t elapsed_ns) {
    if (elapsed_ns <= 0) return 0;
    // Whole seconds are split off so that no product below can overflow, whatever the clock returns.
    const std::int64_t whole_seconds = elapsed_ns / unit;
    accumulated_ += (elapsed_ns % unit) * rate_;
    const std::int64_t due = whole_seconds * rate_ + accumulated_ / unit;
    accumulated_ %= unit;
    if (due <= max_ticks_) return static_cast<int>(due);
    dropped_ += due - max_ticks_;
    return max_ticks_;
  }

  /// The fraction of the next tick that has elapsed, in [0, 1): the weight for interpolation between ticks.
  double alpha() const { return static_cast<double>(accumulated_) / static_cast<double>(unit); }

  /// The number of ticks dropped so far because a frame took too long.
  std::int64_t dropped_ticks() const { return dropped_; }
  int ticks_per_second() const { return rate_; }
  /// The length of a tick in s.
  double tick_seconds() const { return 1.0 / rate_; }

 private:
  static constexpr std::int64_t unit = 1'000'000'000;

  int rate_;
  int max_ticks_;
  std::int64_t accumulated_ = 0;  // the elapsed part of the next tick, in 1/rate nanoseconds, below `unit`
  std::int64_t dropped_ = 0;
};

}  // namespace engine
