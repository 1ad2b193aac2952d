#include "game/simulation/water_forces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "game/simulation/buttons.h"
#include "ribbon/box2d/convert.h"
#include "ribbon/geometry/rotation.h"

namespace game {
namespace {

using ribbon::Vec2;
using ribbon::box2d::to_double;
using ribbon::box2d::to_float;

constexpr std::size_t corners = 24;          // of the polygon for a circle
constexpr double slow_drag = 1.5;            // 1/s, at low speed
constexpr double fast_drag = 0.8;            // 1/m, times the speed
constexpr double turning_drag = 2.0;         // 1/s
constexpr double min_swimming_share = 0.25;  // of the player below the surface
constexpr double diving_share = 0.97;        // from which its head is below too
constexpr double leap_speed = 6.0;           // m/s, upwards, at the surface
constexpr double stroke_speed = 2.5;         // m/s, upwards, below it
constexpr int stroke_pause = 24;             // ticks between two strokes
constexpr int long_ago = 1000;               // ticks

/// A polygon of at most 25 corners, and one more by each clip.
struct Polygon {
  std::array<Vec2, corners + 2> points{};
  std::size_t count = 0;

  void add(Vec2 p) { points[count++] = p; }
};

const std::array<Vec2, corners>& unit_polygon() {
  static const std::array<Vec2, corners> made = [] {
    std::array<Vec2, corners> points{};
    double area = 0.0;
    for (std::size_t k = 0; k < corners; ++k)
      points[k] = ribbon::rotation(2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(corners));
    for (std::size_t k = 0; k < corners; ++k) area += 0.5 * cross(points[k], points[(k + 1) % corners]);
    for (Vec2& p : points) p = std::sqrt(std::numbers::pi / area) * p;
    return points;
  }();
  return made;
}

/// Returns the shape of a fixture in the world; nothing for edges and chains.
Polygon polygon_of(const b2Fixture& fixture) {
  Polygon polygon;
  const b2Transform& pose = fixture.GetBody()->GetTransform();
  if (fixture.GetType() == b2Shape::e_circle) {
    const auto& circle = static_cast<const b2CircleShape&>(*fixture.GetShape());
    const Vec2 center = to_double(b2Mul(pose, circle.m_p));
    for (const Vec2 p : unit_polygon()) polygon.add(center + static_cast<double>(circle.m_radius) * p);
  } else if (fixture.GetType() == b2Shape::e_polygon) {
    const auto& box = static_cast<const b2PolygonShape&>(*fixture.GetShape());
    for (int k = 0; k < box.m_count; ++k) polygon.add(to_double(b2Mul(pose, box.m_vertices[k])));
  }
  return polygon;
}

Polygon below(const Polygon& whole, double level) {
  Polygon part;
  for (std::size_t k = 0; k < whole.count; ++k) {
    const Vec2 a = whole.points[k];
    const Vec2 b = whole.points[(k + 1) % whole.count];
    if (a.y <= level) part.add(a);
    if ((a.y <= level) != (b.y <= level)) part.add(a + ((level - a.y) / (b.y - a.y)) * (b - a));
  }
  return part;
}

/// Area and centre of a convex polygon.
void add_area(const Polygon& polygon, double& area, Vec2& moment) {
  for (std::size_t k = 2; k < polygon.count; ++k) {
    const Vec2 a = polygon.points[0];
    const double triangle = 0.5 * cross(polygon.points[k - 1] - a, polygon.points[k] - a);
    area += triangle;
    moment += (triangle / 3.0) * (a + polygon.points[k - 1] + polygon.points[k]);
  }
}

}  // namespace

Submerged submerged(const b2Body& body, double level) {
  Submerged sum;
  Vec2 moment;
  Vec2 ignored;
  for (const b2Fixture* fixture = body.GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext()) {
    if (fixture->IsSensor()) continue;
    const Polygon polygon = polygon_of(*fixture);
    add_area(polygon, sum.whole, ignored);
    add_area(below(polygon, level), sum.area, moment);
  }
  if (sum.area > 0.0) sum.center = (1.0 / sum.area) * moment;
  return sum;
}

/// The water that a body displaces moves with it: its mass is added to that of the body. So light bodies rise with at
/// most the acceleration of gravity, and a body that floats is in balance: it displaces its own mass.
void WaterForces::act(const ribbon::WeatherDef& weather, b2World& world, double dt) const {
  const Vec2 up = -to_double(world.GetGravity());
  for (b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
    if (body->GetType() != b2_dynamicBody || !body->IsAwake() || !body->IsEnabled()) continue;
    const Submerged part = submerged(*body, weather.water_level);
    if (part.area <= 0.0) continue;
    const double mass = static_cast<double>(body->GetMass());
    const double displaced = weather.water_density * depth * part.area;
    const double share = 2.0 * displaced / (mass + displaced);
    const Vec2 flow = to_double(body->GetLinearVelocity()) - weather.current;
    const double drag = 1.0 / (1.0 + share * (slow_drag + fast_drag * length(flow)) * dt);
    body->ApplyLinearImpulse(to_float((mass * share * dt) * up), to_float(part.center), false);
    body->ApplyLinearImpulseToCenter(to_float((mass * (drag - 1.0)) * flow), false);
    const double slower = 1.0 / (1.0 + share * turning_drag * dt);
    body->SetAngularVelocity(static_cast<float>(slower * static_cast<double>(body->GetAngularVelocity())));
  }
}

void WaterForces::swim(const ribbon::WeatherDef& weather, std::size_t number, unsigned pressed, Player& player,
                       const ribbon::box2d::Coupling& coupling) {
  int& since_stroke = ticks_since_stroke_[number];
  since_stroke = std::min(since_stroke + 1, long_ago);
  if ((pressed & button_jump) == 0 || since_stroke < stroke_pause || player.is_on_ground()) return;
  if (player.held_place(coupling)) return;
  const Submerged part = submerged(player.body(), weather.water_level);
  if (part.area < min_swimming_share * part.whole) return;
  const double wanted = part.area < diving_share * part.whole ? leap_speed : stroke_speed;
  const b2Vec2 velocity = player.body().GetLinearVelocity();
  player.body().SetLinearVelocity({velocity.x, std::max(velocity.y, static_cast<float>(wanted))});
  since_stroke = 0;
}

void WaterForces::add_to(ribbon::box2d::Hasher& hasher) const {
  for (const int ticks : ticks_since_stroke_) hasher.add(ticks);
}

}  // namespace game
