#include "tests/peers/recording.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "tests/study/text.h"

namespace peers {
namespace {

using ribbon::Vec2;

bool is_near(Vec2 p) { return length(p) <= max_coordinate; }

}  // namespace

bool is_in_bounds(const Frame& frame) {
  return std::all_of(frame.moving_bodies.begin(), frame.moving_bodies.end(), is_near) &&
         std::all_of(frame.cords.begin(), frame.cords.end(),
                     [](const std::vector<Vec2>& cord) { return std::all_of(cord.begin(), cord.end(), is_near); });
}

int points_of(const Plan& plan) {
  int points = 0;
  for (const CordPlan& cord : plan.cords) points += cord.def.points * cord.def.rows;
  return points;
}

Recording read_recording(const std::string& path, const Plan& plan) {
  const std::string bytes = study::read_file(path);
  std::vector<double> numbers(bytes.size() / sizeof(double));
  if (!numbers.empty()) std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(double));
  const std::size_t moving_bodies = plan.moving_bodies().size();
  const std::size_t row = 1 + 2 * (static_cast<std::size_t>(points_of(plan)) + moving_bodies);
  if (numbers.empty() || numbers.size() % row != 0 || bytes.size() % sizeof(double) != 0) {
    throw std::runtime_error(path + " has " + std::to_string(bytes.size()) + " bytes; accepted are frames of " +
                             std::to_string(row * sizeof(double)));
  }
  Recording recording;
  for (std::size_t next = 0; next < numbers.size();) {
    Frame frame;
    frame.us = numbers[next++];
    const auto take = [&] {
      const Vec2 p{numbers[next], numbers[next + 1]};
      next += 2;
      return p;
    };
    for (const CordPlan& cord : plan.cords) {
      std::vector<Vec2>& points = frame.cords.emplace_back();
      for (int p = 0; p < cord.def.points * cord.def.rows; ++p) points.push_back(take());
    }
    for (std::size_t m = 0; m < moving_bodies; ++m) frame.moving_bodies.push_back(take());
    recording.push_back(std::move(frame));
  }
  return recording;
}

}  // namespace peers
