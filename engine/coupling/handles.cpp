#include "ribbon/box2d/handles.h"

#include <utility>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/cord_cutting.h"
#include "ribbon/box2d/coupling_parts.h"
#include "ribbon/pulley.h"

namespace ribbon::box2d {
namespace {

/// Throws DefinitionError if a cord does not have a place.
void check_place(const CoupledCord& cord, int point, double along) {
  const auto points = static_cast<double>(cord.positions().size());
  check_range("point", point, 0, points - 1);
  if (along != 0.0) check_range("point", point, 0, points - 1 - cord.shape().rows);
  check_range("along", along, 0.0, 1.0);
}

}  // namespace

bool CordView::is_valid() const { return parts_->cords.find(id_) != nullptr; }
Solver CordView::solver() const { return parts_->cords.at(id_).solver(); }
CordShape CordView::shape() const { return parts_->cords.at(id_).shape(); }
const Cord& CordView::direct() const { return parts_->cords.at(id_).direct(); }
const ThesisCord& CordView::thesis() const { return parts_->cords.at(id_).thesis(); }
std::span<const Vec2> CordView::positions() const { return parts_->cords.at(id_).positions(); }

PointGrid CordView::grid() const {
  return std::visit([](const auto& of_solver) { return point_grid(of_solver); }, parts_->cords.at(id_).cord);
}

PointKind CordView::kind(int point) const {
  const CoupledCord& cord = parts_->cords.at(id_);
  check_place(cord, point, 0.0);
  return std::visit([point](const auto& of_solver) { return of_solver.kind(point); }, cord.cord);
}

Vec2 CordView::position(int point, double along) const {
  const CoupledCord& cord = parts_->cords.at(id_);
  check_place(cord, point, along);
  return cord.position(point, along);
}

double CordView::arc(int point, double along) const {
  const CoupledCord& cord = parts_->cords.at(id_);
  check_place(cord, point, along);
  const int column = point / cord.shape().rows;
  return cord.arc_at(column + along);
}

const b2Filter& CordView::filter() const { return parts_->cords.at(id_).filter; }
bool CordView::is_enabled() const { return parts_->cords.at(id_).enabled; }
std::uintptr_t CordView::user_data() const { return parts_->cords.at(id_).user_data; }
std::span<const FixtureTouch> CordView::touching() const { return parts_->cords.at(id_).touching; }
std::span<const std::uint64_t> CordView::sensors() const { return parts_->cords.at(id_).sensing; }
std::span<const NearShape> CordView::near() const { return parts_->cords.at(id_).near; }

int CordView::near_count() const {
  const CoupledCord& cord = parts_->cords.at(id_);
  return static_cast<int>(cord.circles.size() + cord.segments.size());
}

Box CordView::swept_aabb() const { return parts_->cords.at(id_).swept_aabb; }
const CordReport& CordView::report() const { return parts_->cords.at(id_).report; }
const IslandReport& CordView::island_report() const { return parts_->cords.at(id_).island_report; }
const IslandReport& CordView::island_total() const { return parts_->cords.at(id_).island_total; }
double CordView::error() const { return parts_->cords.at(id_).error; }
const StepReport& CordView::thesis_report() const { return parts_->cords.at(id_).thesis_report; }
const StepReport& CordView::thesis_total() const { return parts_->cords.at(id_).thesis_total; }

Cord& CordRef::direct() const { return parts_->cords.at(id()).direct(); }
ThesisCord& CordRef::thesis() const { return parts_->cords.at(id()).thesis(); }

void CordRef::drag(int point, Vec2 target) const {
  std::visit([=](auto& of_solver) { of_solver.operate(point, target); }, parts_->cords.at(id()).cord);
}

void CordRef::pin(int point, Vec2 target) const {
  std::visit([=](auto& of_solver) { of_solver.constrain(point, target); }, parts_->cords.at(id()).cord);
}

void CordRef::free(int point) const {
  std::visit([=](auto& of_solver) { of_solver.release(point); }, parts_->cords.at(id()).cord);
}

void CordRef::set_enabled(bool enabled) const {
  CoupledCord& cord = parts_->cords.at(id());
  parts_->cords.activate(cord);
  cord.enabled = enabled;
  if (enabled) return;
  parts_->detach(id());
  cord.report = {};
  cord.island_report = {};
  cord.error = 0.0;
  cord.thesis_report = {};
}

CutEvent CordRef::cut(double arc) const {
  const CoupledCord& cord = parts_->cords.enabled(id());
  const CutPlace where = cut_at(cord.direct(), arc);
  check_between_ticks(*parts_, "cut");
  return cut_cord(*parts_, id(), where);
}

CutEvent CordRef::cut_along(int row) const {
  const CoupledCord& cord = parts_->cords.enabled(id());
  const CutPlace where = ribbon::cut_along(cord.direct(), row);
  check_between_ticks(*parts_, "cut");
  return cut_cord(*parts_, id(), where);
}

void CordRef::set_user_data(std::uintptr_t data) const { parts_->cords.at(id()).user_data = data; }

void CordRef::replace(Cord cord, const b2Filter& filter) const {
  CoupledCord& old = parts_->cords.at(id());
  (void)old.direct();  // refuses the other solver
  CoupledCord coupled(std::move(cord), filter);
  check_without_pulleys(coupled);
  parts_->cords.activate(old);
  parts_->detach(id());
  coupled.id = id();
  coupled.user_data = old.user_data;
  coupled.reserve();
  coupled.touching = old.touching;
  coupled.sensing = old.sensing;
  old = std::move(coupled);
}

bool GripView::is_valid() const { return parts_->grips.find(id_) != nullptr; }

GripState GripView::state() const {
  const BodyGrip& grip = parts_->grips.at(id_);
  const CoupledCord& cord = parts_->cords.at(grip.cord);
  return {grip.cord,
          cord.arc_at(column_of(grip, cord)),
          cord.position(grip.point, grip.along),
          parts_->pull(grip),
          grip.slips,
          grip.point,
          grip.along};
}

void GripRef::climb(double arc, double speed) const {
  BodyGrip& grip = parts_->grips.at(id());
  const CoupledCord& cord = parts_->cords.at(grip.cord);
  const Cord& direct = cord.direct();
  check_arc(cord, arc);
  if (!(speed > 0.0)) refuse("speed", speed, "above 0, up to 1e+06");
  check_range("speed", speed, 0.0, 1e6);
  grip.climb_to = cord.column_at(arc);
  grip.climb_speed = speed / direct.rest_length(0);
}

void GripRef::move_anchor(b2Vec2 local_anchor) const {
  BodyGrip& grip = parts_->grips.at(id());
  check_coordinates("local_anchor", to_double(local_anchor));
  grip.next_anchor = local_anchor;
}

bool GripRef::release() const { return parts_->release(id()); }

bool PulleyView::is_valid() const { return parts_->pulleys.find(id_) != nullptr; }

PulleyState PulleyView::state() const {
  const BodyPulley& pulley = parts_->pulleys.at(id_);
  const Pulley& of_cord = pulleys_of(parts_->cords.at(pulley.cord).direct())[static_cast<std::size_t>(pulley.index)];
  const bool exists = parts_->finder.exists(pulley.seen);  // its body may be destroyed
  return {pulley.cord,
          exists ? to_double(pulley.body->GetWorldPoint(pulley.local_anchor)) : of_cord.def.center,
          of_cord.angle,
          of_cord.turning,
          of_cord.speed,
          of_cord.arc,
          of_cord.tension_before,
          of_cord.tension_after,
          of_cord.slip_sign != 0.0,
          of_cord.def};
}

void PulleyRef::set_motor(double speed, double torque) const {
  const BodyPulley& pulley = parts_->pulleys.at(id());
  ribbon::set_motor(parts_->cords.at(pulley.cord).direct(), pulley.index, speed, torque);
}

bool PulleyRef::remove() const {
  check_between_ticks(*parts_, "remove");
  return parts_->remove_pulley(id());
}

bool TieView::is_valid() const { return parts_->ties.find(id_) != nullptr; }

TieState TieView::state() const {
  const TieMemory& tie = parts_->ties.at(id_);
  const auto position = [this](const TiePlace& place) {
    return parts_->cords.at(place.cord).position(place.point, 0.0);
  };
  return {tie.place.cord,
          tie.place.point,
          tie.other.cord,
          tie.other.point,
          position(tie.place),
          length(position(tie.other) - position(tie.place)),
          tie_force(tie, parts_->cords, parts_->conditions.gravity)};
}

bool TieRef::untie() const {
  check_between_ticks(*parts_, "untie");
  return parts_->untie(id());
}

Vec2 BodyView::velocity() const { return parts_->carry.velocity(*body_); }
double BodyView::angular_velocity() const { return parts_->carry.angular_velocity(*body_); }

std::optional<GripId> BodyView::first_grip() const {
  const BodyGrip* const held = parts_->grips.first_of(*body_);
  return held != nullptr ? std::optional(held->id) : std::nullopt;
}

std::optional<CordPoint> BodyView::held_place() const {
  const BodyGrip* const held = parts_->grips.first_of(*body_);
  if (held == nullptr) return std::nullopt;
  return CordPoint{held->cord, held->point, 0.0, held->along};
}

bool BodyRef::release() const {
  if (!first_grip()) return false;
  body_->SetAwake(true);
  parts_->carry.release(*body_);
  parts_->grips.forget(*body_);
  return true;
}

const IslandReport& StepView::report() const { return parts_->solver.total(); }
int StepView::islands() const { return parts_->islands; }
std::span<const TouchEvent> StepView::touch_events() const { return parts_->touches.events(); }
std::span<const SensorEvent> StepView::sensor_events() const { return parts_->sensors.events(); }
std::span<const CutEvent> StepView::cut_events() const { return parts_->cuts.events(); }
bool StepView::estimates_errors() const { return parts_->probe.has_value(); }
double StepView::medium_time() const { return parts_->medium_time; }

}  // namespace ribbon::box2d
