#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace engine {

/// Turns the time between two drawn frames into a whole number of simulation ticks.
///
/// A frame reads: `run advance(elapsed) ticks, draw once at alpha()`. Time is kept in integers, in units of
/// 1 / (10⁹ · ticks_per_second) s, so that nothing is ever rounded and no drift builds up however the frames fall.
class FixedTick {
 public:
  static constexpr int max_ticks_per_second = 1'000'000;

  /// `ticks_per_second` in 1..1'000'000. `max_ticks_per_frame`, 1 or more, is the clamp: a frame that took longer
  /// runs this many ticks and the rest of its time is lost, so that a slow machine slows down instead of falling ever
  /// further behind. Throws std::invalid_argument on other values.
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

  /// Takes in `elapsed_ns` nanoseconds of real time (negative, from a clock set back, counts as 0) and returns how
  /// many ticks to run now, 0 to max_ticks_per_frame.
  int advance(std::int64_t elapsed_ns) {
    if (elapsed_ns <= 0) return 0;
    // Whole seconds apart from the rest: no product below can overflow, whatever the clock says.
    const std::int64_t whole_seconds = elapsed_ns / unit;
    accumulated_ += (elapsed_ns % unit) * rate_;
    const std::int64_t due = whole_seconds * rate_ + accumulated_ / unit;
    accumulated_ %= unit;
    if (due <= max_ticks_) return static_cast<int>(due);
    dropped_ += due - max_ticks_;
    return max_ticks_;
  }

  /// How far the present moment lies between the last tick and the next, in [0, 1): the weight of interpolation.
  double alpha() const { return static_cast<double>(accumulated_) / static_cast<double>(unit); }

  /// Ticks lost to the clamp so far.
  std::int64_t dropped_ticks() const { return dropped_; }
  int ticks_per_second() const { return rate_; }
  /// Seconds of simulated time in one tick.
  double tick_seconds() const { return 1.0 / rate_; }

 private:
  static constexpr std::int64_t unit = 1'000'000'000;

  int rate_;
  int max_ticks_;
  std::int64_t accumulated_ = 0;  // in 1/rate nanoseconds, always below unit: the part of a tick not run yet
  std::int64_t dropped_ = 0;
};

}  // namespace engine
