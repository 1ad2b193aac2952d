#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "ribbon/island/island.h"

// The substep that always ends: implicit Euler with contacts that are posed at most a few times and then kept, so that
// each linearisation of the cords leaves a convex problem, which has a solution and is solved in bounded work. Whatever
// iterate it ends with is one that may be kept.

namespace ribbon {
namespace {

constexpr int worth_trying = 48;      // Newton steps in a step, before its contacts are posed once
constexpr double tried_share = 0.35;  // of the work that a step may take, or after that
constexpr int most_pieces = 10;       // of a step
constexpr int most_posed_work = 70;   // linear systems, after which no piece is taken again,
constexpr int most_last_work = 45;    // and so many more, after which none is linearised again
constexpr double last_share = 0.5;    // of the work that a step may take, after which none is, either
constexpr double blow_share = 0.05;   // of the least reach, that anything goes in the piece that takes a blow
constexpr int patient_work = 10'000;  // of Accuracy::max_work
constexpr int posings = 3;            // times that contacts are looked for
constexpr int most_linearisations = 24;
constexpr int blow_linearisations = 2;  // of a piece that takes a blow: what moves so little changes no direction
constexpr int miss_linearisations = 3;  // more, for each time of
constexpr int most_misses = 4;          // times that contacts are posed anew that it would have missed
constexpr double far_share = 10.0;      // more than so many tolerances
constexpr int full_linearisations = 5;  // after which a step has to lessen the potential

constexpr double least_share = 1.0 / 64.0;
constexpr double penalty_factor = 2.0;
constexpr double most_motion = 1e12;  // m

}  // namespace

bool Island::is_tried(const CordReport& report) const {
  if (is_patient()) return false;
  return report.iterations - before_take_.iterations >= worth_trying ||
         static_cast<double>(report.work - before_take_.work) >= tried_share * most_work() ||
         is_spent(report, last_share);
}

bool Island::is_posed_out(const CordReport& report) const {
  return report.iterations >= most_iterations_ || is_spent(report);
}

/// Whether there is so much work to spend that what does not converge is taken by halves before its contacts are posed
/// once.
bool Island::is_patient() const { return accuracy_.max_work >= patient_work; }

/// The whole step, in pieces: where something would go through something on the way that all goes by itself, a piece
/// ends there, and a very short one takes the blow, by which nothing moves far. A piece that is not solved, or in which
/// something had to be kept from going through something, is taken again by half. Few pieces, and then all of the rest
/// as it comes.
void Island::posed_step(double dt, CordReport& report) {
  ++report.posed;
  begin_substep(0.0, dt);
  const Energy before = driven_ ? Energy{} : total_energy();
  const int enough = report.iterations + most_posed_work;
  most_iterations_ = enough + most_last_work;
  pressed_ = contacts_.pressing_energy();
  double time = 0.0;
  double most = dt;
  blown_ = blow_is_due_ = false;
  for (int piece = 1; time < dt; ++piece) {
    const double left = dt - time;
    const auto is_last = [&] {
      return piece >= most_pieces || report.iterations >= enough || is_spent(report, last_share);
    };
    const bool last = is_last();
    const double share = last ? left : std::min(most, next_piece(time, left));
    if (last) blown_ = blow_is_due_ = false;
    const bool solved = posed_piece(time, share, report);
    const bool good = !was_cut_ && solved;
    if (!good && !last && !(share == left && is_last())) {  // nor the same again
      return_to_start();
      most = 0.5 * share;
      blown_ = true;  // or nothing was in the way
      blow_is_due_ = false;
      continue;
    }
    if (!solved) {
      ++report.unconverged;
      report.position_error = std::max(report.position_error, std::min(left_open_, most_motion));
      report.force_error = std::max(report.force_error, left_force_);
    }
    if (end_piece(share) || was_cut_) ++report.cuts;
    time = share == left ? dt : time + share;
    most = dt - time;
  }
  if (!driven_) account(before);
}

/// s, up to a blow, or through it, or all that is left where there is none, or one that has just been taken.
double Island::next_piece(double start, double left) {
  if (std::exchange(blown_, false)) return left;
  if (!std::exchange(blow_is_due_, false)) {
    const double free = time_to_blow(start, left);
    blow_is_due_ = free < left;
    if (free > 0.0) return free;
  }
  blow_is_due_ = false;
  blown_ = true;
  return blow_time(left);
}

/// s, until something would be in something, if all of it went on as it goes; `most` if nothing would.
double Island::time_to_blow(double start, double most) {
  if (contacts_.empty()) return most;
  contacts_.place_led(start);
  contacts_.aim(start + most);
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    Vec2 way = most * velocities_[p];
    if (constrained_[p] != 0) {
      way = p < count_ ? most * drives_[p] : way;
    } else if (p < count_) {
      way += (most * most) * gravity_;
    }
    trial_[p] = positions_[p] + way;
  }
  return most * contacts_.share_to_blow(positions_, trial_);
}

/// s, in which nothing goes further than a small part of what may touch is thick.
double Island::blow_time(double most) const {
  double fastest = 0.0;
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    if (!is_angle(p)) fastest = std::max(fastest, length(velocities_[p]));
  }
  const double way = blow_share * contacts_.least_reach();
  return fastest * most > way ? way / fastest : most;
}

/// False if it was not solved.
bool Island::posed_piece(double start, double dt, CordReport& report) {
  begin_substep(start, dt);
  contacts_.scale_impulses(0.0);
  guarded_dt_ = dt;
  was_cut_ = false;
  if (!driven_) {
    piece_energy_ = total_energy();
    piece_energy_.elastic += pressed_ - contacts_.energy();
  }
  posing_ = true;
  has_pattern_ = false;
  const double tolerance = tolerance_;
  tolerance_ = std::max(dt / step_dt_ * tolerance_, std::min(least_tolerance_, tolerance_));
  const bool converged = implicit_euler(start, dt, report);
  tolerance_ = tolerance;
  posing_ = false;
  has_pattern_ = false;
  return converged;
}

/// What presses is energy by its forces: how deep pairs are does not tell, for their normals and places are kept. True
/// if some of it was taken back.
bool Island::end_piece(double dt) {
  const Energy before = piece_energy_;
  calm(before);
  bool back = go_back(before);
  if (!contacts_.empty()) {
    rebound(before, dt);
    keep_momentum(dt);
    if (driven_) back = limit_speeds() || back;
  }
  if (!driven_) energy_after_ = total_energy();
  restart_ = true;
  if (contacts_.empty()) return back;
  pressed_ = contacts_.energy();
  touch_changed_ = contacts_.changed();
  contacts_.finish(positions_);
  contacts_.scale_impulses(0.0);
  return back;
}

/// Cords start where they were, what drives them where it ends, and contacts are first looked for on the way that
/// everything goes by itself.
void Island::begin_posed(double time, std::span<const Vec2> from) {
  for (HeldBody& held : held_) held.slides = held.along_pull = 0.0;
  if (!contacts_.empty()) {
    contacts_.begin_stage();
    contacts_.aim(time);
    contacts_.lead(1.0);
    contacts_.pose_none();
    contacts_.pose(from, positions_);
  }
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    if (constrained_[p] == 0) positions_[p] = from[p];
  }
  std::fill(most_tensions_.begin(), most_tensions_.end(), 0.0);
}

bool Island::posed_steps(Stage& stage, double time, std::span<const Vec2> from, CordReport& report) {
  begin_posed(time, from);
  stage.min_geometric_ratio = Stage::definite_geometric_ratio;
  bool converged = false;
  left_open_ = std::numeric_limits<double>::infinity();
  left_force_ = 0.0;
  bool has_best = false;
  bool is_near = false;  // it is solved, but for bars that may be slack or taut
  int misses = 0;
  const int most = blown_ ? blow_linearisations : most_linearisations;
  for (int k = 0; k < most + misses * miss_linearisations && !converged && (k == 0 || !is_posed_out(report)); ++k) {
    const bool others = !contacts_.empty() && k > 0 && k < posings && contacts_.pose(from, positions_);
    append_limited(stage);
    if (k >= posings) {
      has_best = keep_best(stage, has_best);
      if (k == full_linearisations && go_to_best(stage)) append_limited(stage);
    }
    const bool far = k < posings && left_open_ > far_share * tolerance_;
    const Solve solve = solve_posed(stage, far, report);
    if (solve == Solve::failed) {
      // Tensions of what was torn apart make a matrix that is definite in no precision: once without them.
      if (k > 0) break;
      std::fill(tensions_.begin(), tensions_.end(), 0.0);
      continue;
    }
    const double moved = left_open_ = furthest();
    if (!(moved <= most_motion)) break;
    left_force_ = 0.0;
    for (std::size_t p = 0; p < count_; ++p) {
      left_force_ = std::max(left_force_, inertia_[p] * length(direction_[p]));
    }
    for (std::size_t e = 0; e < next_.size(); ++e) {
      most_tensions_[e] = std::max(most_tensions_[e], penalty_factor * std::abs(next_[e]));
    }
    const double share = k < full_linearisations ? 1.0 : posed_share(stage);
    is_near = k > 0 && moved <= tolerance_ && solve == Solve::exact && !slips_ && !others;
    if (share == 0.0) break;  // nearer than the potential can tell, or nowhere
    move(trial_, share);
    positions_.swap(trial_);
    tensions_.swap(next_);
    if (!contacts_.empty()) contacts_.take_forces(limited_, k < posings);
    take_slips();
    is_near = is_near && !stretches();
    converged = is_near && are_bars_settled(stage, k);
    if (converged && misses < most_misses && !contacts_.empty()) {
      keep_solved();
      if (!contacts_.pose_missed(from, positions_, tolerance_)) break;
      ++misses;
      converged = has_best = false;
    }
  }
  converged = converged || is_near;
  if (!converged && misses > 0) {
    return_to_solved();
    converged = true;
  } else if (!converged && has_best) {
    append_limited(stage);
    go_to_best(stage);
  }
  if (!contacts_.empty()) {
    was_cut_ = !keep_apart(from);
    contacts_.remember_hits(stage_weight_);
  }
  return converged || (blown_ && left_open_ < std::numeric_limits<double>::infinity());
}

/// What is solved but for what it has missed is returned to if that cannot be solved.
void Island::keep_solved() {
  solved_positions_ = positions_;
  solved_tensions_ = tensions_;
  solved_held_ = held_;
  contacts_.keep_forces();
}

void Island::return_to_solved() {
  positions_ = solved_positions_;
  tensions_ = solved_tensions_;
  held_ = solved_held_;
  contacts_.return_to_forces();
}

/// All limited rows about positions_.
void Island::append_limited(const Stage& stage) {
  limited_.clear();
  if (!contacts_.empty()) contacts_.append_rows(positions_, step_dt_ / stage.q, limited_);
  append_slips();
}

/// J, what the posed problem minimises, at x, its limited rows as they are linear about positions_.
double Island::posed_merit(const Stage& stage, std::span<const Vec2> x) {
  for (std::size_t p = 0; p < x.size(); ++p) direction_[p] = x[p] - positions_[p];
  return merit(stage, x) + limited_.potential(direction_, 1.0);
}

/// Whether positions_ are no better than the best before them.
bool Island::is_worse_than_best(const Stage& stage) {
  return !(posed_merit(stage, positions_) < posed_merit(stage, best_));
}

/// Keeps positions_ if they are better. True.
bool Island::keep_best(const Stage& stage, bool has_best) {
  if (has_best && is_worse_than_best(stage)) return true;
  best_ = positions_;
  best_tensions_ = tensions_;
  return true;
}

/// Returns to the best positions if these are no better; false if they are.
bool Island::go_to_best(const Stage& stage) {
  if (!is_worse_than_best(stage)) return false;
  positions_ = best_;
  tensions_ = best_tensions_;
  return true;
}

/// The first of 1, ½, ¼ … of the direction that lessens the stage's potential, 2 if that lessens it further, for what
/// is crushed is near its solution by half of the way that is left each time; 0 if none does.
double Island::posed_share(const Stage& stage) {
  const auto value = [&](double share) {
    move(trial_, share);
    return merit(stage, trial_) + limited_.potential(direction_, share);
  };
  const double before = value(0.0);
  for (double share = 1.0; share >= least_share; share *= 0.5) {
    const double after = value(share);
    if (!(after < before)) continue;
    return share == 1.0 && value(2.0) < after ? 2.0 : share;
  }
  return 0.0;
}

}  // namespace ribbon
