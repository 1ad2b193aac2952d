#include "game/simulation/yard.h"

#include <box2d/b2_collision.h>
#include <box2d/box2d.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "engine/tick/input.h"
#include "game/simulation/level.h"
#include "game/simulation/simulation.h"
#include "ribbon/box2d/convert.h"

namespace game {
namespace {

using engine::MapObject;
using engine::MapShape;
using ribbon::Vec2;
using ribbon::box2d::to_float;

constexpr int first_object = 1'000'000'000;  // id of the first placed thing, above those of a map
constexpr double slack = 1.05;               // length of a rope between two points, relative to their distance
constexpr double link = 0.2;                 // m, of a rope or curtain
constexpr double cloth_link = 0.3;           // m, of a trampoline
constexpr double crate_size = 0.9;           // m
constexpr double crate_mass = 30.0;          // kg
constexpr double ball_radius = 0.4;          // m
constexpr double peg_radius = 0.35;          // m

struct Row {
  Thing thing;
  std::string_view name;
  bool has_two_ends;
};
constexpr std::array<Row, all_things.size()> table = {{
    {Thing::rope, "rope", true},
    {Thing::hanging_rope, "hanging_rope", true},
    {Thing::curtain, "curtain", true},
    {Thing::trampoline, "trampoline", true},
    {Thing::crate, "crate", false},
    {Thing::ball, "ball", false},
    {Thing::peg, "peg", false},
}};
const Row& row(Thing thing) { return table[static_cast<std::size_t>(thing)]; }

constexpr std::string_view start_name = "start";

Vec2 in_centimetres(Vec2 at) { return {engine::quantise_cm(at.x) / 100.0, engine::quantise_cm(at.y) / 100.0}; }

std::int64_t columns_of(double length, double wanted_link) {
  return std::max<std::int64_t>(std::lround(length / wanted_link), 4) + 1;
}

MapObject object(Thing thing, int id, MapShape shape, const char* kind, Vec2 at, Vec2 size = {}) {
  MapObject made;
  made.id = id;
  made.name = thing_name(thing);
  made.kind = kind;
  made.shape = shape;
  made.position = at;
  made.size = size;
  made.properties = engine::Properties("the yard: " + made.name);
  return made;
}

/// Returns a cord along a polyline, without the properties of its kind.
MapObject cord(const PlacedThing& placed, int id, const char* kind, std::vector<Vec2> points, std::int64_t columns,
               double mass) {
  MapObject made = object(placed.thing, id, MapShape::polyline, kind, points.front());
  made.points = std::move(points);
  made.properties.insert("columns", columns);
  made.properties.insert("mass", mass);
  made.properties.insert("pin_first", true);
  made.properties.insert("allow_sleep", true);
  made.properties.insert("drag", 0.8);
  made.properties.insert("friction", 0.5);
  return made;
}

MapObject rope(const PlacedThing& placed, int id, bool is_tied_twice) {
  const Vec2 along = placed.second - placed.first;
  std::vector<Vec2> points = {placed.first, placed.second};
  double whole = length(along);
  if (is_tied_twice) {  // a corner in the middle, below it, gives the slack
    const double side = along.x < 0.0 ? 0.5 : -0.5;
    points.insert(points.begin() + 1, placed.first + 0.5 * along + side * std::sqrt(slack * slack - 1.0) * perp(along));
    whole *= slack;
  }
  MapObject made = cord(placed, id, "cord", std::move(points), columns_of(whole, link), 0.35 * whole);
  made.properties.insert("pin_last", is_tied_twice);
  made.properties.insert("at_rest", is_tied_twice);
  made.properties.insert("bending_stiffness", 0.5);
  made.properties.insert("damping", 0.05);
  made.properties.insert("radius", 0.08);
  made.properties.insert("tension_only", true);
  made.properties.insert("cord_contact", true);
  return made;
}

MapObject curtain(const PlacedThing& placed, int id) {
  const double whole = length(placed.second - placed.first);
  MapObject made = cord(placed, id, "ribbon", {placed.first, placed.second}, columns_of(whole, 2.0 * link), whole);
  made.properties.insert("rows", std::int64_t{3});
  made.properties.insert("width", 0.8);
  made.properties.insert("stretch_stiffness", 3000.0);
  made.properties.insert("bending_stiffness", 0.3);
  made.properties.insert("damping", 0.02);
  made.properties.insert("radius", 0.05);
  made.properties.insert("self_contact", true);
  made.properties.insert("cord_contact", true);
  return made;
}

MapObject trampoline(const PlacedThing& placed, int id) {
  const double whole = length(placed.second - placed.first);
  MapObject made =
      cord(placed, id, "ribbon", {placed.first, placed.second}, columns_of(whole, cloth_link), 1.25 * whole);
  made.properties.insert("pin_last", true);
  made.properties.insert("at_rest", true);
  made.properties.insert("rows", std::int64_t{2});
  made.properties.insert("width", 0.3);
  made.properties.insert("stretch_stiffness", 60000.0);
  made.properties.insert("bending_stiffness", 5.0);
  made.properties.insert("damping", 0.0005);
  made.properties.insert("radius", 0.06);
  made.properties.insert("solid", true);
  return made;
}

MapObject object_of(const PlacedThing& placed, int id) {
  const Vec2 at = placed.first;
  switch (placed.thing) {
    case Thing::rope: return rope(placed, id, true);
    case Thing::hanging_rope: return rope(placed, id, false);
    case Thing::curtain: return curtain(placed, id);
    case Thing::trampoline: return trampoline(placed, id);
    case Thing::crate: {
      MapObject made = object(placed.thing, id, MapShape::rectangle, "load", at, {crate_size, crate_size});
      made.properties.insert("mass", crate_mass);
      return made;
    }
    case Thing::ball: {
      MapObject made = object(placed.thing, id, MapShape::ellipse, "circle", at, 2.0 * Vec2{ball_radius, ball_radius});
      made.properties.insert("density", 10.0);
      made.properties.insert("restitution", 0.4);
      return made;
    }
    case Thing::peg: break;
  }
  MapObject made = object(placed.thing, id, MapShape::ellipse, "circle", at, 2.0 * Vec2{peg_radius, peg_radius});
  made.properties.insert("body", std::string("static"));
  made.properties.insert("sticky", true);
  return made;
}

/// Returns the fault of a thing that follows from its places alone.
std::optional<PlacingFault> fault_of_places(const PlacedThing& thing, Vec2 level) {
  const auto is_inside = [level](Vec2 at) {
    return at.x >= Yard::edge && at.y >= Yard::edge && at.x <= level.x - Yard::edge && at.y <= level.y - Yard::edge;
  };
  if (!is_inside(thing.first) || !is_inside(thing.second)) return PlacingFault::outside;
  if (!has_two_ends(thing.thing)) return std::nullopt;
  const double span = length(thing.second - thing.first);
  if (span < Yard::min_span) return PlacingFault::too_short;
  if (span > Yard::max_span) return PlacingFault::too_long;
  return std::nullopt;
}

/// Returns whether any fixture but those of an object overlaps the shape.
bool overlaps(const engine::Scene& scene, const b2Shape& shape, Vec2 at, int except) {
  const b2Transform here(to_float(at), b2Rot(0.0F));
  for (const b2Body* body = scene.world().GetBodyList(); body != nullptr; body = body->GetNext()) {
    const auto bodies = scene.bodies();
    const bool is_except = std::any_of(bodies.begin(), bodies.end(), [body, except](const engine::SceneBody& made) {
      return made.body == body && made.object == except;
    });
    if (is_except) continue;
    for (const b2Fixture* fixture = body->GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext()) {
      if (fixture->IsSensor()) continue;
      if (b2TestOverlap(&shape, 0, fixture->GetShape(), 0, here, body->GetTransform())) return true;
    }
  }
  return false;
}

/// Returns whether a line meets the player.
bool meets_player(const Player& player, Vec2 from, Vec2 to) {
  b2RayCastInput line;
  line.p1 = to_float(from);
  line.p2 = to_float(to);
  line.maxFraction = 1.0F;
  for (const b2Fixture* fixture = player.body().GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext()) {
    b2RayCastOutput hit;
    if (fixture->TestPoint(line.p1) || fixture->RayCast(&hit, line, 0)) return true;
  }
  return false;
}

bool is_in_the_way(const Simulation& simulation, const PlacedThing& thing, int except) {
  if (has_two_ends(thing.thing)) {
    for (int k = 0; k < simulation.players(); ++k) {
      if (meets_player(simulation.player(k), thing.first, thing.second)) return true;
    }
    return false;
  }
  b2CircleShape disc;
  disc.m_radius = static_cast<float>(thing.thing == Thing::peg ? peg_radius : ball_radius);
  b2PolygonShape box;
  const auto half = static_cast<float>(0.5 * crate_size);
  box.SetAsBox(half, half);
  const b2Shape& shape = thing.thing == Thing::crate ? static_cast<const b2Shape&>(box) : disc;
  return overlaps(simulation.scene(), shape, thing.first, except);
}

double distance_to(const PlacedThing& thing, Vec2 at) {
  const Vec2 along = thing.second - thing.first;
  const double squared = dot(along, along);
  const double fraction = squared > 0.0 ? std::clamp(dot(at - thing.first, along) / squared, 0.0, 1.0) : 0.0;
  return length(at - thing.first - fraction * along);
}

/// Removes the text up to a separator, or all of it, from the front and returns it.
std::string_view take_until(std::string_view& text, char separator) {
  const std::size_t end = text.find(separator);
  const std::string_view part = text.substr(0, end);
  text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
  return part;
}

/// Reads a coordinate in centimetres from the front of the text, m.
std::optional<double> take_coordinate(std::string_view& text) {
  const std::string_view digits = take_until(text, ' ');
  std::int16_t cm = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), cm);
  if (error != std::errc{} || end != digits.data() + digits.size()) return std::nullopt;
  return cm / 100.0;
}

std::optional<Vec2> take_place(std::string_view& text) {
  const auto x = take_coordinate(text);
  const auto y = take_coordinate(text);
  return x && y ? std::optional(Vec2{*x, *y}) : std::nullopt;
}

/// Reads one part of the text into the yard. Returns false if it is none.
bool read_part(std::string_view part, Yard& yard) {
  const std::string_view name = take_until(part, ' ');
  const auto first = take_place(part);
  if (!first) return false;
  if (name == start_name) {
    yard.start = first;
    return part.empty();
  }
  const auto* const known =
      std::find_if(table.begin(), table.end(), [name](const Row& kind) { return kind.name == name; });
  if (known == table.end()) return false;
  const auto second = known->has_two_ends ? take_place(part) : first;
  if (!second) return false;
  yard.things.push_back({known->thing, *first, *second});
  return part.empty();
}

void add_place(std::string& text, Vec2 at) {
  text += ' ' + std::to_string(engine::quantise_cm(at.x)) + ' ' + std::to_string(engine::quantise_cm(at.y));
}

}  // namespace

std::string_view thing_name(Thing thing) { return row(thing).name; }
bool has_two_ends(Thing thing) { return row(thing).has_two_ends; }

PlacedThing thing_at(Thing thing, Vec2 first, Vec2 second) {
  return {thing, in_centimetres(first), in_centimetres(has_two_ends(thing) ? second : first)};
}

std::optional<PlacingFault> fault_of(const Simulation& simulation, const PlacedThing& thing,
                                     std::optional<std::size_t> except) {
  const Level& level = simulation.level();
  if (!except && level.yard.things.size() >= Yard::max_things) return PlacingFault::too_many;
  if (const auto fault = fault_of_places(thing, level.map.size)) return fault;
  const int replaced = except ? first_object + static_cast<int>(*except) : 0;
  if (is_in_the_way(simulation, thing, replaced)) return PlacingFault::in_the_way;
  return std::nullopt;
}

std::optional<std::size_t> nearest_thing(const Yard& yard, Vec2 at) {
  std::optional<std::size_t> nearest;
  double range = Yard::pick_range;
  for (std::size_t k = 0; k < yard.things.size(); ++k) {
    const double distance = distance_to(yard.things[k], at);
    if (distance > range) continue;
    range = distance;
    nearest = k;
  }
  return nearest;
}

Yard with_start_at(Yard yard, const Simulation& simulation) {
  const Player& player = simulation.player();
  yard.start = in_centimetres(player.position() - Vec2{0.0, 0.5 * player.tuning().height});
  return yard;
}

std::vector<MapObject> objects_of(const Yard& yard) {
  std::vector<MapObject> objects;
  for (const PlacedThing& thing : yard.things) {
    objects.push_back(object_of(thing, first_object + static_cast<int>(objects.size())));
  }
  return objects;
}

bool is_placed(int object) { return object >= first_object; }

void set_yard(Level& level, const Yard& yard) {
  std::erase_if(level.map.objects, [](const MapObject& object) { return is_placed(object.id); });
  for (MapObject& object : objects_of(yard)) level.map.objects.push_back(std::move(object));
  if (yard.start) {
    level.player_start = *yard.start;
  } else if (level.yard.start) {
    const auto& objects = level.map.objects;
    const auto player =
        std::find_if(objects.begin(), objects.end(), [](const MapObject& object) { return object.kind == "player"; });
    if (player != objects.end()) level.player_start = player->position;
  }
  level.yard = yard;
}

std::string yard_text(const Yard& yard) {
  std::string text;
  if (yard.start) add_place(text += start_name, *yard.start);
  for (const PlacedThing& thing : yard.things) {
    text += text.empty() ? "" : ";";
    add_place(text += thing_name(thing.thing), thing.first);
    if (has_two_ends(thing.thing)) add_place(text, thing.second);
  }
  return text;
}

std::optional<Yard> yard_of(std::string_view text, const Level& level) {
  Yard yard;
  while (!text.empty()) {
    if (!read_part(take_until(text, ';'), yard)) return std::nullopt;
  }
  if (!level.sandbox || yard.things.size() > Yard::max_things) return std::nullopt;
  const Vec2 start = yard.start.value_or(level.player_start);
  const bool starts_inside =
      start.x >= 0.0 && start.y >= 0.0 && start.x <= level.map.size.x && start.y <= level.map.size.y;
  const bool fits =
      starts_inside && std::none_of(yard.things.begin(), yard.things.end(), [&level](const PlacedThing& thing) {
        return fault_of_places(thing, level.map.size).has_value();
      });
  return fits ? std::optional(std::move(yard)) : std::nullopt;
}

}  // namespace game
