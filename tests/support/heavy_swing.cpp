#include "tests/support/heavy_swing.h"
#include "ribbon/cord_forces.h"

#include <algorithm>
#include <cmath>

namespace test_support {

using ribbon::Vec2;

ribbon::Cord heavy_swing(double stiffness, const ribbon::Accuracy& accuracy) {
  ribbon::CordDef def;
  def.stretch_stiffness = stiffness;
  def.accuracy = accuracy;
  def.pins = {0};
  ribbon::Cord cord(def);
  cord.attach_mass(50, 70.0);
  return cord;
}

HeavySwingRun run_heavy_swing(double stiffness, const ribbon::Accuracy& accuracy) {
  ribbon::Cord cord = heavy_swing(stiffness, accuracy);
  const Vec2 gravity{0.0, -9.81};
  const double start = energy_of(cord, gravity).total();
  HeavySwingRun run;
  for (int tick = 0; tick < 300; ++tick) {
    run.report += cord.step(1.0 / 60.0, gravity);
    run.load.push_back(cord.positions().back());
    double sum = 0.0;
    for (std::size_t p = 1; p < cord.positions().size(); ++p) {
      sum += length(cord.positions()[p] - cord.positions()[p - 1]);
    }
    run.peak_stretch = std::max(run.peak_stretch, sum / cord.def().length - 1.0);
  }
  run.lost_energy = (start - energy_of(cord, gravity).total()) / (71.0 * 9.81 * 10.0);
  return run;
}

double rms_distance(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += dot(a[k] - b[k], a[k] - b[k]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

}  // namespace test_support
