#include "ribbon/thesis/thesis_cord.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "ribbon/linear/index.h"
#include "ribbon/thesis/broad_phase.h"

namespace ribbon {
namespace {

std::vector<Vec2> start_positions(const ThesisDef& def) {
  if (!def.positions.empty()) return def.positions;
  const std::array<Vec2, 2> along_x = {Vec2{0.0, 0.0}, Vec2{1.0, 0.0}};
  return lay_along(along_x, def.w, def.h, def.spacing);
}

ThesisDef checked(ThesisDef def) {
  check(def);
  if (def.radius == 0.0) def.radius = 0.4 * def.spacing;
  return def;
}

}  // namespace

StepReport& StepReport::operator+=(const StepReport& other) {
  fem_skipped += other.fem_skipped;
  motion_limited += other.motion_limited;
  self_contacts += other.self_contacts;
  circle_contacts += other.circle_contacts;
  tangled_columns += other.tangled_columns;
  strained_bars += other.strained_bars;
  turned_over += other.turned_over;
  energy_gains += other.energy_gains;
  return *this;
}

ThesisCord::ThesisCord(const ThesisDef& def, std::unique_ptr<LinearSolver> solver)
    : def_(checked(def)),
      mesh_(std::make_unique<Mesh>(make_mesh(def.w, def.h, def.spacing))),
      solver_(std::move(solver)),
      positions_(start_positions(def)),
      velocities_(positions_.size()),
      targets_(positions_.size()),
      kinds_(positions_.size(), PointKind::free),
      inverse_mass_(positions_.size(), 1.0 / def.point_mass),
      substep_start_(positions_),
      step_start_(positions_) {
  if (def_.bar_damping > 0.0) {
    matrix_ = std::make_unique<BandedMatrix>(2 * mesh_->size(), 2 * def_.h + 3);
    force_.resize(2 * positions_.size());
  }
  if (def_.self_collision) {
    self_phase_ = std::make_unique<BroadPhase>(*mesh_, true);
    self_phase_->reserve(positions_.size());
    own_radii_.assign(positions_.size(), def_.radius);
    tangled_.resize(at(def_.w));
  }
  for (const int pin : def_.pins) constrain(pin, positions_[index(pin)]);
}
ThesisCord::ThesisCord(ThesisCord&&) noexcept = default;
ThesisCord& ThesisCord::operator=(ThesisCord&&) noexcept = default;
ThesisCord::~ThesisCord() = default;

void ThesisCord::check_point(int point) const {
  if (point < 0 || point >= mesh_->size()) {
    throw DefinitionError("point is " + std::to_string(point) + "; accepted is an index from 0 to " +
                          std::to_string(mesh_->size() - 1));
  }
}

void ThesisCord::drive(int point, Vec2 target, PointKind kind) {
  check_point(point);
  check_coordinates("target", target);
  targets_[index(point)] = target;
  set_kind(point, kind);
}

void ThesisCord::set_kind(int point, PointKind kind) {
  kinds_[index(point)] = kind;
  inverse_mass_[index(point)] = kind == PointKind::free ? 1.0 / def_.point_mass : 0.0;
}

void ThesisCord::constrain(int point, Vec2 target) { drive(point, target, PointKind::constrained); }

void ThesisCord::operate(int point, Vec2 target) { drive(point, target, PointKind::operated); }

void ThesisCord::release(int point) {
  check_point(point);
  set_kind(point, PointKind::free);
}

void ThesisCord::reserve(std::size_t bodies, std::size_t circles, std::size_t grips) {
  motions_.reserve(bodies);
  circle_offsets_.reserve(circles);
  circle_radii_.reserve(circles);
  circle_centers_.reserve(circles);
  circle_centers_before_.reserve(circles);
  grip_offsets_.reserve(grips);
  if (circles == 0) return;
  if (!circle_phase_) circle_phase_ = std::make_unique<BroadPhase>(*mesh_, false);
  circle_phase_->reserve(circles);
}

void ThesisCord::set_velocity(int point, Vec2 velocity) {
  check_point(point);
  check_coordinates("velocity", velocity);
  velocities_[index(point)] = velocity;
}

void ThesisCord::add_momentum(Vec2 momentum) {
  const auto free_points = std::count(kinds_.begin(), kinds_.end(), PointKind::free);
  check_coordinates("momentum", momentum);
  if (free_points == 0) return;
  const Vec2 gain = (1.0 / (def_.point_mass * static_cast<double>(free_points))) * momentum;
  for (std::size_t p = 0; p < velocities_.size(); ++p) {
    if (inverse_mass_[p] > 0.0) velocities_[p] += gain;
  }
}

void ThesisCord::check_state(const State& state) const {
  const std::size_t n = positions_.size();
  if (state.positions.size() != n || state.velocities.size() != n || state.targets.size() != n ||
      state.kinds.size() != n) {
    throw DefinitionError("state is of another cord; accepted is one of " + std::to_string(n) + " points");
  }
  for (const auto* values : {&state.positions, &state.velocities, &state.targets}) {
    for (const Vec2 value : *values) check_coordinates("state", value);
  }
  for (const PointKind kind : state.kinds) check_range("state.kinds", static_cast<int>(kind), 0, 2);
}

void ThesisCord::save(State& state) const {
  state.positions = positions_;
  state.velocities = velocities_;
  state.targets = targets_;
  state.kinds = kinds_;
}

void ThesisCord::restore(const State& state) {
  check_state(state);
  positions_ = state.positions;
  velocities_ = state.velocities;
  targets_ = state.targets;
  for (int p = 0; p < mesh_->size(); ++p) set_kind(p, state.kinds[index(p)]);
}

}  // namespace ribbon
