#include "engine/scene/scene_wheels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace engine {
namespace {

using ribbon::Vec2;

constexpr double max_corner_distance = 0.25;  // m, from the rim of a wheel to the corner of its cord
constexpr double min_bend = 1e-2;             // sine of the angle by which the polyline has to bend at a wheel

bool is_wheel_of(const MapObject& object, const MapObject& cord) {
  return object.kind == "wheel" && object.properties.integer("cord") == cord.id;
}

ribbon::PulleyDef read_wheel(const MapObject& object) {
  const Properties& p = object.properties;
  p.check_known_properties({"cord", "body", "turns", "inertia", "friction", "motor_speed", "motor_torque"});
  if (object.shape != MapShape::ellipse || std::abs(object.size.x - object.size.y) > 1e-3 * object.size.x) {
    throw object.error("the shape of a wheel is " + std::string(shape_name(object.shape)) + " of " +
                       number_in_words(object.size.x) + " by " + number_in_words(object.size.y) +
                       " m; accepted is an ellipse as wide as high");
  }
  ribbon::PulleyDef pulley;
  pulley.center = object.position;
  pulley.radius = 0.5 * object.size.x;
  pulley.turns = static_cast<int>(p.integer_or("turns", 0, {0, 100}));
  pulley.inertia = p.number_or("inertia", 0.0, {0.0, 1e6});
  pulley.friction = p.number_or("friction", std::numeric_limits<double>::infinity(), {0.0, 10.0});
  pulley.motor_speed = p.number_or("motor_speed", 0.0, {-1e3, 1e3});
  pulley.motor_torque = p.number_or("motor_torque", 0.0, {0.0, 1e9});
  return pulley;
}

/// Returns the index of the corner of the cord that is at the wheel.
std::size_t corner_at(const MapObject& wheel, const MapObject& cord) {
  std::size_t nearest = 0;
  double distance = std::numeric_limits<double>::infinity();
  for (std::size_t k = 1; k + 1 < cord.points.size(); ++k) {
    if (length(cord.points[k] - wheel.position) >= distance) continue;
    distance = length(cord.points[k] - wheel.position);
    nearest = k;
  }
  if (distance <= 0.5 * wheel.size.x + max_corner_distance) return nearest;
  throw wheel.error("no corner of its cord, object " + std::to_string(cord.id) +
                    ", is at it; accepted is a cord whose " + "polyline has a corner within " +
                    number_in_words(max_corner_distance) + " m of the wheel's rim");
}

/// Returns the sine of the angle by which the polyline turns to the left at a corner.
double bend_at(const MapObject& cord, std::size_t corner) {
  const Vec2 in = cord.points[corner] - cord.points[corner - 1];
  const Vec2 out = cord.points[corner + 1] - cord.points[corner];
  return cross(in, out) / (length(in) * length(out));
}

/// Returns the wheels of a cord by its corner; nothing if it has none.
std::vector<WheelDefinition> wheels_by_corner(const MapObject& cord, const TiledMap& map) {
  std::vector<WheelDefinition> by_corner(cord.points.size());
  int count = 0;
  for (const MapObject& object : map.objects) {
    if (!is_wheel_of(object, cord)) continue;
    WheelDefinition wheel{&object, read_wheel(object)};
    const std::size_t corner = corner_at(object, cord);
    if (const MapObject* other = by_corner[corner].object) {
      throw object.error("is at the same corner of its cord as object " + std::to_string(other->id) +
                         "; accepted is a corner for each wheel");
    }
    const double bend = bend_at(cord, corner);
    if (!(std::abs(bend) >= min_bend)) {
      throw object.error("its cord goes straight on at corner " + std::to_string(corner + 1) +
                         "; accepted is one that bends around the wheel");
    }
    wheel.pulley.counterclockwise = bend > 0.0;
    by_corner[corner] = wheel;
    ++count;
  }
  if (count == 0) by_corner.clear();
  return by_corner;
}

}  // namespace

bool has_wheels(const MapObject& cord, const TiledMap& map) {
  return std::any_of(map.objects.begin(), map.objects.end(),
                     [&cord](const MapObject& object) { return is_wheel_of(object, cord); });
}

std::vector<WheelDefinition> reeve_around_wheels(const MapObject& cord, const TiledMap& map, ribbon::CordDef& def) {
  const std::vector<WheelDefinition> by_corner = wheels_by_corner(cord, map);
  if (by_corner.empty()) return {};
  std::vector<WheelDefinition> wheels;
  std::vector<ribbon::PulleyDef> pulleys;
  for (std::size_t k = 1; k + 1 < cord.points.size(); ++k) {
    if (by_corner[k].object == nullptr) {
      throw cord.error("corner " + std::to_string(k + 1) +
                       " of a cord with wheels is at none of them; accepted is one " + "corner at each wheel");
    }
    wheels.push_back(by_corner[k]);
    pulleys.push_back(by_corner[k].pulley);
  }
  try {
    const ribbon::ReevedCord reeved = ribbon::reeve(cord.points.front(), pulleys, cord.points.back(), def.points);
    def.length = reeved.length;
    def.positions = reeved.positions;
    for (std::size_t k = 0; k < wheels.size(); ++k) {
      wheels[k].pulley = reeved.pulleys[k];
      wheels[k].disc_radius = wheels[k].pulley.radius - def.radius;
    }
  } catch (const ribbon::DefinitionError& error) {
    throw cord.error(error.what());
  }
  return wheels;
}

}  // namespace engine
