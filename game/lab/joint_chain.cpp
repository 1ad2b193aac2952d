#include "game/lab/joint_chain.h"

#include <cmath>

#include "ribbon/box2d/convert.h"

namespace game::lab {
namespace {

using ribbon::Vec2;
using ribbon::box2d::to_float;

b2Body* make_box(b2World& world, const ribbon::CordDef& def, Vec2 a, Vec2 b, const b2Filter& filter) {
  b2BodyDef body;
  body.type = b2_dynamicBody;
  body.position = to_float(0.5 * (a + b));
  body.angle = static_cast<float>(std::atan2(b.y - a.y, b.x - a.x));
  b2Body* box = world.CreateBody(&body);
  const double length = ribbon::length(b - a);
  // A box's skin is half its thickness, because Box2D's own skin is a centimetre.
  const auto half_thickness = static_cast<float>(0.5 * def.radius);
  b2PolygonShape shape;
  shape.SetAsBox(static_cast<float>(0.5 * length), half_thickness);
  shape.m_radius = half_thickness;
  b2FixtureDef fixture;
  fixture.shape = &shape;
  fixture.friction = static_cast<float>(def.friction);
  fixture.filter = filter;
  box->CreateFixture(&fixture);
  const double mass = def.mass_per_length * def.length / (def.points - 1);
  const b2MassData data{static_cast<float>(mass), b2Vec2_zero, static_cast<float>(0.25 * mass * length * length)};
  box->SetMassData(&data);
  return box;
}

}  // namespace

JointChain::JointChain(b2World& world, const ribbon::CordDef& def, const b2Filter& filter)
    : world_(&world), half_length_(static_cast<float>(0.5 * def.length / (def.points - 1))) {
  for (std::size_t k = 0; k + 1 < static_cast<std::size_t>(def.points); ++k) {
    b2Body* box = make_box(world, def, def.positions[k], def.positions[k + 1], filter);
    if (k > 0) {
      b2RevoluteJointDef joint;
      joint.Initialize(boxes_.back(), box, to_float(def.positions[k]));
      world.CreateJoint(&joint);
    }
    boxes_.push_back(box);
  }
}

b2Vec2 JointChain::point(int k) const {
  return boxes_[box_of(k)]->GetWorldPoint({k == 0 ? -half_length_ : half_length_, 0.0F});
}

std::pair<b2Vec2, b2Vec2> JointChain::ends(int box) const {
  const b2Body& body = *boxes_[static_cast<std::size_t>(box)];
  return {body.GetWorldPoint({-half_length_, 0.0F}), body.GetWorldPoint({half_length_, 0.0F})};
}

void JointChain::hold(int point, b2Body& body) const {
  b2RevoluteJointDef joint;
  joint.Initialize(&body, boxes_[box_of(point)], this->point(point));
  world_->CreateJoint(&joint);
}

}  // namespace game::lab
