#include "ribbon/stage/step_work.h"

#include <algorithm>

namespace ribbon {
namespace {

constexpr std::size_t blocks_per_point = 4;     // of the band matrix, by which work is counted
constexpr double large_budget_factor = 10'000;  // Accuracy::max_work from which on the budget is large
// Limits are those of a step of up to so many substeps. More substeps have proportionally more, because each solves its
// own stages: with the same limits, many substeps would end each step near contacts as one linearised step.
constexpr double substeps_of_limits = 4.0;
constexpr int easy_systems = 30;  // of a step
// An attempt ends after this number of Newton steps, or this share of the work; and this share in all attempts.
constexpr int max_attempt_systems = 48;
constexpr double attempt_share = 0.35;
constexpr double total_attempts_share = 0.5;
// Halved substeps:
constexpr double halving_share = 0.5;
constexpr int max_halving_systems = 180;
// A linearised step: linear systems, or the share of the work, after which no piece is redone; and so many more, after
// which none is linearised again. Where the step was tried more than once before, fewer, down to these, unless the
// budget is large.
constexpr int max_linearised_systems = 70;
constexpr int min_linearised_systems = 40;
constexpr double linearised_share = 0.5;
constexpr int max_last_systems = 45;
constexpr int min_last_systems = 30;

}  // namespace

void StepWork::begin_attempt(const IslandState& state) {
  report.unconverged = report.cuts = 0;
  report.position_error = report.force_error = 0.0;
  points_ = state.points;
  attempt_iterations_ = report.iterations;
  attempt_work_ = report.work;
  max_work_factor_ = state.accuracy.max_work;
  scale_ = std::max(1.0, state.accuracy.substeps / substeps_of_limits);
  max_work_ = static_cast<double>(blocks_per_point) * static_cast<double>(points_ + state.bodies.size()) * scale_ *
              max_work_factor_;
}

void StepWork::begin_linearised() {
  const int usual = static_cast<int>(scale_ * max_attempt_systems);
  const int more = has_large_budget() ? 0 : std::max(0, report.iterations - usual);
  last_redone_ = report.iterations + std::max(min_linearised_systems, max_linearised_systems - more);
  const int most = max_linearised_systems + max_last_systems;
  last_linearised_ = report.iterations + std::max(min_linearised_systems + min_last_systems, most - more);
}

void StepWork::count_system(std::size_t blocks, std::int64_t tested_pairs) {
  ++report.iterations;
  report.work += static_cast<std::int64_t>(blocks > 0 ? blocks : blocks_per_point * points_);
  report.work += tested_pairs;
}

bool StepWork::has_spent(double share) const { return static_cast<double>(report.work) >= share * max_work_; }

bool StepWork::has_large_budget() const { return max_work_factor_ >= large_budget_factor; }

bool StepWork::was_hard() const { return report.iterations > scale_ * easy_systems; }

bool StepWork::attempt_is_over(double share) const {
  if (has_large_budget()) return false;
  return report.iterations - attempt_iterations_ >= share * scale_ * max_attempt_systems ||
         static_cast<double>(report.work - attempt_work_) >= share * attempt_share * max_work_ ||
         has_spent(total_attempts_share);
}

bool StepWork::halving_is_over(bool unlocking) const {
  return has_spent(halving_share) ||
         (!has_large_budget() && !unlocking && report.iterations >= scale_ * max_halving_systems);
}

bool StepWork::redoing_is_over() const {
  return report.iterations >= last_redone_ || has_spent(has_large_budget() ? 1.0 : linearised_share);
}

bool StepWork::linearising_is_over() const { return report.iterations >= last_linearised_ || has_spent(); }

}  // namespace ribbon
