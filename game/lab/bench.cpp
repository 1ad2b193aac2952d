#include "game/lab/bench.h"

#include <numbers>
#include <utility>

#include "engine/scene/scene_tuning.h"
#include "ribbon/box2d/convert.h"

namespace game::lab {
namespace {

using ribbon::Vec2;
using ribbon::box2d::to_float;

// Categories of collision.
constexpr uint16 body_category = 1;
constexpr uint16 cord_category = 2;
constexpr uint16 load_category = 4;  // of what meets bodies alone

/// Cords and chains collide with bodies but loads. Cords declare by themselves whether they meet cords; chains do not.
b2Filter cord_filter(Method method) {
  b2Filter filter;
  filter.categoryBits = cord_category;
  filter.maskBits = method == Method::chains ? body_category : static_cast<uint16>(body_category | cord_category);
  return filter;
}

}  // namespace

Bench::Bench(Method method, Vec2 gravity) : method_(method), world_(to_float(gravity)) {
  const b2BodyDef fixed;
  ground_ = world_.CreateBody(&fixed);
}

void Bench::add(const ribbon::CordDef& def) {
  definitions_.push_back(def);
  if (method_ == Method::cords) {
    coupling_.add(ribbon::Cord(def), cord_filter(method_));
    return;
  }
  chains_.emplace_back(world_, def, cord_filter(method_));
  for (b2Body* box : chains_.back().boxes()) bodies_.push_back({box, engine::BodyKind::load});
  for (const int pin : def.pins) chains_.back().hold(pin, *ground_);
}

void Bench::add(const ribbon::ThesisDef& def) { coupling_.add(ribbon::ThesisCord(def), cord_filter(method_)); }

b2Body& Bench::add(const Disc& disc) {
  b2BodyDef def;
  def.type = disc.type;
  def.position = to_float(disc.at);
  def.linearDamping = static_cast<float>(disc.damping);
  def.angularDamping = static_cast<float>(disc.damping);
  b2Body* body = world_.CreateBody(&def);
  b2CircleShape shape;
  shape.m_radius = static_cast<float>(disc.radius);
  b2FixtureDef fixture;
  fixture.shape = &shape;
  fixture.friction = static_cast<float>(disc.friction);
  fixture.density = static_cast<float>(disc.mass / (std::numbers::pi * disc.radius * disc.radius));
  fixture.filter.categoryBits = disc.meets_cords ? body_category : load_category;
  body->CreateFixture(&fixture);
  bodies_.push_back({body, engine::BodyKind::circle});
  return *body;
}

void Bench::add_edges(std::span<const Vec2> corners, double friction) {
  const b2BodyDef def;
  b2Body* body = world_.CreateBody(&def);
  for (std::size_t k = 1; k < corners.size(); ++k) {
    b2EdgeShape shape;
    shape.SetTwoSided(to_float(corners[k - 1]), to_float(corners[k]));
    b2FixtureDef fixture;
    fixture.shape = &shape;
    fixture.friction = static_cast<float>(friction);
    fixture.filter.categoryBits = body_category;
    body->CreateFixture(&fixture);
  }
  bodies_.push_back({body, engine::BodyKind::ground});
}

void Bench::hold(int rope, int point, b2Body& body) {
  if (method_ == Method::chains) {
    chains_[static_cast<std::size_t>(rope)].hold(point, body);
    return;
  }
  const Vec2 place = coupling_.cord(rope).positions()[static_cast<std::size_t>(point)];
  coupling_.hold(rope, point, body, body.GetLocalPoint(to_float(place)));
}

void Bench::tick(const engine::TickInput& input) {
  drag_.apply(input, coupling_, bodies_, {}, dt);
  if (method_ == Method::cords) return coupling_.tick(world_, dt);
  for (int k = 0; k < chain_substeps_; ++k) world_.Step(static_cast<float>(dt / chain_substeps_), 8, 3);
}

void Bench::set_accuracy(const ribbon::Accuracy& accuracy) {
  for (const ribbon::box2d::CordId id : coupling_.cords()) {
    if (coupling_.cord(id).solver() == ribbon::box2d::Solver::direct)
      coupling_.cord(id).direct().set_accuracy(accuracy);
  }
}

void Bench::change_cords(const std::function<void(ribbon::CordDef& def)>& change) {
  for (const ribbon::box2d::CordId id : coupling_.cords()) {
    if (coupling_.cord(id).solver() != ribbon::box2d::Solver::direct) continue;
    ribbon::Cord& cord = coupling_.cord(id).direct();
    ribbon::CordDef def = cord.def();
    change(def);
    engine::retune(cord, std::move(def));
  }
}

void Bench::change_thesis_cords(const std::function<void(ribbon::ThesisDef& def)>& change) {
  for (const ribbon::box2d::CordId id : coupling_.cords()) {
    if (coupling_.cord(id).solver() != ribbon::box2d::Solver::thesis) continue;
    ribbon::ThesisDef def = coupling_.cord(id).thesis().def();
    change(def);
    engine::retune(coupling_.cord(id).thesis(), def);
  }
}

void Bench::set_friction(double friction) {
  change_cords([friction](ribbon::CordDef& def) { def.friction = friction; });
  for (b2Body* body = world_.GetBodyList(); body != nullptr; body = body->GetNext()) {
    for (b2Fixture* fixture = body->GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext()) {
      fixture->SetFriction(static_cast<float>(friction));
    }
  }
  // A contact that exists keeps the friction that it began with.
  for (b2Contact* contact = world_.GetContactList(); contact != nullptr; contact = contact->GetNext())
    contact->ResetFriction();
}

void Bench::set_mass(b2Body& disc, double mass) const {
  const auto radius = static_cast<double>(disc.GetFixtureList()->GetShape()->m_radius);
  disc.GetFixtureList()->SetDensity(static_cast<float>(mass / (std::numbers::pi * radius * radius)));
  disc.ResetMassData();
  disc.SetAwake(true);
}

}  // namespace game::lab
