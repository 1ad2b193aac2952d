#include "ribbon/island/island.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "ribbon/island/sleep.h"
#include "ribbon/linear/index.h"
#include "ribbon/system/load_cords.h"
#include "ribbon/system/slips.h"
#include "ribbon/system/store_cords.h"
#include "ribbon/system/stretch.h"
#include "ribbon/system/supports.h"
#include "ribbon/system/wheel_end.h"
#include "ribbon/system/wheel_points.h"

namespace ribbon {
namespace {

constexpr std::size_t heap_cords = 8;      // a heap has so many or more,
constexpr std::size_t heap_pairs = 600;    // and of so many points and links that may touch
constexpr int max_settled = 6;             // times that a step finds out which cords slip in their grooves
constexpr std::size_t usual_touches = 16;  // of a cord that may touch something: it has memory for so many
// Of Cord::State::depenetration_share: factors after a step that was taken back, and after any other; the least share.
constexpr double slower_depenetration = 0.25;
constexpr double faster_depenetration = 2.0;
constexpr double min_depenetration_share = 1.0 / 32.0;
// Of Cord::State::newton_pause, after a step in which Newton's method has failed again: outside heaps, and in them.
constexpr int usual_newton_pause = 4;
constexpr int newton_pause_in_heaps = CordParts::max_newton_pause;

/// Removing a penetration takes energy, f·p of a contact that presses with f. If the step gained it and was taken back,
/// the next one would do the same, and hang. So it removes less, and later ones more again.
void store_depenetration(const IslandState& state) {
  for (const Member& member : state.members) {
    double& share = member.cord->state.depenetration_share;
    share = state.taken_back ? std::max(min_depenetration_share, slower_depenetration * share)
                             : std::min(1.0, faster_depenetration * share);
  }
}

/// Returns whether Newton's method is left out, because it has failed in the last steps. Not where points are tied:
/// what is apart is drawn together otherwise.
bool pauses_newton(std::span<const IslandCord> cords, std::span<const TiedPoint> tied) {
  return tied.empty() && std::all_of(cords.begin(), cords.end(),
                                     [](const IslandCord& cord) { return cord.cord->parts().state.newton_pause > 1; });
}

/// How inverted cells are turned back.
enum class Turning { tried, left_out, at_any_cost };

/// Leaves cells as they are.
void leave_cells(IslandState& state) {
  for (const Member& member : state.members) member.cord->elasticity->lock();
  state.unlocking = false;
}

bool has_deep_inversion(const IslandState& state) {
  return std::any_of(state.members.begin(), state.members.end(), [&](const Member& member) {
    return member.cord->elasticity->has_deep_inversion(IslandState::points_of(member, state.positions));
  });
}

}  // namespace

/// A step in which something leaves its motion bound is redone with a larger one. One with tied points apart, in which
/// a cord stretches or a substep does not converge, is redone: first with these points at their distance, then without
/// their ties. A step in which a substep does not converge is redone with contacts that are linearised once, and with
/// these ties again, unless they stretch a cord. In heaps, that solve is truncated. Where it leaves a cord
/// stretched that nothing drives, and the budget is large, the step is taken by halves after all, and what they do not
/// solve is kept. If turning inverted cells back gains much energy, they are left as they are, unless they are deeply
/// inverted then. Rings are for a step that Newton's method solves: without it, what has no points to be bent at would
/// be stopped or stretched.
IslandReport Island::step(std::span<const IslandCord> cords, std::span<const TiedPoint> tied,
                          std::span<RigidBody> bodies, double dt, Vec2 gravity, std::span<CordReport> reports) {
  assert(dt > 0.0 && dt <= 1.0 && is_finite(gravity));
  if (try_sleep(cords, bodies, gravity)) {
    std::fill(reports.begin(), reports.end(), CordReport{});
    return {};
  }
  state_.dt = dt;
  state_.gravity = gravity;
  state_.rigid = bodies;
  contacts_.impacts.record_pushes(
      std::any_of(cords.begin(), cords.end(), [](const IslandCord& cord) { return cord.records_pushes; }));
  work_ = {};
  bounds_.begin_step(cords.size());
  pausing_newton_ = pauses_newton(cords, tied);
  if (pausing_newton_) bounds_.enlarge_for_linearised();
  bring_together(cords, tied);
  const std::span<const IslandCord> given = cords;
  rings_.begin_step();
  cords = rings_.thread(given, tied, bodies, dt, !pausing_newton_);
  bool found_begun = false;
  move_points_over_wheels(cords, tied, bodies, dt, true);
  ApartTies apart = ApartTies::drawn;
  int settled = 0;
  bool keeps_unsolved = false;
  bool linearised = pausing_newton_;
  Turning turning = Turning::tried;
  for (;;) {
    begin_attempt(cords, tied, apart);
    if (turning == Turning::left_out) leave_cells(state_);
    state_.turned_at_any_cost = turning == Turning::at_any_cost;
    state_.keeps_unsolved = keeps_unsolved;
    state_.turning_cells = state_.unlocking && !linearised && !truncates(linearised);
    const bool solved = take_substeps(linearised);
    bool begins_to_slide = false;
    if (state_.ties.apart && (!solved || is_stretched_by_step(state_))) {
      apart = state_.ties.closing ? ApartTies::kept : ApartTies::released;
    } else if (!solved && state_.turning_gained) {
      turning = Turning::left_out;
    } else if (solved && turning == Turning::left_out && has_deep_inversion(state_)) {
      turning = Turning::at_any_cost;
      linearised = pausing_newton_;
    } else if (!solved) {
      linearised = true;
      apart = ApartTies::kept;
      bounds_.enlarge_for_linearised();
    } else if (!linearised && !std::exchange(found_begun, true) && rings_.find_begun(state_, tied, bodies, dt)) {
      begins_to_slide = true;
    } else if (linearised && !keeps_unsolved && work_.has_large_budget() && !state_.driven &&
               largest_strain(state_, state_.positions) > max_strain) {
      linearised = false;
      keeps_unsolved = true;
    } else if ((linearised || !bounds_.enlarge(state_)) && (++settled == max_settled || settle_wheels(state_))) {
      break;
    }
    reset_rest_lengths(state_);
    if (!solved || begins_to_slide) cords = rings_.undo();
    if (begins_to_slide) cords = rings_.thread(given, tied, bodies, dt, true);
    move_points_over_wheels(cords, tied, bodies, dt, begins_to_slide);
  }
  work_.report.work += contacts_.scene.candidates.take_checks();
  store_newton_pause(linearised);
  end_step();
  rings_.take_off(state_);
  write_reports(reports);
  return work_.report;
}

void Island::begin_attempt(std::span<const IslandCord> cords, std::span<const TiedPoint> tied, ApartTies apart) {
  load_cords(state_, cords, tied, apart);
  guard_.begin_step(state_);
  stages_.begin_step();
  candidates_.find(state_, bounds_, contacts_);
  add_supporting_bodies(state_);
  // First without the slots of bodies and grips, so that these are zero in all arrays, whatever was solved before.
  resize(state_.points, state_.tensions.size());
  if (!state_.bodies.empty() || !state_.wheels.empty()) {
    resize(state_.points + 2 * state_.bodies.size() + state_.wheels.size(),
           state_.tensions.size() + 2 * state_.wheels.size() + 2 * state_.held.size());
  }
  load_bodies(state_);
  if (bounds_.enabled()) bounds_.store_start(state_);
  if (bounds_.enabled() || state_.coupled) stages_.reserve_linearised(state_, contacts_);
  EnergyGuard::find_frame(state_, contacts_);
  state_.driven = state_.driven || state_.ties.closing;
  guard_.find_scale(state_);
  guard_.begin_pushes(state_);
  work_.begin_attempt(state_);
}

/// Returns whether the attempt is a truncated solve. Where everything lies on everything, the error of a few linear
/// systems is lost in that of the heap. If no cord asks for more than scenery needs, nothing else is tried first.
/// While Newton's method turns cells back, no gain of energy makes it fail, so a smaller heap is truncated then too.
bool Island::truncates(bool linearised) const {
  const std::size_t pairs = contacts_.scene.pairs.size();
  const bool is_heap = state_.members.size() >= heap_cords && (pairs >= heap_pairs || (state_.unlocking && pairs > 0));
  return is_heap && (pausing_newton_ || linearised != state_.accuracy.soft_contacts);
}

/// Returns false if a substep did not converge.
bool Island::take_substeps(bool linearised) {
  const bool truncated = truncates(linearised);
  const double dt = state_.dt / state_.accuracy.substeps;
  aim_slips(state_, linearised || truncated ? state_.dt : dt);
  if (truncated && linearised_step_.take_truncated(context(), restitution_)) return true;
  if (linearised) {
    linearised_step_.take(context(), restitution_, !truncated);
    return true;
  }
  if (truncated) return false;
  for (int n = 0; n < state_.accuracy.substeps; ++n) {
    if (n > 0 && follow_slips(state_, dt)) stages_.discard_pattern();
    if (!substeps_.take(context(), n * dt, dt, restitution_)) return false;
    Rings::watch(state_);
  }
  return true;
}

void Island::end_step() {
  if (state_.unlocking) ++work_.report.unlocked;
  guard_.end_pushes(state_);
  store_cords(state_);
  guard_.store(state_);
  store_touches();
  store_depenetration(state_);
  store_bodies(state_);
  store_support_forces(state_);
  count_rest_time(state_, work_.report);
}

/// Where Newton's method has failed in two steps, one after the other, it mostly does so again, at the cost of as many
/// linear systems as the linearised solve takes. So it is left out in three steps, or fewer if one of them turns out to
/// be easy; in a heap, whose solve takes few systems and does not tell, in fifteen. A single failure is mostly an
/// impact. A large budget is for as much as Newton's method needs.
void Island::store_newton_pause(bool linearised) {
  const bool pauses = linearised && !work_.has_large_budget() && (work_.was_hard() || truncates(true));
  for (const Member& member : state_.members) {
    int& pause = member.cord->state.newton_pause;
    if (!pauses) {
      pause = 0;
    } else if (pausing_newton_) {
      --pause;
    } else {
      pause = pause == 0 ? 1 : truncates(true) ? newton_pause_in_heaps : usual_newton_pause;
    }
  }
}

/// Stores what touches at the end of the step, or has been hit in it.
void Island::store_touches() {
  for (const Member& member : state_.members) {
    auto& touches = member.cord->state.touches;
    touches.clear();
    if (!contacts_.empty()) touches.reserve(usual_touches);
    member.cord->state.touch_changed = state_.touch_changed;
  }
  for (const ContactPair& pair : contacts_.scene.pairs.all()) {
    if (!(pair.touch.force > 0.0 || pair.touch.impulse > 0.0) && pair.touch.push == Vec2{}) continue;
    state_.members[pair.cord].cord->state.touches.push_back(pair.touch);
  }
  for (const Member& member : state_.members) {
    auto& touches = member.cord->state.touches;
    std::sort(touches.begin(), touches.end(), [](const Touch& a, const Touch& b) { return a.place_before(b); });
  }
}

/// A contact of two cords is stored by the one whose point touches the other.
void Island::write_reports(std::span<CordReport> reports) const {
  for (std::size_t m = 0; m < state_.members.size(); ++m) reports[m] = state_.members[m].report;
  const auto count = [&reports](std::size_t member, double force) {
    ++reports[member].contacts;
    reports[member].max_normal_force = std::max(reports[member].max_normal_force, force);
  };
  for (const ContactPair& pair : contacts_.scene.pairs.all()) {
    if (!(pair.touch.force > 0.0 || pair.touch.impulse > 0.0)) continue;
    count(pair.cord, pair.touch.force);
    if (!pair.is_mutual) continue;
    const auto behind = std::upper_bound(state_.members.begin(), state_.members.end(), at(pair.a),
                                         [](std::size_t slot, const Member& m) { return slot < m.first_point; });
    const auto other = static_cast<std::size_t>(behind - state_.members.begin()) - 1;
    if (other != pair.cord) count(other, pair.touch.force);
  }
}

void Island::resize(std::size_t slots, std::size_t tensions) {
  state_.resize(slots, tensions);
  const Sizes sizes{slots, tensions, state_.held.size()};
  if (sizes == sizes_) return;
  stages_.resize(slots, tensions, state_.held.size());
  substeps_.resize(slots, tensions);
  linearised_step_.resize(slots, tensions);
  restitution_.resize(slots);
  sizes_ = sizes;  // last, in case memory runs out before
}

void Island::reserve(const CordParts& cord, std::size_t grips) {
  state_.members.reserve(1);
  state_.held.reserve(grips);
  state_.bodies.reserve(grips);
  stages_.reserve(grips);
  bounds_.begin_step(1);
  resize(cord.size() + 2 * grips, cord.state.tensions.size() + 2 * grips);
}

}  // namespace ribbon
