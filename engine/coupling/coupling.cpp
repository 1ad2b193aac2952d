#include "ribbon/box2d/coupling.h"

#include <string>
#include <utility>

namespace engine {
namespace {

// Room that every cord has from the start, so that the first circle to come near takes no memory.
constexpr std::size_t usual_bodies = 64;
constexpr std::size_t usual_grips = 8;
constexpr std::size_t usual_touches = 16;

/// What cords know each other by; fixtures are far below.
std::uint64_t cord_id(std::size_t index) { return (std::uint64_t{1} << 63U) + index; }

}  // namespace

void Coupling::make_room(CoupledCord& coupled) {
  coupled.circles.reserve(usual_bodies);
  coupled.segments.reserve(usual_bodies);
  coupled.near.reserve(usual_bodies);
  coupled.grips.reserve(usual_grips);
  coupled.grip_ids.reserve(usual_grips);
  coupled.touching.reserve(usual_touches);
  coupled.touched.reserve(usual_touches);
}

CordIndex Coupling::add(ribbon::ThesisCord cord, const b2Filter& filter) {
  cord.reserve(usual_bodies, usual_bodies, usual_grips);
  return add(CoupledCord{std::move(cord), filter});
}

CordIndex Coupling::add(ribbon::Cord cord, const b2Filter& filter) {
  cord.reserve(usual_grips);
  return add(CoupledCord{std::move(cord), filter});
}

CordIndex Coupling::add(CoupledCord coupled) {
  make_room(coupled);
  cords_.push_back(std::move(coupled));
  gathered_.reserve(usual_bodies);
  rigid_.reserve(usual_bodies);
  touch_events_.reserve(usual_touches);
  body_places_.reserve(usual_bodies);
  fixture_ids_.reserve(usual_bodies);
  new_fixtures_.reserve(usual_bodies);
  new_bodies_.reserve(usual_bodies);
  wanted_.reserve(usual_bodies);
  near_finder_.reserve(usual_bodies, cords_.size());
  looks_.reserve(cords_.size());
  return size() - 1;
}

void Coupling::replace(CordIndex index, ribbon::Cord cord, const b2Filter& filter) {
  check_cord(index);
  if (solver(index) != Solver::direct) {
    throw ribbon::DefinitionError("cord " + std::to_string(index) +
                                  " is of the thesis's solver; accepted is one of the direct solver");
  }
  let_go_of(index);
  cord.reserve(usual_grips);
  CoupledCord coupled{std::move(cord), filter};
  make_room(coupled);
  coupled.touching = cords_[at(index)].touching;
  cords_[at(index)] = std::move(coupled);
}

void Coupling::set_enabled(CordIndex index, bool enabled) {
  check_cord(index);
  CoupledCord& coupled = cords_[at(index)];
  coupled.enabled = enabled;
  if (enabled) return;
  let_go_of(index);
  coupled.direct_report = {};
  coupled.direct_error = 0.0;
  coupled.report = {};
}

void Coupling::step() {
  for (CordIndex c = 0; c < size(); ++c) {
    CoupledCord& coupled = cords_[at(c)];
    auto* thesis = std::get_if<ribbon::ThesisCord>(&coupled.cord);
    if (thesis == nullptr || !coupled.enabled) continue;
    coupled.report = thesis->step(dt_, gravity_, {rigid_, coupled.circles, coupled.grips});
    coupled.total += coupled.report;
    for (const ribbon::RigidCircle& circle : coupled.circles) gathered_[at(circle.body)].met = c;
    for (const ribbon::Grip& grip : coupled.grips) gathered_[at(grip.body)].met = c;
  }
  for (std::size_t b = 0; b < gathered_.size(); ++b) {
    if (gathered_[b].met >= 0) rigid_[b].may_sleep = false;  // one of the thesis's does not rest
  }
  step_direct();
}

void Coupling::step_direct() {
  direct_cords_.clear();
  for (CordIndex c = 0; c < size(); ++c) {
    CoupledCord& coupled = cords_[at(c)];
    auto* direct = std::get_if<ribbon::Cord>(&coupled.cord);
    if (direct == nullptr || !coupled.enabled) continue;
    direct_cords_.push_back({direct, {rigid_, coupled.circles, coupled.grips, coupled.segments}, cord_id(at(c))});
  }
  direct_reports_.resize(direct_cords_.size());
  if (probe_) probe_->foresee(direct_cords_, rigid_, dt_, gravity_);
  const SolverInput input{direct_cords_, rigid_, dt_, gravity_};
  if (watcher_ != nullptr) watcher_->before(input);
  direct_solver_.step(direct_cords_, rigid_, dt_, gravity_, direct_reports_);
  if (watcher_ != nullptr) watcher_->after(input, direct_reports_, direct_solver_.total());
  std::size_t k = 0;
  for (CoupledCord& coupled : cords_) {
    const auto* direct = std::get_if<ribbon::Cord>(&coupled.cord);
    if (direct == nullptr || !coupled.enabled) continue;
    if (probe_) coupled.direct_error = probe_->error(k, *direct);
    coupled.direct_report = direct_reports_[k++];
    if (!direct->is_asleep()) coupled.direct_total += coupled.direct_report;
  }
  follow_grips();
  find_touch_events();
}

void Coupling::use(const ribbon::ParallelFor& parallel_for) {
  ribbon::check(parallel_for);
  parallel_for_ = parallel_for;
  direct_solver_.use(parallel_for);
}

void Coupling::estimate_errors(bool wanted) {
  if (wanted == estimates_errors()) return;
  probe_.reset();
  if (wanted) probe_.emplace();
  for (CoupledCord& coupled : cords_) coupled.direct_error = 0.0;
}

void Coupling::apply() {
  for (std::size_t b = 0; b < gathered_.size(); ++b) {
    if (gathered_[b].body == nullptr || rigid_[b].inverse_mass == 0.0) continue;
    b2Body& body = *gathered_[b].body;
    if (rigid_[b].rests) {
      lay_to_rest(body);
    } else if (rigid_[b].met || (gathered_[b].holds && holder(body) != nullptr)) {
      lead(body, rigid_[b]);
    } else {
      let_run(body);
      if (gathered_[b].met >= 0) push(gathered_[b], rigid_[b]);
    }
  }
  let_go_who_must();
}

}  // namespace engine
