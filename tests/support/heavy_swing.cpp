#include "tests/support/heavy_swing.h"

#include <algorithm>
#include <cmath>

namespace test_support {

using ribbon::Vec2;

ribbon::Rope heavy_swing(double stiffness, int substeps, double tolerance) {
  ribbon::RopeDef def;
  def.stretch_stiffness = stiffness;
  def.substeps = substeps;
  def.tolerance = tolerance;
  def.pins = {0};
  ribbon::Rope rope(def);
  rope.attach_mass(50, 70.0);
  return rope;
}

HeavySwingRun run_heavy_swing(double stiffness, int substeps, double tolerance) {
  ribbon::Rope rope = heavy_swing(stiffness, substeps, tolerance);
  HeavySwingRun run;
  for (int tick = 0; tick < 300; ++tick) {
    const ribbon::RopeReport report = rope.step(1.0 / 60.0, {0.0, -9.81});
    run.report.iterations += report.iterations;
    run.report.fallbacks += report.fallbacks;
    run.report.unconverged += report.unconverged;
    run.load.push_back(rope.positions().back());
    double sum = 0.0;
    for (std::size_t p = 1; p < rope.positions().size(); ++p) {
      sum += length(rope.positions()[p] - rope.positions()[p - 1]);
    }
    run.peak_stretch = std::max(run.peak_stretch, sum / rope.def().length - 1.0);
  }
  return run;
}

double rms_distance(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += dot(a[k] - b[k], a[k] - b[k]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

}  // namespace test_support
