// What a Coupling tells of a cord of either solver: the one place that knows how to ask each.

#include "engine/coupling.h"

namespace engine {
namespace {

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

std::span<const ribbon::Vec2> Coupling::positions(CordIndex index) const {
  return std::visit([](const auto& cord) { return cord.positions(); }, cords_[at(index)].cord);
}

ribbon::PointKind Coupling::kind(CordIndex index, int point) const {
  return std::visit([point](const auto& cord) { return cord.kind(point); }, cords_[at(index)].cord);
}

void Coupling::operate(CordIndex index, int point, ribbon::Vec2 target) {
  check_cord(index);
  std::visit([=](auto& cord) { cord.operate(point, target); }, cords_[at(index)].cord);
}

void Coupling::release(CordIndex index, int point) {
  check_cord(index);
  std::visit([=](auto& cord) { cord.release(point); }, cords_[at(index)].cord);
}

}  // namespace engine
