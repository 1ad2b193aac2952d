#pragma once

#include <algorithm>

#include "ribbon/study/motion.h"

namespace ribbon::study {

/// A part of a run with its converged motion, which judges settings.
class Interval {
 public:
  /// Plays the converged runs of `ticks` ticks from `begin` on, and finds which ticks can be compared: while they
  /// differ by at most 0.1 mm, and the motion is not too sensitive (see conditions.h).
  Interval(const MakeScene& make, int begin, int ticks);

  /// Plays a setting while something is compared.
  Motion run(const MakeScene& make, const std::optional<Accuracy>& accuracy) const;
  /// Adds a motion's differences from the converged one, in all compared ticks.
  void add_errors(const Motion& motion, Differences& cords, Differences& bodies) const;
  /// Adds those of the two converged runs.
  void add_agreement(Differences& cords, Differences& bodies) const { add_errors(other_, cords, bodies); }

  int ticks() const { return part_.ticks; }
  int cord_ticks() const { return cord_ticks_; }  ///< number of ticks in which cords are compared
  int body_ticks() const { return body_ticks_; }  ///< number of ticks in which bodies are compared

 private:
  Part part_;
  Motion reference_, other_;
  int cord_ticks_ = 0;
  int body_ticks_ = 0;
};

}  // namespace ribbon::study
