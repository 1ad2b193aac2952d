#include <algorithm>
#include <cmath>

#include "ribbon/island/island.h"

// The solve of a stage near contacts.

namespace ribbon {
namespace {

// Newton steps of a stage near contacts. Of those that end within 40, all but one in a hundred do within 14, in scenes
// made at random; what takes a few more is cheaper ended than posed.
constexpr int touching_iterations = 20;
constexpr int patient_touching_iterations = 40;  // where there is work to spend
constexpr std::size_t remembered_values = 3;     // of the merit, none of which a step has to go below but the greatest
constexpr int patient_iterations = 10;
constexpr double negligible_share = 1e-3;
constexpr double tolerated_rebound = 5e-4;  // of the scene's energy, that a rebound may gain
constexpr double penalty_factor = 2.0;      // by which the exact penalty of a search is above the tensions
constexpr double unsettled_share = 1e-2;  // of the tolerance, that forces which are not as expected may move something
constexpr double crawling_share = 0.1;    // of a step, less of which says that its contacts are not as expected
constexpr int enough_fulls = 2;           // of a stage with soft contacts
constexpr double shortest_step = 1e-6;    // of a Newton step, below which a search gives up
constexpr double most_motion = 1e12;      // m, of a Newton step, beyond which it is none

}  // namespace

/// Newton steps that go nowhere through anything, and down the stage's energy. They begin where the stage before ended
/// and go as far towards the guess as they can; what drives the cord goes its way along with them.
bool Island::touching_steps(Stage& stage, double time, std::span<const Vec2> from, CordReport& report) {
  contacts_.compliant.begin_stage(contacts_.scene.pairs);
  contacts_.scene.anchors.set_kinematic_targets(time);
  std::fill(most_tensions_.begin(), most_tensions_.end(), 0.0);
  values_.clear();
  for (std::size_t p = 0; p < positions_.size(); ++p) direction_[p] = positions_[p] - from[p];
  std::copy(from.begin(), from.end(), positions_.begin());
  double left = 1.0;  // of the way of what drives
  go_led(left);
  bool strict = false;
  const bool soft = accuracy_.soft_contacts;
  const double tolerated = soft ? unsettled_share * tolerance_ : 0.0;
  const int most = is_patient() ? patient_touching_iterations : touching_iterations;
  int fulls = 0;
  for (int iteration = 0; iteration < most && !is_tried(report); ++iteration) {
    count_system(report);
    if (left > 0.0) {
      for (std::size_t p = 0; p < positions_.size(); ++p) {
        direction_[p] = constrained_[p] != 0 ? predicted_[p] - positions_[p] : Vec2{};
      }
      go_led(left);
    }
    contacts_.find_for_solve(positions_, strict);
    if (!newton_step(stage)) return false;
    const double moved = furthest();
    if (!(moved <= most_motion)) return false;
    for (std::size_t e = 0; e < next_.size(); ++e) {
      most_tensions_[e] = std::max(most_tensions_[e], penalty_factor * std::abs(next_[e]));
    }
    move(trial_, 1.0);
    const double free =
        contacts_.sweep.collision_free_fraction(contacts_.scene, positions_, trial_, KinematicTime::current);
    const bool small = moved <= tolerance_ && free == 1.0;
    // In full, so that forces are balanced and momentum is kept to the last bits; but not for ever.
    const bool in_full = small && (soft || iteration < patient_iterations || moved <= negligible_share * tolerance_);
    if (in_full) ++fulls;
    const double share = in_full ? 1.0 : search(stage, free, iteration);
    if (share == 0.0) {
      if (!strict) {
        strict = true;
        continue;
      }
      // Nearer than the merit can tell, or nowhere.
      return small && left == 0.0 && ends_stage(from);
    }
    strict = !strict && share < crawling_share * free;
    positions_.swap(trial_);
    tensions_.swap(next_);
    if (!small || left > 0.0 || slips_ || !are_bars_settled(stage, iteration)) continue;
    if (contacts_.are_settled(positions_, tolerated) ||
        (soft && fulls >= enough_fulls && contacts_.active.are_shallow(contacts_.scene.pairs))) {
      return ends_stage(from);
    }
  }
  return false;
}

/// Whether positions_ may be the stage's solution; if so, who touches in it has been hit.
bool Island::ends_stage(std::span<const Vec2> from) {
  contacts_.active.update(contacts_.scene, positions_);
  contacts_.record_impacts(stage_weight_);
  return contacts_.sweep.path_is_clear(contacts_.scene, from, positions_);
}

/// Who was hit rebounds: an impulse, by one linear solve with the mass of everything in the way, that opens each
/// contact at its share of the speed that it was hit with, and leaves lengths as they change.
void Island::rebound(const Energy& before, double dt) {
  if (!contacts_.begin_restitution(positions_, v0_, velocities_, dt)) return;
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    inertia_[p] = masses_[p] / (dt * dt);
    force_[p] = {};
  }
  predicted_ = positions_;
  velocity_ = velocities_;
  Stage stage{dt, predicted_, velocity_, inertia_, force_, constrained_, carried_};
  has_pattern_ = false;
  const bool solved = newton_step_together(stage);
  contacts_.end_restitution(positions_);
  has_pattern_ = false;
  if (!solved) return;
  guess_ = velocities_;
  add_damping(-1.0);
  for (double share = 1.0; share > 0.1; share *= 0.8) {
    for (std::size_t p = 0; p < velocities_.size(); ++p) {
      if (constrained_[p] == 0) velocities_[p] = guess_[p] + (share / dt) * direction_[p];
    }
    restart_ = true;
    add_damping(1.0);
    if (!gained_energy(before, tolerated_rebound)) return;
    add_damping(-1.0);
  }
  velocities_ = guess_;
  add_damping(1.0);
}

/// As far along the direction as nobody is in the way, together with what of the led way is left.
void Island::go_led(double& left) {
  move(trial_, 1.0);
  const double share =
      contacts_.sweep.collision_free_fraction(contacts_.scene, positions_, trial_, KinematicTime::target);
  move(positions_, share);
  contacts_.scene.anchors.advance_kinematics(share);
  left *= 1.0 - share;
  if (left > 1e-9) return;
  left = 0.0;
  contacts_.scene.anchors.advance_kinematics(1.0);
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    if (constrained_[p] != 0) positions_[p] = predicted_[p];
  }
}

/// The first of share, share/2, … of the direction that takes the merit below one of the last few, for one that only
/// falls cuts steps along curved ways short (Grippo, Lampariello & Lucidi 1986); in the end only one that falls. 0 if
/// none does.
double Island::search(const Stage& stage, double share, int iteration) {
  values_.push_back(merit(stage, positions_));
  {
    while (values_.size() > (iteration > patient_iterations ? 1U : remembered_values)) values_.erase(values_.begin());
  }
  const double most = *std::max_element(values_.begin(), values_.end());
  for (; share >= shortest_step; share *= 0.5) {
    move(trial_, share);
    close_arms(trial_);
    if (merit(stage, trial_) < most) return share;
  }
  return 0.0;
}

}  // namespace ribbon
