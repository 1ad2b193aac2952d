#include "tests/tradeoff/swing.h"

#include <algorithm>

#include "tests/support/exact_chain.h"

namespace tradeoff {

namespace heavy = test_support::heavy;

SwingFigures run(Swing& swing) {
  SwingFigures figures;
  swing.reset();
  for (int tick = 0; tick < heavy::ticks; ++tick) {
    swing.tick();
    const std::vector<ribbon::Vec2> path = swing.path();
    double along = 0.0;
    for (std::size_t p = 1; p < path.size(); ++p) along += length(path[p] - path[p - 1]);
    figures.max_stretch = std::max(figures.max_stretch, along / heavy::length - 1.0);
    figures.load.push_back(path.back());
  }
  figures.unconverged = swing.unconverged();
  constexpr double mgl = (heavy::rope_mass + heavy::load_mass) * heavy::gravity * heavy::length;
  figures.energy_drift = swing.energy() / mgl;
  return figures;
}

double energy_of(double mass, ribbon::Vec2 position, ribbon::Vec2 velocity) {
  return mass * (0.5 * dot(velocity, velocity) + heavy::gravity * position.y);
}

}  // namespace tradeoff
