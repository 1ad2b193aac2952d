#include "game/simulation/player_body.h"

#include "ribbon/box2d/convert.h"

namespace game {
namespace {

void add_capsule(b2Body& body, const PlayerTuning& tuning) {
  const auto radius = static_cast<float>(tuning.radius);
  const auto straight =
      static_cast<float>(0.5 * tuning.height - tuning.radius);  // half of the part between the circles
  b2FixtureDef fixture;
  fixture.friction = 0.0F;  // Player::run controls the speed, and walls must not stop a fall
  fixture.filter.categoryBits = player_category;
  b2CircleShape circle;
  circle.m_radius = radius;
  b2PolygonShape box;
  box.SetAsBox(radius, straight);
  fixture.shape = &box;
  body.CreateFixture(&fixture);
  fixture.shape = &circle;
  for (const float y : {-straight, straight}) {
    circle.m_p = {0.0F, y};
    body.CreateFixture(&fixture);
  }
}

}  // namespace

b2Body* make_player_body(b2World& world, ribbon::Vec2 feet, const PlayerTuning& tuning) {
  b2BodyDef definition;
  definition.type = b2_dynamicBody;
  definition.fixedRotation = true;
  definition.allowSleep = false;
  definition.position = ribbon::box2d::to_float(feet + ribbon::Vec2{0.0, 0.5 * tuning.height});
  b2Body* body = world.CreateBody(&definition);
  add_capsule(*body, tuning);
  b2MassData mass;
  mass.mass = static_cast<float>(tuning.mass);
  mass.center.SetZero();
  mass.I = 0.0F;
  body->SetMassData(&mass);
  return body;
}

}  // namespace game
