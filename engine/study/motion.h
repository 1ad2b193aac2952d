#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ribbon/box2d/coupling.h"
#include "ribbon/cord_def.h"
#include "ribbon/study/study.h"
#include "ribbon/vec2.h"

namespace ribbon::study {

/// Where everything is after a tick.
struct Frame {
  std::vector<std::pair<box2d::CordId, std::vector<Vec2>>> cords;  ///< m, points of the cords of the direct solver
  std::vector<Vec2> bodies;                                        ///< m, dynamic bodies
  std::int64_t work = 0;                                           ///< of the tick
  bool is_converged = true;

  bool operator==(const Frame&) const = default;
};

/// A part of a run, tick by tick.
struct Motion {
  std::vector<Frame> frames;
  std::string failure{};  ///< why it ended early; empty if it did not
};

/// Which part of a run is played, and how.
struct Part {
  int begin = 0;  ///< first tick that is written down
  int ticks = 0;
  std::optional<Accuracy> accuracy{};  ///< of all cords; none: each cord's own
  int lead_in = 0;                     ///< number of ticks before `begin` with lead_in_accuracy
  double kick = 0.0;  ///< m/s, added at `begin` to the horizontal velocity of all points and dynamic bodies
};

/// Plays a part. Before it and its lead-in the cords have their own settings.
Motion play(const MakeScene& make, const Part& part);

/// Adds a speed [m/s] to the horizontal velocity of all points and dynamic bodies.
void kick(b2World& world, box2d::Coupling& coupling, double speed);

/// The differences of places in two runs.
struct Differences {
  double squares = 0.0;  ///< m², their sum
  double count = 0.0;
  double most = 0.0;  ///< m

  void add(Vec2 off);
  Differences& operator+=(const Differences& other);
  /// Returns the RMS, m; 0 without any.
  double root() const;
};

/// Return the differences in a tick: of cords that both runs have with as many points, and of bodies if both have as
/// many.
Differences cord_differences(const Frame& a, const Frame& b);
Differences body_differences(const Frame& a, const Frame& b);

}  // namespace ribbon::study
