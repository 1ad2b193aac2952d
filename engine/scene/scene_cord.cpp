#include "engine/scene/scene_cord.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/scene/scene.h"
#include "ribbon/layout.h"
#include "ribbon/thesis/mesh.h"

namespace engine {
namespace {

const Choices thesis_properties = {"solver",      "columns",  "rows",           "mass",           "spring_stiffness",
                                   "bar_damping", "drag",     "area_stiffness", "self_collision", "substeps",
                                   "pin_first",   "pin_last", "solid"};
const Choices direct_properties = {
    "solver",        "columns",        "rows",           "mass",          "stretch_stiffness", "bending_stiffness",
    "poisson_ratio", "area_stiffness", "damping",        "drag",          "tension_only",      "radius",
    "width",         "accuracy",       "integrator",     "substeps",      "tolerance",         "max_iterations",
    "pin_first",     "pin_last",       "friction",       "restitution",   "self_contact",      "cord_contact",
    "allow_sleep",   "max_work",       "solid",          "soft_contacts", "gravity_scale",     "breaking_force",
    "drag_across",   "drag_along",     "displaced_area", "at_rest"};

/// Throws MapError for unknown properties. `own`: properties of the cord's solver; `others`: those of the other solver.
void check_properties(const MapObject& object, ribbon::box2d::Solver solver, Choices own, Choices others) {
  for (const std::string_view property : others) {
    if (!object.properties.has(property) || contains(own, property)) continue;
    throw object.error("property " + in_quotes(property) + " is of another solver; this cord's is " +
                       in_quotes(ribbon::box2d::solver_name(solver)) +
                       (object.properties.has("solver") ? "" : ", the default") +
                       ", and accepted are: " + list_in_words(own));
  }
  object.properties.check_known_properties(own);
}

ribbon::box2d::Solver solver_of(const MapObject& object) {
  const std::string name = object.properties.text_or("solver", ribbon::box2d::solver_name(Scene::default_solver),
                                                     {ribbon::box2d::solver_name(ribbon::box2d::Solver::thesis),
                                                      ribbon::box2d::solver_name(ribbon::box2d::Solver::direct)});
  return name == ribbon::box2d::solver_name(ribbon::box2d::Solver::direct) ? ribbon::box2d::Solver::direct
                                                                           : ribbon::box2d::Solver::thesis;
}

void check_corners(const MapObject& object) {
  for (std::size_t k = 1; k < object.points.size(); ++k) {
    if (!(length(object.points[k] - object.points[k - 1]) >= 1e-3)) {
      throw object.error("corners " + std::to_string(k) + " and " + std::to_string(k + 1) +
                         " of the polyline are in the same place; accepted are corners a millimetre apart or more");
    }
  }
}

/// Returns the length of the polyline in m.
double path_length(const MapObject& object) {
  check_corners(object);
  double sum = 0.0;
  for (std::size_t k = 1; k < object.points.size(); ++k) sum += length(object.points[k] - object.points[k - 1]);
  return sum;
}

int columns_of(const Properties& p) { return static_cast<int>(p.integer("columns", {2, 5000})); }
int rows_of(const MapObject& object, ribbon::box2d::Solver solver) {
  const Properties& p = object.properties;
  if (object.kind == "ribbon") return static_cast<int>(p.integer_or("rows", 3, {2, 16}));
  return solver == ribbon::box2d::Solver::direct ? static_cast<int>(p.integer_or("rows", 1, {1, 16}))
                                                 : static_cast<int>(p.integer_or("rows", 2, {2, 16}));
}
double mass_of(const Properties& p) { return p.number("mass", {1e-6, 1e6}); }
double drag_of(const Properties& p) { return p.number_or("drag", 0.0, {0.0, 1e3}); }
int substeps_of(const Properties& p, int fallback) {
  return static_cast<int>(p.integer_or("substeps", fallback, {1, 256}));
}

/// Returns the points of the pinned end columns.
std::vector<int> pins_of(const Properties& p, int columns, int rows) {
  std::vector<int> pins;
  for (int j = 0; j < rows; ++j) {
    if (p.boolean_or("pin_first", false)) pins.push_back(j);
    if (p.boolean_or("pin_last", false)) pins.push_back((columns - 1) * rows + j);
  }
  return pins;
}

ribbon::ThesisDef thesis_def(const MapObject& object) {
  const Properties& p = object.properties;
  check_properties(object, ribbon::box2d::Solver::thesis, thesis_properties, direct_properties);
  ribbon::ThesisDef def;
  def.w = columns_of(p);
  def.h = rows_of(object, ribbon::box2d::Solver::thesis);
  def.spacing = path_length(object) / (def.w - 1);
  def.point_mass = mass_of(p) / (def.w * def.h);
  def.spring_stiffness = p.number("spring_stiffness", {0.0, 1e12});
  def.bar_damping = p.number_or("bar_damping", 0.0, {0.0, 1e12});
  def.drag = drag_of(p);
  def.area_stiffness = p.number_or("area_stiffness", 0.5, {0.0, 1.0});
  def.self_collision = p.boolean_or("self_collision", false);
  def.substeps = substeps_of(p, 8);
  def.positions = ribbon::lay_along(object.points, def.w, def.h, def.spacing);
  def.pins = pins_of(p, def.w, def.h);
  return def;
}

void lay_along_polyline(ribbon::CordDef& def, const MapObject& object) {
  check_corners(object);
  try {
    ribbon::lay_along(def, object.points);
  } catch (const ribbon::DefinitionError& error) {
    throw object.error(error.what());
  }
}

ribbon::Accuracy accuracy_of(const Properties& p) {
  const std::string name = p.text_or("accuracy", "balanced", {"fast", "balanced", "accurate"});
  ribbon::Accuracy accuracy = ribbon::Accuracy::balanced();
  if (name == "fast") accuracy = ribbon::Accuracy::fast();
  if (name == "accurate") accuracy = ribbon::Accuracy::accurate();
  if (p.has("integrator")) {
    const bool euler = p.text("integrator", {"tr_bdf2", "implicit_euler"}) == "implicit_euler";
    accuracy.soft_contacts = euler;
    accuracy.integrator = euler ? ribbon::Integrator::implicit_euler : ribbon::Integrator::tr_bdf2;
  }
  accuracy.substeps = substeps_of(p, accuracy.substeps);
  accuracy.tolerance = p.number_or("tolerance", accuracy.tolerance, {1e-12, 1.0});
  accuracy.max_iterations = static_cast<int>(p.integer_or("max_iterations", accuracy.max_iterations, {1, 1000}));
  accuracy.soft_contacts = p.boolean_or("soft_contacts", accuracy.soft_contacts);
  accuracy.max_work = static_cast<int>(p.integer_or("max_work", accuracy.max_work, {1, 1'000'000}));
  return accuracy;
}

ribbon::CordDef direct_def(const MapObject& object) {
  const Properties& p = object.properties;
  check_properties(object, ribbon::box2d::Solver::direct, direct_properties, thesis_properties);
  ribbon::CordDef def;
  def.points = columns_of(p);
  def.rows = rows_of(object, ribbon::box2d::Solver::direct);
  def.width = p.number_or("width", 0.0, {0.0, 1e3});
  lay_along_polyline(def, object);
  def.radius = p.number_or("radius", def.radius, {0.0, 10.0});
  def.mass_per_length = mass_of(p) / def.length;
  const bool stretches = def.rows > 1 || p.has("stretch_stiffness");  // ropes are inextensible by default
  if (stretches) def.stretch_stiffness = p.number("stretch_stiffness", {1e-6, 1e12});
  def.bending_stiffness = p.number_or("bending_stiffness", 0.0, {0.0, 1e12});
  def.poisson_ratio = p.number_or("poisson_ratio", 0.0, {-0.9, 0.9});
  def.area_stiffness = p.number_or("area_stiffness", 0.0, {0.0, 1e3});
  def.damping = p.number_or("damping", 0.0, {0.0, 1e3});
  def.drag = drag_of(p);
  def.gravity_scale = p.number_or("gravity_scale", 1.0, {-1e3, 1e3});
  def.drag_across = p.number_or("drag_across", 0.0, {0.0, 1e3});
  def.drag_along = p.number_or("drag_along", 0.0, {0.0, 1e3});
  def.displaced_area = p.number_or("displaced_area", 0.0, {0.0, 1e3});
  def.tension_only = p.boolean_or("tension_only", false);
  const double breaking_force = p.number_or("breaking_force", 0.0, {0.0, 1e12});
  if (breaking_force > 0.0) def.breaking_force = breaking_force;
  def.friction = p.number_or("friction", 0.0, {0.0, 10.0});
  def.restitution = p.number_or("restitution", 0.0, {0.0, 1.0});
  def.self_contact = p.boolean_or("self_contact", false);
  def.cord_contact = p.boolean_or("cord_contact", false);
  def.allow_sleep = p.boolean_or("allow_sleep", false);
  def.accuracy = accuracy_of(p);
  def.pins = pins_of(p, def.points, def.rows);
  return def;
}

}  // namespace

std::int64_t points_of(const MapObject& object) {
  return std::int64_t{columns_of(object.properties)} * rows_of(object, solver_of(object));
}

bool is_solid(const MapObject& object) { return object.properties.boolean_or("solid", false); }

CordDefinition read_cord(const MapObject& object) {
  if (object.shape != MapShape::polyline) {
    throw object.error("the shape of a " + object.kind + " is " + std::string(shape_name(object.shape)) +
                       "; accepted is polyline");
  }
  if (solver_of(object) == ribbon::box2d::Solver::direct) return direct_def(object);
  return thesis_def(object);
}

}  // namespace engine
