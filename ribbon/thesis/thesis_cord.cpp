#include "ribbon/thesis/thesis_cord.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "ribbon/linear/index.h"
#include "ribbon/thesis/thesis_parts.h"

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

void check_point(const ThesisParts& cord, int point) { check_range("point", point, 0, cord.mesh.size() - 1); }

void drive(ThesisParts& cord, int point, Vec2 target, PointKind kind) {
  check_point(cord, point);
  check_coordinates("target", target);
  cord.points.targets[at(point)] = target;
  cord.set_kind(point, kind);
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

ThesisParts::ThesisParts(const ThesisDef& cord_def, std::unique_ptr<LinearSolver> solver)
    : def(cord_def), mesh(make_mesh(def.w, def.h, def.spacing)), bodies(def, mesh) {
  points.positions = start_positions(def);
  const std::size_t n = points.positions.size();
  points.velocities.resize(n);
  points.targets.resize(n);
  points.kinds.assign(n, PointKind::free);
  points.inverse_mass.assign(n, 1.0 / def.point_mass);
  points.step_start = points.positions;
  points.substep_start = points.positions;
  if (def.bar_damping > 0.0) fem.emplace(def, mesh, std::move(solver));
  if (def.self_collision) self_collision.emplace(def, mesh);
}

void ThesisParts::set_kind(int point, PointKind kind) {
  points.kinds[at(point)] = kind;
  points.inverse_mass[at(point)] = kind == PointKind::free ? 1.0 / def.point_mass : 0.0;
}

ThesisCord::ThesisCord(const ThesisDef& def, std::unique_ptr<LinearSolver> solver)
    : parts_(std::make_unique<ThesisParts>(checked(def), std::move(solver))) {
  for (const int pin : def.pins) constrain(pin, positions()[at(pin)]);
}
ThesisCord::ThesisCord(ThesisCord&&) noexcept = default;
ThesisCord& ThesisCord::operator=(ThesisCord&&) noexcept = default;
ThesisCord::~ThesisCord() = default;

const Mesh& ThesisCord::mesh() const { return parts_->mesh; }
const ThesisDef& ThesisCord::def() const { return parts_->def; }
std::span<const Vec2> ThesisCord::positions() const { return parts_->points.positions; }
std::span<const Vec2> ThesisCord::velocities() const { return parts_->points.velocities; }
PointKind ThesisCord::kind(int point) const { return parts_->points.kinds[at(point)]; }
Vec2 ThesisCord::target(int point) const { return parts_->points.targets[at(point)]; }

void ThesisCord::constrain(int point, Vec2 target) { drive(*parts_, point, target, PointKind::constrained); }

void ThesisCord::operate(int point, Vec2 target) { drive(*parts_, point, target, PointKind::operated); }

void ThesisCord::release(int point) {
  check_point(*parts_, point);
  parts_->set_kind(point, PointKind::free);
}

void ThesisCord::reserve(std::size_t bodies, std::size_t circles, std::size_t grips) {
  parts_->bodies.reserve(bodies, circles, grips);
}

void ThesisCord::set_velocity(int point, Vec2 velocity) {
  check_point(*parts_, point);
  check_coordinates("velocity", velocity);
  parts_->points.velocities[at(point)] = velocity;
}

void ThesisCord::add_momentum(Vec2 momentum) {
  ThesisPoints& points = parts_->points;
  const auto free_points = std::count(points.kinds.begin(), points.kinds.end(), PointKind::free);
  check_coordinates("momentum", momentum);
  if (free_points == 0) return;
  const Vec2 gain = (1.0 / (parts_->def.point_mass * static_cast<double>(free_points))) * momentum;
  for (std::size_t p = 0; p < points.velocities.size(); ++p) {
    if (points.inverse_mass[p] > 0.0) points.velocities[p] += gain;
  }
}

void ThesisCord::check_state(const State& state) const {
  const std::size_t n = parts_->points.positions.size();
  if (state.positions.size() != n || state.velocities.size() != n || state.targets.size() != n ||
      state.kinds.size() != n) {
    throw DefinitionError("state is of another cord; accepted is one of " + std::to_string(n) + " points");
  }
  for (const auto* values : {&state.positions, &state.velocities, &state.targets}) {
    for (const Vec2 value : *values) check_coordinates("state", value);
  }
  for (const PointKind kind : state.kinds) check_range("state.kinds", static_cast<int>(kind), 0, 2);
}

ThesisCord::State ThesisCord::save() const {
  State state;
  save(state);
  return state;
}

void ThesisCord::save(State& state) const {
  const State& own = parts_->points;
  state = own;
}

void ThesisCord::restore(const State& state) {
  check_state(state);
  State& own = parts_->points;
  own = state;
  for (int p = 0; p < parts_->mesh.size(); ++p) parts_->set_kind(p, state.kinds[at(p)]);
}

}  // namespace ribbon
