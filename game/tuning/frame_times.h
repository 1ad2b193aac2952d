#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace game {

/// The times of the parts of a frame in the last second. It does not influence the run.
class FrameTimes {
 public:
  /// What is timed: the ticks of a run, the drawing of a run, and all that a frame computes. The wait for the display
  /// is in none of them.
  enum class Part : std::uint8_t { physics, drawing, whole };

  /// The mean and the maximum in ms; 0 before the first frame.
  struct Figures {
    double mean_ms = 0.0;
    double worst_ms = 0.0;
  };

  /// Adds nanoseconds to a part of the current frame.
  void add(Part part, std::int64_t nanoseconds) { current_[index(part)] += nanoseconds; }
  /// Ends a frame that came `elapsed_ns` after the one before.
  void end_frame(std::int64_t elapsed_ns);
  Figures of(Part part) const;

 private:
  static constexpr std::size_t parts = 3;
  static constexpr std::size_t max_frames = 240;  // of a second, on the fastest displays
  struct Frame {
    std::int64_t elapsed_ns = 0;
    std::array<std::int64_t, parts> ns{};
  };
  static std::size_t index(Part part) { return static_cast<std::size_t>(part); }

  std::array<std::int64_t, parts> current_{};  // ns
  std::array<Frame, max_frames> frames_{};
  std::size_t count_ = 0;  // of all frames
};

}  // namespace game
