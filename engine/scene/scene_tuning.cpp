#include "engine/scene/scene_tuning.h"

#include <utility>
#include <variant>

#include "engine/scene/scene_cord.h"
#include "ribbon/pulley.h"

namespace engine {
namespace {

/// Returns the state of the old cord for the new one. Masses and stiffness are those of the new definition.
ribbon::Cord::State carry_over(const ribbon::Cord& old, const ribbon::Cord& made) {
  const ribbon::Cord::State from = old.save();
  const ribbon::Cord::State bare = ribbon::Cord(old.def()).save();
  ribbon::Cord::State to = made.save();
  to.positions = from.positions;
  to.velocities = from.velocities;
  to.targets = from.targets;
  to.kinds = from.kinds;
  to.loads = from.loads;
  to.rest = from.rest;
  to.rest_targets = from.rest_targets;
  to.rest_speeds = from.rest_speeds;
  to.breaking_forces = from.breaking_forces;
  to.holders = from.holders;
  to.touches = from.touches;
  to.pulleys = from.pulleys;
  for (std::size_t p = 0; p < to.masses.size(); ++p)
    to.masses[p] += from.masses[p] - bare.masses[p];  // attached masses
  to.restart = true;
  return to;
}

bool same_grid(const ribbon::box2d::CordShape& shape, const CordDefinition& wanted) {
  if (const auto* direct = std::get_if<ribbon::CordDef>(&wanted)) {
    return shape.columns == direct->points && shape.rows == direct->rows;
  }
  const auto& thesis = std::get<ribbon::ThesisDef>(wanted);
  return shape.columns == thesis.w && shape.rows == thesis.h;
}

}  // namespace

void retune(ribbon::Cord& cord, ribbon::CordDef def) {
  if (!pulleys_of(cord).empty()) {  // its polyline does not have the length of the cord that lies around wheels
    def.length = cord.def().length;
    def.positions = cord.def().positions;
  }
  ribbon::Cord made(def);
  made.restore(carry_over(cord, made));
  cord = std::move(made);
}

void retune(ribbon::ThesisCord& cord, const ribbon::ThesisDef& def) {
  ribbon::ThesisCord made(def);
  made.restore(cord.save());
  cord = std::move(made);
}

void retune(ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord, const MapObject& object) {
  const CordDefinition wanted = read_cord(object);
  const bool is_direct = std::holds_alternative<ribbon::CordDef>(wanted);
  if ((coupling.cord(cord).solver() == ribbon::box2d::Solver::direct) != is_direct ||
      !same_grid(coupling.cord(cord).shape(), wanted)) {
    throw object.error("its solver, columns or rows change; accepted, while it moves, are those it began with");
  }
  try {
    if (is_direct) {
      retune(coupling.cord(cord).direct(), std::get<ribbon::CordDef>(wanted));
    } else {
      retune(coupling.cord(cord).thesis(), std::get<ribbon::ThesisDef>(wanted));
    }
  } catch (const ribbon::DefinitionError& error) {
    throw object.error(error.what());
  }
}

}  // namespace engine
