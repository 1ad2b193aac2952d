#include "game/simulation/meter.h"

#include <algorithm>
#include <numeric>

namespace game {
namespace {

/// Returns the length of a cord's first row in m.
double length_of(const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord) {
  const auto x = coupling.cord(cord).positions();
  const auto rows = static_cast<std::size_t>(coupling.cord(cord).shape().rows);
  double sum = 0.0;
  for (std::size_t p = rows; p < x.size(); p += rows) sum += length(x[p] - x[p - rows]);
  return sum;
}

/// Returns the rest length of a cord in m, as it was defined.
double rest_length_of(const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord) {
  if (coupling.cord(cord).solver() == ribbon::box2d::Solver::thesis) {
    const ribbon::ThesisDef& def = coupling.cord(cord).thesis().def();
    return def.spacing * (def.w - 1);
  }
  return coupling.cord(cord).direct().def().length;
}

}  // namespace

void Meter::add(const Simulation& simulation, std::int64_t nanoseconds) {
  ++ticks_;
  const ribbon::box2d::Coupling& coupling = simulation.scene().coupling();
  const bool restarted = simulation.run_ticks() <= last_run_tick_;
  last_run_tick_ = simulation.run_ticks();
  if (restarted) cords_.clear();
  for (const ribbon::box2d::CordId c : coupling.cords()) {
    if (static_cast<std::size_t>(c) >= cords_.size()) cords_.resize(static_cast<std::size_t>(c) + 1);
    CordFigures& cord = cords_[static_cast<std::size_t>(c)];
    cord.peak_stretch = std::max(cord.peak_stretch, length_of(coupling, c) / rest_length_of(coupling, c) - 1.0);
    if (coupling.last_step().estimates_errors()) cord.errors[estimated_ % estimates] = coupling.cord(c).error();
  }
  if (coupling.last_step().estimates_errors()) {
    ++estimated_;
  } else {
    recent_us_[timed_++ % window_ticks] = 1e-3 * static_cast<double>(nanoseconds);
  }
}

double Meter::median_us() const {
  std::array<double, window_ticks> sorted = recent_us_;
  const std::size_t count = std::min(timed_, window_ticks);
  if (count == 0) return 0.0;
  std::sort(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(count));
  return sorted[count / 2];
}

double Meter::worst_us() const { return *std::max_element(recent_us_.begin(), recent_us_.end()); }

std::vector<float> Meter::recent_us() const {
  std::vector<float> recent;
  for (std::size_t k = timed_ < window_ticks ? 0 : timed_ - window_ticks; k < timed_; ++k) {
    recent.push_back(static_cast<float>(recent_us_[k % window_ticks]));
  }
  return recent;
}

double Meter::peak_stretch(ribbon::box2d::CordId cord) const {
  const auto index = static_cast<std::size_t>(cord);
  return index < cords_.size() ? cords_[index].peak_stretch : 0.0;
}

double Meter::error_per_second(ribbon::box2d::CordId cord) const {
  const auto index = static_cast<std::size_t>(cord);
  if (index >= cords_.size()) return 0.0;
  const auto& errors = cords_[index].errors;
  return ticks_per_estimate * std::accumulate(errors.begin(), errors.end(), 0.0);
}

}  // namespace game
