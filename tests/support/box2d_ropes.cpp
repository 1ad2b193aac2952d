#include "tests/support/box2d_ropes.h"

#include "tests/support/exact_chain.h"

namespace test_support {
namespace {

constexpr auto link_length = static_cast<float>(heavy::length / heavy::links);
constexpr auto link_mass = static_cast<float>(heavy::rope_mass / heavy::links);
constexpr auto load_mass = static_cast<float>(heavy::load_mass);
constexpr auto rope_length = static_cast<float>(heavy::length);
const b2Vec2 gravity{0.0F, static_cast<float>(-heavy::gravity)};

/// b2Rope gives its positions only by drawing itself.
class PointCollector final : public b2Draw {
 public:
  explicit PointCollector(std::vector<b2Vec2>& points) : points_(points) {}
  void DrawSegment(const b2Vec2&, const b2Vec2&, const b2Color&) override {}
  void DrawPoint(const b2Vec2& point, float, const b2Color&) override { points_.push_back(point); }
  void DrawPolygon(const b2Vec2*, int32, const b2Color&) override {}
  void DrawSolidPolygon(const b2Vec2*, int32, const b2Color&) override {}
  void DrawCircle(const b2Vec2&, float, const b2Color&) override {}
  void DrawSolidCircle(const b2Vec2&, float, const b2Vec2&, const b2Color&) override {}
  void DrawTransform(const b2Transform&) override {}

 private:
  std::vector<b2Vec2>& points_;
};

}  // namespace

Box2dChain::Box2dChain(Limit limit) : world_(gravity) {
  const b2BodyDef fixed;
  b2Body* pin = world_.CreateBody(&fixed);
  for (int k = 0; k < heavy::links; ++k) {
    const float x = (static_cast<float>(k) + 0.5F) * link_length;
    links_.push_back(make_body(x, link_mass, 0.25F * link_mass * link_length * link_length));
  }
  load_ = make_body(rope_length, load_mass, 0.0F);
  for (std::size_t k = 0; k < links_.size(); ++k) {
    join(k == 0 ? pin : links_[k - 1], links_[k], static_cast<float>(k) * link_length);
  }
  join(links_.back(), load_, rope_length);
  if (limit == Limit::max_distance) keep_near(pin);
}

b2Body* Box2dChain::make_body(float x, float mass, float inertia) {
  b2BodyDef def;
  def.type = b2_dynamicBody;
  def.position = {x, 0.0F};
  def.allowSleep = false;
  b2Body* body = world_.CreateBody(&def);
  const b2MassData mass_data{mass, b2Vec2_zero, inertia};
  body->SetMassData(&mass_data);
  return body;
}

void Box2dChain::join(b2Body* a, b2Body* b, float x) {
  b2RevoluteJointDef def;
  def.Initialize(a, b, {x, 0.0F});
  world_.CreateJoint(&def);
}

void Box2dChain::keep_near(b2Body* pin) {
  b2DistanceJointDef def;
  def.bodyA = pin;
  def.bodyB = load_;
  def.minLength = 0.0F;
  def.maxLength = rope_length;
  world_.CreateJoint(&def);
}

Box2dRope::Box2dRope(const b2RopeTuning& tuning) {
  std::vector<b2Vec2> points;
  std::vector<float> masses;
  for (int k = 0; k <= heavy::links; ++k) {
    points.push_back({static_cast<float>(k) * link_length, 0.0F});
    masses.push_back(link_mass);
  }
  masses.front() = 0.0F;  // none: fixed
  masses.back() = 0.5F * link_mass + load_mass;
  b2RopeDef def;
  def.vertices = points.data();
  def.count = static_cast<int32>(points.size());
  def.masses = masses.data();
  def.gravity = gravity;
  def.tuning = tuning;
  rope_.Create(def);
}

std::vector<b2Vec2> Box2dRope::positions() const {
  std::vector<b2Vec2> points;
  PointCollector collector(points);
  rope_.Draw(&collector);
  return points;
}

b2RopeTuning without_bending(b2StretchingModel model, float hertz) {
  b2RopeTuning tuning;
  tuning.stretchingModel = model;
  tuning.stretchStiffness = 1.0F;
  tuning.stretchHertz = hertz;
  tuning.stretchDamping = 0.0F;
  // A value that is none of Box2D's models, so that it spends no time on bending.
  tuning.bendingModel = static_cast<b2BendingModel>(7);
  return tuning;
}

}  // namespace test_support
