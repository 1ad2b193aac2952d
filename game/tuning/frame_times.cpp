#include "game/tuning/frame_times.h"

#include <algorithm>

namespace game {
namespace {

constexpr std::int64_t window_ns = 1'000'000'000;

}  // namespace

void FrameTimes::end_frame(std::int64_t elapsed_ns) {
  frames_[count_++ % max_frames] = {elapsed_ns, current_};
  current_ = {};
}

FrameTimes::Figures FrameTimes::of(Part part) const {
  std::int64_t sum = 0;
  std::int64_t worst = 0;
  std::int64_t covered = 0;
  std::size_t frames = 0;
  while (frames < std::min(count_, max_frames) && covered < window_ns) {
    const Frame& frame = frames_[(count_ - ++frames) % max_frames];
    covered += frame.elapsed_ns;
    sum += frame.ns[index(part)];
    worst = std::max(worst, frame.ns[index(part)]);
  }
  if (frames == 0) return {};
  return {1e-6 * static_cast<double>(sum) / static_cast<double>(frames), 1e-6 * static_cast<double>(worst)};
}

}  // namespace game
