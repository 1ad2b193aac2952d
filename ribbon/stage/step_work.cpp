#include "ribbon/stage/step_work.h"

namespace ribbon {
namespace {

constexpr std::size_t blocks_per_point = 4;  // of the band matrix, by which work is counted
constexpr double patient_factor = 10'000;    // Accuracy::max_work from which on a step is patient
// An attempt is worth this number of Newton steps, or this share of the work; and this share in all attempts.
constexpr int max_tried_systems = 48;
constexpr double tried_share = 0.35;
constexpr double total_tried_share = 0.5;
// Halved substeps:
constexpr double halving_share = 0.5;
constexpr int max_halving_systems = 180;
// A linearised step: linear systems, or the share of the work, after which no piece is redone; and so many more, after
// which none is linearised again.
constexpr int max_linearised_systems = 70;
constexpr double linearised_share = 0.5;
constexpr int max_last_systems = 45;

}  // namespace

void StepWork::begin_attempt(const IslandState& state) {
  points_ = state.points;
  attempt_iterations_ = report.iterations;
  attempt_work_ = report.work;
  max_work_factor_ = state.accuracy.max_work;
  max_work_ =
      static_cast<double>(blocks_per_point) * static_cast<double>(points_ + state.bodies.size()) * max_work_factor_;
}

void StepWork::begin_linearised() { linearised_iterations_ = report.iterations; }

void StepWork::count_system(std::size_t blocks, std::int64_t tested_pairs) {
  ++report.iterations;
  report.work += static_cast<std::int64_t>(blocks > 0 ? blocks : blocks_per_point * points_);
  report.work += tested_pairs;
}

bool StepWork::is_spent(double share) const { return static_cast<double>(report.work) >= share * max_work_; }

bool StepWork::is_patient() const { return max_work_factor_ >= patient_factor; }

bool StepWork::is_tried() const {
  if (is_patient()) return false;
  return report.iterations - attempt_iterations_ >= max_tried_systems ||
         static_cast<double>(report.work - attempt_work_) >= tried_share * max_work_ || is_spent(total_tried_share);
}

bool StepWork::is_halved_out(bool unlocking) const {
  return is_spent(halving_share) || (!is_patient() && !unlocking && report.iterations >= max_halving_systems);
}

bool StepWork::is_enough() const {
  return report.iterations >= linearised_iterations_ + max_linearised_systems || is_spent(linearised_share);
}

bool StepWork::is_exhausted() const {
  return report.iterations >= linearised_iterations_ + max_linearised_systems + max_last_systems || is_spent();
}

}  // namespace ribbon
