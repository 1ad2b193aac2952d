#include "game/tuning/parameters.h"

#include <string_view>

namespace game {
namespace {

using ribbon::box2d::CordId;
using ribbon::box2d::Coupling;

/// Returns a function that reads a field of a cord of the direct solver.
auto direct(auto read) {
  return [read](const Coupling& coupling, CordId cord) { return read(coupling.cord(cord).direct().def()); };
}
/// The same for a cord of the thesis's solver.
auto thesis(auto read) {
  return [read](const Coupling& coupling, CordId cord) { return read(coupling.cord(cord).thesis().def()); };
}

std::vector<Parameter> material_parameters(bool is_ribbon) {
  using ribbon::CordDef;
  std::vector<Parameter> parameters = {
      {"mass", "kg", 1e-2, 1e3, true, false, false, 0.0,
       direct([](const CordDef& d) { return d.mass_per_length * d.length; })},
      {"drag", "1/s", 1e-3, 10.0, true, false, true, 0.1, direct([](const CordDef& d) { return d.drag; })},
      {"gravity_scale", "", -2.0, 4.0, false, false, false, 0.0,
       direct([](const CordDef& d) { return d.gravity_scale; })},
      {"drag_across", "", 1e-3, 10.0, true, false, true, 1.2, direct([](const CordDef& d) { return d.drag_across; })},
      {"drag_along", "", 1e-4, 1.0, true, false, true, 0.01, direct([](const CordDef& d) { return d.drag_along; })},
      {"displaced_area", "m²", 1e-6, 1.0, true, false, true, 1e-3,
       direct([](const CordDef& d) { return d.displaced_area; })},
      {"stretch_stiffness", "N", 10.0, 1e9, true, false, !is_ribbon, 1e4,
       direct([](const CordDef& d) { return d.stretch_stiffness; })},
      {"bending_stiffness", "N·m²", 1e-6, 1e4, true, false, true, 0.1,
       direct([](const CordDef& d) { return d.bending_stiffness; })},
      {"damping", "s", 1e-5, 1.0, true, false, true, 0.01, direct([](const CordDef& d) { return d.damping; })}};
  if (is_ribbon) {
    parameters.push_back({"poisson_ratio", "", -0.9, 0.9, false, false, true, 0.3,
                          direct([](const CordDef& d) { return d.poisson_ratio; })});
    parameters.push_back({"area_stiffness", "", 1e-2, 10.0, true, false, true, 1.0,
                          direct([](const CordDef& d) { return d.area_stiffness; })});
  }
  return parameters;
}

std::vector<Parameter> contact_and_accuracy_parameters() {
  using ribbon::CordDef;
  return {
      {"friction", "", 1e-2, 2.0, false, false, true, 0.5, direct([](const CordDef& d) { return d.friction; })},
      {"restitution", "", 1e-2, 1.0, false, false, true, 0.3, direct([](const CordDef& d) { return d.restitution; })},
      {"radius", "m", 1e-3, 0.2, true, false, false, 0.0, direct([](const CordDef& d) { return d.radius; })},
      {"substeps", "", 1.0, 16.0, false, true, false, 0.0,
       direct([](const CordDef& d) { return static_cast<double>(d.accuracy.substeps); })},
      {"tolerance", "m", 1e-8, 0.1, true, false, false, 0.0,
       direct([](const CordDef& d) { return d.accuracy.tolerance; })},
      {"max_iterations", "", 1.0, 64.0, false, true, false, 0.0,
       direct([](const CordDef& d) { return static_cast<double>(d.accuracy.max_iterations); })},
      {"max_work", "", 10.0, 10000.0, false, true, false, 0.0,
       direct([](const CordDef& d) { return static_cast<double>(d.accuracy.max_work); })}};
}

std::vector<Parameter> direct_parameters(bool is_ribbon) {
  std::vector<Parameter> parameters = material_parameters(is_ribbon);
  const std::vector<Parameter> rest = contact_and_accuracy_parameters();
  parameters.insert(parameters.end(), rest.begin(), rest.end());
  return parameters;
}

std::vector<Parameter> thesis_parameters() {
  using ribbon::ThesisDef;
  return {{"mass", "kg", 1e-2, 1e3, true, false, false, 0.0,
           thesis([](const ThesisDef& d) { return d.point_mass * d.w * d.h; })},
          {"drag", "1/s", 1e-3, 10.0, true, false, true, 0.1, thesis([](const ThesisDef& d) { return d.drag; })},
          {"spring_stiffness", "N/m", 1.0, 1e12, true, false, true, 1e4,
           thesis([](const ThesisDef& d) { return d.spring_stiffness; })},
          {"bar_damping", "N·s/m", 1e-2, 1e6, true, false, true, 10.0,
           thesis([](const ThesisDef& d) { return d.bar_damping; })},
          {"area_stiffness", "", 1e-2, 1.0, false, false, true, 0.5,
           thesis([](const ThesisDef& d) { return d.area_stiffness; })},
          {"substeps", "", 1.0, 64.0, false, true, false, 0.0,
           thesis([](const ThesisDef& d) { return static_cast<double>(d.substeps); })}};
}

}  // namespace

std::vector<Parameter> parameters_of(const Coupling& coupling, CordId cord) {
  if (coupling.cord(cord).solver() == ribbon::box2d::Solver::thesis) return thesis_parameters();
  return direct_parameters(coupling.cord(cord).shape().rows > 1);
}

std::vector<Switch> switches_of(const Coupling& coupling, CordId cord) {
  using ribbon::CordDef;
  if (coupling.cord(cord).solver() == ribbon::box2d::Solver::thesis) {
    return {{"self_collision", thesis([](const ribbon::ThesisDef& d) { return d.self_collision; })}};
  }
  std::vector<Switch> switches = {{"self_contact", direct([](const CordDef& d) { return d.self_contact; })},
                                  {"cord_contact", direct([](const CordDef& d) { return d.cord_contact; })},
                                  {"allow_sleep", direct([](const CordDef& d) { return d.allow_sleep; })}};
  if (coupling.cord(cord).shape().rows == 1) {
    switches.push_back({"tension_only", direct([](const CordDef& d) { return d.tension_only; })});
  }
  return switches;
}

std::optional<engine::Properties::Value> off_value(const Parameter& parameter) {
  if (std::string_view(parameter.property) == "stretch_stiffness") return std::nullopt;
  return 0.0;
}

}  // namespace game
