#include "game/simulation/ledge.h"

#include "ribbon/box2d/convert.h"

namespace game {
namespace {

using ribbon::Vec2;
using ribbon::box2d::to_double;
using ribbon::box2d::to_float;

constexpr double level_slope = 0.95;  // min. upward component of the normal of the top
constexpr double depth = 0.15;        // m, behind the wall and below the top, at which they are looked for

/// The first static fixture that a ray meets.
class StaticHit : public b2RayCastCallback {
 public:
  float ReportFixture(b2Fixture* fixture, const b2Vec2& point, const b2Vec2& normal, float fraction) override {
    if (fixture->IsSensor() || fixture->GetBody()->GetType() != b2_staticBody) return -1.0F;
    at = to_double(point);
    outwards = to_double(normal);
    hit = true;
    return fraction;
  }

  bool hit = false;
  Vec2 at;
  Vec2 outwards;
};

StaticHit first_static(const b2World& world, Vec2 from, Vec2 to) {
  StaticHit hit;
  world.RayCast(&hit, to_float(from), to_float(to));
  return hit;
}

}  // namespace

/// The top is where a ray meets it that falls just behind the wall. There must be room above it for a hand.
std::optional<Ledge> find_ledge(const b2Body& player, Vec2 hand, int side, const PlayerTuning& tuning) {
  const b2World& world = *player.GetWorld();
  const Vec2 up{0.0, tuning.ledge_reach};
  const Vec2 behind = hand + Vec2{side * (tuning.radius + depth), 0.0};
  const StaticHit top = first_static(world, behind + up, behind - up);
  if (!top.hit || top.outwards.y < level_slope) return std::nullopt;
  const Vec2 above{hand.x, top.at.y + depth};
  if (first_static(world, above, {behind.x, above.y}).hit) return std::nullopt;
  const Vec2 beside{hand.x, top.at.y - depth};
  const StaticHit wall = first_static(world, beside, beside + Vec2{2.0 * side * tuning.radius, 0.0});
  if (!wall.hit || -side * wall.outwards.x < level_slope) return std::nullopt;
  return Ledge{{wall.at.x, top.at.y}, side};
}

}  // namespace game
