#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "ribbon/vec2.h"

namespace tradeoff {

/// The rope of the heavy_swing scene (tests/support/exact_chain.h) as one method makes it.
class Swing {
 public:
  Swing() = default;
  Swing(const Swing&) = delete;
  Swing& operator=(const Swing&) = delete;
  virtual ~Swing() = default;

  /// Back to the start of the scene, at rest.
  virtual void reset() = 0;
  /// A sixtieth of a second.
  virtual void tick() = 0;
  /// Where the rope is, from the pin to the load, m.
  virtual std::vector<ribbon::Vec2> path() const = 0;
  /// Kinetic, potential and elastic, J; 0 at the start. Asked once, after the last tick: it may disturb the motion.
  virtual double energy() = 0;
  /// Solves since the start that did not reach their tolerance; nothing if the method does not know.
  virtual std::optional<int> unconverged() const { return std::nullopt; }
  /// CordReport::work of the last tick; nothing if the method counts none.
  virtual std::optional<std::int64_t> work() const { return std::nullopt; }
};

/// What a whole run came to.
struct SwingFigures {
  std::vector<ribbon::Vec2> load;  ///< m, after each tick
  double max_stretch = 0.0;        ///< of the whole rope's length, the most after any tick, as a share
  double energy_drift = 0.0;       ///< energy at the end less that at the start, as a share of M·g·L, M of rope and
                                   ///< load: below 0 it was lost
  std::optional<int> unconverged;
};

SwingFigures run(Swing& swing);

/// Kinetic and potential energy of a mass [kg] against the same at rest at height 0, J.
double energy_of(double mass, ribbon::Vec2 position, ribbon::Vec2 velocity);

}  // namespace tradeoff
