#include "ribbon/study/interval.h"

#include <cstddef>

#include "ribbon/study/conditions.h"

namespace ribbon::study {
namespace {

constexpr Accuracy converged(int substeps) { return {Integrator::tr_bdf2, substeps, 8, 1e-7, unlimited_work}; }
constexpr Accuracy moderate{Integrator::tr_bdf2, 4, 8, 1e-5, unlimited_work};

double spread_of_cords(const Frame& a, const Frame& b) { return cord_differences(a, b).root(); }
double spread_of_bodies(const Frame& a, const Frame& b) { return body_differences(a, b).most; }

/// Returns the number of ticks in which two motions differ by at most `most` [m].
int agreeing_ticks(const Motion& a, const Motion& b, double most, double (*spread)(const Frame&, const Frame&)) {
  const std::size_t ticks = std::min(a.frames.size(), b.frames.size());
  for (std::size_t k = 0; k < ticks; ++k) {
    if (!(spread(a.frames[k], b.frames[k]) <= most)) return static_cast<int>(k);
  }
  return static_cast<int>(ticks);
}

}  // namespace

Interval::Interval(const MakeScene& make, int begin, int ticks) : part_{begin, ticks} {
  part_.lead_in = std::min(window_ticks, begin);
  const auto run_with = [&](const Accuracy& accuracy, double kick) {
    Part part = part_;
    part.accuracy = accuracy;
    part.kick = kick;
    return play(make, part);
  };
  reference_ = run_with(converged(64), 0.0);
  other_ = run_with(converged(32), 0.0);
  const Motion left = run_with(moderate, -probe_kick);
  const Motion right = run_with(moderate, probe_kick);
  const auto compared = [&](double (*spread)(const Frame&, const Frame&)) {
    return std::min(agreeing_ticks(reference_, other_, max_reference_difference, spread),
                    agreeing_ticks(left, right, max_probe_difference, spread));
  };
  cord_ticks_ = compared(spread_of_cords);
  body_ticks_ = compared(spread_of_bodies);
}

Motion Interval::run(const MakeScene& make, const std::optional<Accuracy>& accuracy) const {
  Part part = part_;
  part.ticks = std::max(cord_ticks_, body_ticks_);
  part.accuracy = accuracy;
  return play(make, part);
}

void Interval::add_errors(const Motion& motion, Differences& cords, Differences& bodies) const {
  const auto frames = static_cast<int>(motion.frames.size());
  for (int k = 0; k < std::min(frames, std::max(cord_ticks_, body_ticks_)); ++k) {
    const Frame& own = motion.frames[static_cast<std::size_t>(k)];
    const Frame& converged = reference_.frames[static_cast<std::size_t>(k)];
    if (k < cord_ticks_) cords += cord_differences(own, converged);
    if (k < body_ticks_) bodies += body_differences(own, converged);
  }
}

}  // namespace ribbon::study
