#include "game/lab/joint_chain.h"

#include <cmath>

#include "ribbon/box2d/convert.h"

namespace game::lab {
namespace {

using ribbon::Vec2;
using ribbon::box2d::to_float;

/// A box's skin is half its thickness, because Box2D's own skin is a centimetre.
void add_shape(b2Body& box, const ribbon::CordDef& def, double length, const b2Filter& filter) {
  const auto half_thickness = static_cast<float>(0.5 * def.radius);
  b2PolygonShape shape;
  shape.SetAsBox(static_cast<float>(0.5 * length), half_thickness);
  shape.m_radius = half_thickness;
  b2FixtureDef fixture;
  fixture.shape = &shape;
  fixture.friction = static_cast<float>(def.friction);
  fixture.restitution = static_cast<float>(def.restitution);
  fixture.filter = filter;
  box.CreateFixture(&fixture);
}

b2Body* make_box(b2World& world, const ribbon::CordDef& def, Vec2 a, Vec2 b, const b2Filter& filter) {
  b2BodyDef body;
  body.type = b2_dynamicBody;
  body.position = to_float(0.5 * (a + b));
  body.angle = static_cast<float>(std::atan2(b.y - a.y, b.x - a.x));
  body.linearDamping = static_cast<float>(def.drag);
  body.angularDamping = static_cast<float>(def.drag);
  b2Body* box = world.CreateBody(&body);
  const double length = ribbon::length(b - a);
  add_shape(*box, def, length, filter);
  const double mass = def.mass_per_length * def.length / (def.points - 1);
  const b2MassData data{static_cast<float>(mass), b2Vec2_zero, static_cast<float>(0.25 * mass * length * length)};
  box->SetMassData(&data);
  return box;
}

/// The definition of a joint between neighbours, at `place`.
void join(b2World& world, b2Body* a, b2Body* b, b2Vec2 place, const ribbon::CordDef& def) {
  if (def.bending_stiffness == 0.0) {
    b2RevoluteJointDef joint;
    joint.Initialize(a, b, place);
    world.CreateJoint(&joint);
    return;
  }
  const double spring = def.bending_stiffness * (def.points - 1) / def.length;  // N·m, W = ½·EI/l·θ²
  b2WeldJointDef joint;
  joint.Initialize(a, b, place);
  joint.referenceAngle = 2.0F * b2_pi * std::round(joint.referenceAngle / (2.0F * b2_pi));  // straight at rest
  joint.stiffness = static_cast<float>(spring);
  joint.damping = static_cast<float>(def.damping * spring);
  world.CreateJoint(&joint);
}

}  // namespace

JointChain::JointChain(b2World& world, const ribbon::CordDef& def, const b2Filter& filter) : world_(&world) {
  for (std::size_t k = 0; k + 1 < static_cast<std::size_t>(def.points); ++k) {
    const Vec2 a = def.positions[k];
    const Vec2 b = def.positions[k + 1];
    b2Body* box = make_box(world, def, a, b, filter);
    if (k > 0) join(world, boxes_.back(), box, to_float(a), def);
    boxes_.push_back(box);
    half_lengths_.push_back(static_cast<float>(0.5 * ribbon::length(b - a)));
  }
}

b2Vec2 JointChain::point(int k) const {
  const float half = half_lengths_[index_of(k)];
  return box_of(k).GetWorldPoint({k == 0 ? -half : half, 0.0F});
}

std::pair<b2Vec2, b2Vec2> JointChain::ends(int box) const {
  const auto index = static_cast<std::size_t>(box);
  const b2Body& body = *boxes_[index];
  return {body.GetWorldPoint({-half_lengths_[index], 0.0F}), body.GetWorldPoint({half_lengths_[index], 0.0F})};
}

b2RevoluteJoint& JointChain::hold(int point, b2Body& body) const {
  b2RevoluteJointDef joint;
  joint.Initialize(&body, &box_of(point), this->point(point));
  return static_cast<b2RevoluteJoint&>(*world_->CreateJoint(&joint));
}

}  // namespace game::lab
