// Plays a level. Each body and cord of a map is built or refused; the result runs under any input and stays finite.

#include <box2d/box2d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "game/simulation/simulation.h"
#include "tests/fuzz/bytes.h"
#include "tests/fuzz/require.h"

namespace {

using engine::MapObject;
using engine::MapShape;
using fuzz::Bytes;
using fuzz::require;
using ribbon::Vec2;

constexpr int max_ticks = 8;
constexpr double max_coordinate = 1e10;  // m, the greatest value in a map

/// Returns a finite number, because a map has finite numbers only.
double arbitrary_number(Bytes& bytes, double low, double high) {
  const double value = bytes.number(low, high);
  return std::isfinite(value) ? value : 0.0;
}

double arbitrary_length(Bytes& bytes, double low, double high) {
  return std::min(std::max(std::abs(arbitrary_number(bytes, low, high)), 1e-7), max_coordinate);
}

Vec2 arbitrary_position(Bytes& bytes) {
  const double x = std::clamp(arbitrary_number(bytes, -3.0, 3.0), -max_coordinate, max_coordinate);
  return {x, std::clamp(arbitrary_number(bytes, -3.0, 3.0), -max_coordinate, max_coordinate)};
}

class MapMaker {
 public:
  explicit MapMaker(Bytes& bytes) : bytes_(bytes) { map_.file = "fuzz.tmj"; }

  engine::TiledMap make() {
    map_.properties = engine::Properties("fuzz.tmj: map");
    if (bytes_.boolean()) map_.properties.insert("gravity_y", arbitrary_number(bytes_, -20.0, 20.0));
    add("player", MapShape::point).position = arbitrary_position(bytes_);
    MapObject& goal = add("goal", MapShape::rectangle);
    goal.position = arbitrary_position(bytes_);
    goal.size = {1.0, 1.0};
    for (int k = 1 + bytes_.below(5); k > 0; --k) add_object();
    return std::move(map_);
  }

 private:
  MapObject& add(const char* kind, MapShape shape) {
    MapObject& object = map_.objects.emplace_back();
    object.id = static_cast<int>(map_.objects.size());
    object.kind = kind;
    object.shape = shape;
    object.properties = engine::Properties("fuzz.tmj: object " + std::to_string(object.id));
    return object;
  }

  void add_object() {
    switch (bytes_.below(5)) {
      case 0: add_ground(); break;
      case 1: add_circle(); break;
      default: add_cord(); break;
    }
  }

  void add_ground();
  void add_circle();
  void add_cord();
  void may_have(MapObject& object, const char* property, double low, double high) {
    if (bytes_.below(3) == 0) object.properties.insert(property, arbitrary_number(bytes_, low, high));
  }
  void may_be(MapObject& object, const char* property) {
    if (bytes_.below(3) == 0) object.properties.insert(property, true);
  }
  void may_count(MapObject& object, const char* property, int low, int high) {
    if (bytes_.below(3) == 0) object.properties.insert(property, std::int64_t{bytes_.integer(low, high)});
  }

  Bytes& bytes_;
  engine::TiledMap map_;
};

void MapMaker::add_ground() {
  MapObject& ground = add("ground", bytes_.boolean() ? MapShape::rectangle : MapShape::polygon);
  ground.position = arbitrary_position(bytes_);
  ground.rotation = bytes_.below(7) - 3.0;
  ground.size = {arbitrary_length(bytes_, 0.1, 5.0), arbitrary_length(bytes_, 0.1, 5.0)};
  if (ground.shape == MapShape::polygon) {
    for (int k = 3 + bytes_.below(6); k > 0; --k) ground.points.push_back(ground.position + arbitrary_position(bytes_));
  }
  may_have(ground, "friction", 0.0, 10.0);
}

void MapMaker::add_circle() {
  MapObject& circle = add("circle", MapShape::ellipse);
  circle.position = arbitrary_position(bytes_);
  const double size = arbitrary_length(bytes_, 0.1, 1.0);
  circle.size = {size, size};
  constexpr std::array types = {"static", "kinematic", "dynamic"};
  circle.properties.insert("body", std::string(types[bytes_.byte() % types.size()]));
  may_have(circle, "density", 1e-6, 1e6);
  may_have(circle, "friction", 0.0, 10.0);
  may_have(circle, "restitution", 0.0, 1.0);
  may_have(circle, "angular_damping", 0.0, 100.0);
  may_have(circle, "velocity_x", -1000.0, 1000.0);
  may_have(circle, "velocity_y", -10.0, 10.0);
  may_have(circle, "spin", -1000.0, 1000.0);
}

void MapMaker::add_cord() {
  MapObject& cord = add("cord", MapShape::polyline);
  for (int k = 2 + bytes_.below(3); k > 0; --k) cord.points.push_back(arbitrary_position(bytes_));
  cord.properties.insert("columns", std::int64_t{bytes_.integer(2, 8)});
  cord.properties.insert("mass", arbitrary_number(bytes_, 1e-3, 1e3));
  may_count(cord, "substeps", 1, 3);
  may_be(cord, "pin_first");
  may_be(cord, "pin_last");
  may_have(cord, "drag", 0.0, 10.0);
  if (bytes_.below(4) == 0) {
    cord.properties.insert("solver", std::string("thesis"));
    cord.properties.insert("spring_stiffness", arbitrary_number(bytes_, 1.0, 1e12));
    may_count(cord, "rows", 2, 3);
    may_have(cord, "bar_damping", 0.0, 1e3);
    may_have(cord, "area_stiffness", 0.0, 1.0);
    may_be(cord, "self_collision");
    return;
  }
  const bool ribbon = bytes_.below(3) == 0;
  if (ribbon) {
    cord.properties.insert("rows", std::int64_t{bytes_.integer(2, 3)});
    may_have(cord, "width", 0.01, 1.0);
    may_have(cord, "area_stiffness", 0.0, 10.0);
    may_have(cord, "poisson_ratio", -0.9, 0.9);
  }
  if (ribbon || bytes_.boolean()) cord.properties.insert("stretch_stiffness", arbitrary_number(bytes_, 1.0, 1e12));
  may_have(cord, "bending_stiffness", 1e-6, 1e2);
  may_have(cord, "damping", 0.0, 1.0);
  may_have(cord, "radius", 0.0, 0.2);
  may_have(cord, "friction", 0.0, 10.0);
  may_have(cord, "restitution", 0.0, 1.0);
  may_have(cord, "tolerance", 1e-12, 1.0);
  may_count(cord, "max_iterations", 1, 12);
  may_count(cord, "max_work", 1, 1000);
  may_be(cord, "tension_only");
  may_be(cord, "self_contact");
  may_be(cord, "cord_contact");
  may_be(cord, "allow_sleep");
}

void play(const game::Level& level, Bytes& bytes) {
  game::Simulation simulation(level);
  for (int tick = 0; tick < max_ticks; ++tick) {
    engine::TickInput input;
    input.buttons = bytes.byte();
    engine::set_pointer(input, bytes.vector(-3.0, 3.0));
    simulation.tick(input);
    for (const auto& cord : simulation.current().cords) {
      for (const Vec2 x : cord) require(is_finite(x), "positions of cords are finite");
    }
    for (const auto& body : simulation.current().bodies)
      require(is_finite(body.position), "positions and velocities of bodies are finite");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  try {
    play(game::level_of(MapMaker(bytes).make()), bytes);
  } catch (const engine::MapError& error) {
    fuzz::require_message(error.what(), "fuzz.tmj");
  }
  return 0;
}
