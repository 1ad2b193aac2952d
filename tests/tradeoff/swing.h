#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "ribbon/vec2.h"

namespace tradeoff {

/// The rope of the heavy_swing scene (tests/support/exact_chain.h) by one method.
class Swing {
 public:
  Swing() = default;
  Swing(const Swing&) = delete;
  Swing& operator=(const Swing&) = delete;
  virtual ~Swing() = default;

  /// Restores the start of the scene, at rest.
  virtual void reset() = 0;
  /// Steps by 1/60 s.
  virtual void tick() = 0;
  /// Returns the points of the rope from the pin to the load, m.
  virtual std::vector<ribbon::Vec2> path() const = 0;
  /// Returns kinetic, potential and elastic energy, J; 0 at the start. May change the motion, so it is called once,
  /// after the last tick.
  virtual double energy() = 0;
  /// Returns the number of unconverged solves since the start; none if the method does not count them.
  virtual std::optional<int> unconverged() const { return std::nullopt; }
  /// Returns IslandReport::work of the last tick; none if the method does not count it.
  virtual std::optional<std::int64_t> work() const { return std::nullopt; }
};

/// The results of a whole run.
struct SwingFigures {
  std::vector<ribbon::Vec2> load;  ///< m, after each tick
  double max_stretch = 0.0;        ///< of the whole rope, relative, maximum after any tick
  double energy_drift = 0.0;  ///< final minus initial energy, relative to M·g·L, with M of rope and load; negative
                              ///< for a loss
  std::optional<int> unconverged;
};

SwingFigures run(Swing& swing);

/// Returns the kinetic and potential energy of a mass [kg] relative to rest at height 0, J.
double energy_of(double mass, ribbon::Vec2 position, ribbon::Vec2 velocity);

}  // namespace tradeoff
