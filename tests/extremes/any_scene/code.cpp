#include "tests/extremes/any_scene/code.h"

#include <charconv>
#include <cmath>
#include <string>
#include <vector>

namespace any_scene {
namespace {

using ribbon::Vec2;

/// Returns the shortest text that parses to the same number.
std::string text(double value) {
  if (std::isinf(value)) return std::string(value < 0.0 ? "-" : "") + "std::numeric_limits<double>::infinity()";
  char buffer[40];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value);
  std::string number(buffer, end.ptr);
  return number.find_first_of(".e") == std::string::npos ? number + ".0" : number;
}
std::string text(int value) { return std::to_string(value); }
std::string text(bool value) { return value ? "true" : "false"; }
std::string text(Vec2 value) {
  std::string both = "{";
  both += text(value.x);
  both += ", ";
  both += text(value.y);
  return both += "}";
}
std::string text(Preset preset) { return "any_scene::Preset::" + std::string(name(preset)); }
std::string text(ribbon::Elements elements) {
  return elements == ribbon::Elements::cells ? "ribbon::Elements::cells" : "ribbon::Elements::bars";
}
std::string text(Motion motion) {
  constexpr std::string_view names[] = {"fixed", "dynamic", "kinematic"};
  return "any_scene::Motion::" + std::string(names[static_cast<std::size_t>(motion)]);
}
std::string text(Shape shape) {
  constexpr std::string_view names[] = {"circle", "box", "edge"};
  return "any_scene::Shape::" + std::string(names[static_cast<std::size_t>(shape)]);
}
template <typename Value>
std::string text(const std::vector<Value>& values) {
  std::string all = "{";
  for (const Value& value : values) {
    if (all.size() > 1) all += ", ";
    all += text(value);
  }
  return all += "}";
}

/// Collects lines that assign the fields which differ from their defaults.
class Lines {
 public:
  explicit Lines(std::string object) : object_(std::move(object)) {}
  template <typename Value>
  void set(const char* field, const Value& value, const Value& otherwise) {
    if (value == otherwise) return;
    for (const std::string& part : {std::string("  "), object_, std::string("."), std::string(field),
                                    std::string(" = "), text(value), std::string(";\n")}) {
      all_ += part;
    }
  }
  const std::string& all() const { return all_; }

 private:
  std::string object_;
  std::string all_;
};

std::string code_of(const ribbon::CordDef& def, const std::string& object) {
  const ribbon::CordDef plain;
  Lines lines(object);
  lines.set("points", def.points, plain.points);
  lines.set("rows", def.rows, plain.rows);
  lines.set("length", def.length, plain.length);
  lines.set("width", def.width, plain.width);
  lines.set("radius", def.radius, plain.radius);
  lines.set("mass_per_length", def.mass_per_length, plain.mass_per_length);
  lines.set("stretch_stiffness", def.stretch_stiffness, plain.stretch_stiffness);
  lines.set("bending_stiffness", def.bending_stiffness, plain.bending_stiffness);
  lines.set("poisson_ratio", def.poisson_ratio, plain.poisson_ratio);
  lines.set("cell_stiffness", def.cell_stiffness, plain.cell_stiffness);
  lines.set("area_stiffness", def.area_stiffness, plain.area_stiffness);
  lines.set("damping", def.damping, plain.damping);
  lines.set("drag", def.drag, plain.drag);
  lines.set("gravity_scale", def.gravity_scale, plain.gravity_scale);
  lines.set("drag_across", def.drag_across, plain.drag_across);
  lines.set("drag_along", def.drag_along, plain.drag_along);
  lines.set("displaced_area", def.displaced_area, plain.displaced_area);
  lines.set("tension_only", def.tension_only, plain.tension_only);
  lines.set("breaking_force", def.breaking_force, plain.breaking_force);
  lines.set("friction", def.friction, plain.friction);
  lines.set("restitution", def.restitution, plain.restitution);
  lines.set("self_contact", def.self_contact, plain.self_contact);
  lines.set("cord_contact", def.cord_contact, plain.cord_contact);
  lines.set("allow_sleep", def.allow_sleep, plain.allow_sleep);
  lines.set("elements", def.elements, plain.elements);
  lines.set("positions", def.positions, plain.positions);
  lines.set("pins", def.pins, plain.pins);
  return lines.all();
}

std::string code_of(const SceneCord& cord, const std::string& object) {
  Lines lines(object);
  lines.set("velocity", cord.velocity, {});
  lines.set("other_softness", cord.other_softness, false);
  return code_of(cord.def, object + ".def") + lines.all();
}

std::string code_of(const Solid& solid, const std::string& object) {
  const Solid plain;
  Lines lines(object);
  lines.set("motion", solid.motion, plain.motion);
  lines.set("shape", solid.shape, plain.shape);
  lines.set("position", solid.position, plain.position);
  lines.set("angle", solid.angle, plain.angle);
  lines.set("half", solid.half, plain.half);
  lines.set("density", solid.density, plain.density);
  lines.set("friction", solid.friction, plain.friction);
  lines.set("restitution", solid.restitution, plain.restitution);
  lines.set("velocity", solid.velocity, plain.velocity);
  lines.set("angular_velocity", solid.angular_velocity, plain.angular_velocity);
  lines.set("belt_speed", solid.belt_speed, plain.belt_speed);
  return lines.all();
}

std::string code_of(const Hold& hold, const std::string& object) {
  const Hold plain;
  Lines lines(object);
  lines.set("solid", hold.solid, plain.solid);
  lines.set("cord", hold.cord, plain.cord);
  lines.set("arc", hold.arc, plain.arc);
  lines.set("row", hold.row, plain.row);
  lines.set("local_anchor", hold.local_anchor, plain.local_anchor);
  lines.set("strength", hold.strength, plain.strength);
  lines.set("lets_go", hold.lets_go, plain.lets_go);
  lines.set("climb_to", hold.climb_to, plain.climb_to);
  lines.set("climb_speed", hold.climb_speed, plain.climb_speed);
  return lines.all();
}

std::string code_of(const Wheel& wheel, const std::string& object) {
  const Wheel plain;
  Lines lines(object);
  lines.set("cord", wheel.cord, plain.cord);
  lines.set("solid", wheel.solid, plain.solid);
  lines.set("def.center", wheel.def.center, plain.def.center);
  lines.set("def.radius", wheel.def.radius, plain.def.radius);
  lines.set("def.counterclockwise", wheel.def.counterclockwise, plain.def.counterclockwise);
  lines.set("def.turns", wheel.def.turns, plain.def.turns);
  lines.set("def.before", wheel.def.before, plain.def.before);
  lines.set("def.after", wheel.def.after, plain.def.after);
  lines.set("def.inertia", wheel.def.inertia, plain.def.inertia);
  lines.set("def.friction", wheel.def.friction, plain.def.friction);
  lines.set("def.motor_speed", wheel.def.motor_speed, plain.def.motor_speed);
  lines.set("def.motor_torque", wheel.def.motor_torque, plain.def.motor_torque);
  return lines.all();
}

std::string code_of(const Drag& drag, const std::string& object) {
  const Drag plain;
  Lines lines(object);
  lines.set("cord", drag.cord, plain.cord);
  lines.set("point", drag.point, plain.point);
  lines.set("from_tick", drag.from_tick, plain.from_tick);
  lines.set("speed", drag.speed, plain.speed);
  lines.set("path", drag.path, plain.path);
  return lines.all();
}

std::string code_of(const Reel& reel, const std::string& object) {
  const Reel plain;
  Lines lines(object);
  lines.set("cord", reel.cord, plain.cord);
  lines.set("first", reel.first, plain.first);
  lines.set("last", reel.last, plain.last);
  lines.set("from_tick", reel.from_tick, plain.from_tick);
  lines.set("length", reel.length, plain.length);
  lines.set("speed", reel.speed, plain.speed);
  return lines.all();
}

std::string code_of(const Cut& cut, const std::string& object) {
  const Cut plain;
  Lines lines(object);
  lines.set("tick", cut.tick, plain.tick);
  lines.set("cord", cut.cord, plain.cord);
  lines.set("place", cut.place, plain.place);
  lines.set("weakens", cut.weakens, plain.weakens);
  lines.set("along", cut.along, plain.along);
  return lines.all();
}

std::string code_of(const Knot& knot, const std::string& object) {
  const Knot plain;
  Lines lines(object);
  lines.set("tick", knot.tick, plain.tick);
  lines.set("cord", knot.cord, plain.cord);
  lines.set("place", knot.place, plain.place);
  lines.set("unties", knot.unties, plain.unties);
  return lines.all();
}

template <typename Part>
std::string code_of_all(const std::vector<Part>& parts, const std::string& list) {
  std::string code;
  const std::string place = std::string("scene.") + list;
  if (!parts.empty()) code += std::string("  ") + place + ".resize(" + std::to_string(parts.size()) + ");\n";
  for (std::size_t k = 0; k < parts.size(); ++k) code += code_of(parts[k], place + "[" + std::to_string(k) + "]");
  return code;
}

}  // namespace

std::string to_code(const Scene& scene, std::string_view name) {
  const Scene plain;
  Lines lines("scene");
  lines.set("gravity", scene.gravity, plain.gravity);
  lines.set("preset", scene.preset, plain.preset);
  lines.set("ticks", scene.ticks, plain.ticks);
  lines.set("calm_ticks", scene.calm_ticks, plain.calm_ticks);
  lines.set("sleeping", scene.sleeping, plain.sleeping);
  return std::string("any_scene::Scene ") + std::string(name) + "() {\n  any_scene::Scene scene;\n" + lines.all() +
         code_of_all(scene.cords, "cords") + code_of_all(scene.solids, "solids") + code_of_all(scene.holds, "holds") +
         code_of_all(scene.wheels, "wheels") + code_of_all(scene.drags, "drags") + code_of_all(scene.reels, "reels") +
         code_of_all(scene.cuts, "cuts") + code_of_all(scene.knots, "knots") + "  return scene;\n}\n";
}

}  // namespace any_scene
