// Functions of Coupling for cords of both solvers: the only place that distinguishes the two.

#include <algorithm>

#include "ribbon/box2d/coupling.h"

namespace engine {
namespace {

using ribbon::Vec2;

CordShape shape_of(const ribbon::ThesisCord& cord) {
  const ribbon::Mesh& mesh = cord.mesh();
  return {mesh.w, mesh.h, (mesh.h - 1) * mesh.spacing, true};
}

CordShape shape_of(const ribbon::Cord& cord) {
  const ribbon::CordDef& def = cord.def();
  const bool braced = def.rows > 1 && def.elements == ribbon::Elements::bars;
  return {def.points, def.rows, def.width + 2.0 * def.radius, braced};
}

}  // namespace

std::string_view solver_name(Solver solver) { return solver == Solver::direct ? "direct" : "thesis"; }

Solver Coupling::solver(CordIndex index) const {
  return std::holds_alternative<ribbon::Cord>(cords_[at(index)].cord) ? Solver::direct : Solver::thesis;
}

CordShape Coupling::shape(CordIndex index) const {
  return std::visit([](const auto& cord) { return shape_of(cord); }, cords_[at(index)].cord);
}

std::span<const Vec2> Coupling::positions(CordIndex index) const {
  return std::visit([](const auto& cord) { return cord.positions(); }, cords_[at(index)].cord);
}

ribbon::PointKind Coupling::kind(CordIndex index, int point) const {
  return std::visit([point](const auto& cord) { return cord.kind(point); }, cords_[at(index)].cord);
}

bool Coupling::may_be_within(CordIndex index, Vec2 position, double distance) const {
  if (!is_enabled(index)) return false;
  if (solver(index) == Solver::thesis) return true;
  return overlap(widened(cord(index).sweep().box, distance), {position, position});
}

std::optional<CordPoint> Coupling::nearest_point(Vec2 position, double reach) const {
  std::optional<CordPoint> nearest;
  for (CordIndex c = 0; c < size(); ++c) {
    if (!may_be_within(c, position, nearest ? nearest->distance : reach)) continue;
    const auto positions = this->positions(c);
    for (std::size_t p = 0; p < positions.size(); ++p) {
      const double distance = length(positions[p] - position);
      if (!(distance <= reach) || (nearest && distance >= nearest->distance)) continue;
      nearest = CordPoint{c, static_cast<int>(p), distance};
    }
  }
  return nearest;
}

std::optional<CordPoint> Coupling::nearest_place(Vec2 position, double reach, std::optional<CordIndex> except) const {
  std::optional<CordPoint> nearest;
  for (CordIndex c = 0; c < size(); ++c) {
    if (c == except || !may_be_within(c, position, nearest ? nearest->distance : reach)) continue;
    const auto x = positions(c);
    const int rows = shape(c).rows;
    for (int p = 0; p < static_cast<int>(x.size()); ++p) {
      CordPoint place{c, p};
      if (p + rows < static_cast<int>(x.size()) && solver(c) == Solver::direct) {
        const Vec2 link = x[at(p + rows)] - x[at(p)];
        const double share = dot(position - x[at(p)], link) / dot(link, link);
        if (share >= 1.0) continue;  // nearer to the next one
        place.along = std::max(0.0, share);
      }
      place.distance = length(this->position(place) - position);
      if (!(place.distance <= reach) || (nearest && place.distance >= nearest->distance)) continue;
      nearest = place;
    }
  }
  return nearest;
}

Vec2 Coupling::position(const CordPoint& place) const {
  const auto x = positions(place.cord);
  if (place.along == 0.0) return x[at(place.point)];
  return x[at(place.point)] + place.along * (x[at(place.point + shape(place.cord).rows)] - x[at(place.point)]);
}

double Coupling::arc(const CordPoint& place) const {
  const int column = place.point / shape(place.cord).rows;
  return arc_at(place.cord, column + place.along);
}

void Coupling::operate(CordIndex index, int point, Vec2 target) {
  check_cord(index);
  std::visit([=](auto& cord) { cord.operate(point, target); }, cords_[at(index)].cord);
}

void Coupling::constrain(CordIndex index, int point, Vec2 target) {
  check_cord(index);
  std::visit([=](auto& cord) { cord.constrain(point, target); }, cords_[at(index)].cord);
}

void Coupling::release(CordIndex index, int point) {
  check_cord(index);
  std::visit([=](auto& cord) { cord.release(point); }, cords_[at(index)].cord);
}

int Coupling::gathered_near(CordIndex index) const {
  const CoupledCord& cord = cords_[at(index)];
  return static_cast<int>(cord.circles.size() + cord.segments.size());
}

}  // namespace engine
