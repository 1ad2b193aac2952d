#include "tests/support/coupled_world.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ribbon/box2d/convert.h"
#include "ribbon/cord_forces.h"
#include "tests/support/contact_figures.h"
#include "tests/support/shape_world.h"

namespace test_support {
namespace {

using game::lab::JointChain;
using ribbon::Vec2;
using ribbon::box2d::to_double;
using ribbon::box2d::to_float;

/// Returns the energy of a cord of the thesis, J, without that of its springs, which is negligible for such
/// stiffnesses.
double energy_of(const ribbon::ThesisCord& cord, Vec2 gravity) {
  double sum = 0.0;
  for (std::size_t p = 0; p < cord.positions().size(); ++p) {
    const Vec2 v = cord.velocities()[p];
    sum += cord.def().point_mass * (0.5 * dot(v, v) - dot(gravity, cord.positions()[p]));
  }
  return sum;
}

template <typename Cord>
void slow_down(Cord& cord) {
  for (std::size_t p = 0; p < cord.positions().size(); ++p) {
    cord.set_velocity(static_cast<int>(p), 0.9 * cord.velocities()[p]);
  }
}

/// Returns the default positions of a cord.
std::vector<Vec2> laid_out(const ribbon::CordDef& def) {
  if (!def.positions.empty()) return def.positions;
  const ribbon::Cord cord(def);
  return {cord.positions().begin(), cord.positions().end()};
}

/// The same cord as a cord of the thesis. Its springs correct the same share of a link's error for any number of
/// substeps. (With shares of 0.9 and more, the springs across a cell oscillate in contacts with circles, up to 100
/// m/s.)
ribbon::ThesisDef thesis_def(const ribbon::CordDef& def, const CordMethod& method) {
  const double inverse_substep = method.substeps / CoupledWorld::dt;
  ribbon::ThesisDef thesis;
  thesis.w = def.points;
  thesis.h = std::max(def.rows, 2);
  thesis.spacing = def.length / (def.points - 1);
  thesis.point_mass = def.mass_per_length * def.length / (thesis.w * thesis.h);
  const double kappa = method.spring_share / (1.0 - method.spring_share);
  thesis.spring_stiffness = 0.5 * kappa * thesis.point_mass * inverse_substep * inverse_substep;
  thesis.bar_damping = thesis.point_mass * inverse_substep;
  thesis.self_collision = def.self_contact;
  thesis.substeps = method.substeps;
  const int rows = thesis.h / def.rows;
  for (const int pin : def.pins) thesis.pins.push_back(rows * pin);
  const std::vector<Vec2>& line = def.positions;
  thesis.positions = line;
  if (rows == 1) return thesis;
  thesis.positions.clear();
  for (std::size_t p = 0; p < line.size(); ++p) {
    const Vec2 along = line[std::min(p + 1, line.size() - 1)] - line[p > 0 ? p - 1 : 0];
    thesis.positions.push_back(line[p]);
    thesis.positions.push_back(line[p] - (thesis.spacing / length(along)) * perp(along));
  }
  return thesis;
}

}  // namespace

CoupledWorld::CoupledWorld(const CordMethod& method, Vec2 gravity) : world(to_float(gravity)), method_(method) {
  world.SetAllowSleeping(false);
  const b2BodyDef fixed;
  ground_ = world.CreateBody(&fixed);
}

int CoupledWorld::add(ribbon::CordDef def) {
  def.positions = laid_out(def);
  def.accuracy = method_.accuracy;
  defs_.push_back(std::move(def));
  if (method_.chain) {
    add_chain(defs_.back());
  } else if (method_.thesis) {
    coupling.add(ribbon::ThesisCord(thesis_def(defs_.back(), method_)));
  } else {
    coupling.add(ribbon::Cord(defs_.back()));
  }
  return static_cast<int>(defs_.size()) - 1;
}

void CoupledWorld::add_chain(const ribbon::CordDef& def) {
  b2Filter filter;
  filter.categoryBits = box_category;
  if (!method_.chain_self_contact) filter.maskBits &= static_cast<uint16>(~box_category);
  chains_.push_back({JointChain(world, def, filter)});
  const int cord = static_cast<int>(chains_.size()) - 1;
  for (const int pin : def.pins) hold_chain(cord, pin, *ground_);
}

b2Body& CoupledWorld::add_circle(b2BodyType type, Vec2 position, double radius, double mass, double friction) {
  b2BodyDef def;
  def.type = type;
  def.position = to_float(position);
  b2Body* body = world.CreateBody(&def);
  b2CircleShape shape;
  shape.m_radius = static_cast<float>(radius);
  b2FixtureDef fixture;
  fixture.shape = &shape;
  fixture.density = static_cast<float>(mass) / (b2_pi * shape.m_radius * shape.m_radius);
  fixture.friction = static_cast<float>(friction);
  body->CreateFixture(&fixture);
  return *body;
}

b2Body& CoupledWorld::add_edges(const std::vector<Vec2>& corners, double friction) {
  const b2BodyDef def;
  b2Body* body = world.CreateBody(&def);
  for (std::size_t k = 1; k < corners.size(); ++k) {
    b2EdgeShape shape;
    shape.SetTwoSided(to_float(corners[k - 1]), to_float(corners[k]));
    b2FixtureDef fixture;
    fixture.shape = &shape;
    fixture.friction = static_cast<float>(friction);
    fixture.filter.categoryBits = edge_category;
    body->CreateFixture(&fixture);
  }
  return *body;
}

b2Body& CoupledWorld::add_load(b2BodyType type, Vec2 position, double mass, double inertia) {
  b2BodyDef def;
  def.type = type;
  def.position = to_float(position);
  b2Body* body = world.CreateBody(&def);
  if (type != b2_dynamicBody) return *body;
  const b2MassData data{static_cast<float>(mass), b2Vec2_zero, static_cast<float>(inertia)};
  body->SetMassData(&data);
  return *body;
}

bool CoupledWorld::is_first(int cord, int point) const { return point < defs_[at(cord)].points / 2; }

int CoupledWorld::end_of(const Chain& chain, int cord, int point) const {
  return is_first(cord, point) ? 0 : chain.boxes.points() - 1;
}

void CoupledWorld::hold(int cord, int point, b2Body& body) {
  if (method_.chain) {
    hold_chain(cord, point, body);
  } else {
    const int index = index_of(cord, point);
    coupling.hold(cord, index, body, body.GetLocalPoint(to_float(coupling.cord(cord).positions()[at(index)])));
  }
}

void CoupledWorld::hold_chain(int cord, int point, b2Body& body) {
  Chain& chain = chains_[at(cord)];
  (is_first(cord, point) ? chain.first : chain.last) = &chain.boxes.hold(end_of(chain, cord, point), body);
}

void CoupledWorld::pull(int cord, int point, Vec2 force) {
  if (!method_.chain && !method_.thesis) coupling.cord(cord).direct().set_load(point, force);
  for (Pull& pull : pulls_) {
    if (pull.cord != cord || pull.point != point) continue;
    pull.force = force;
    return;
  }
  pulls_.push_back({cord, point, force});
}

void CoupledWorld::step_cords() {
  if (coupling.size() == 0) return;
  if (method_.thesis) pull_thesis_cords();
  test_support::step_cords(coupling, world, dt);
}

void CoupledWorld::pull_thesis_cords() {
  for (const Pull& pull : pulls_) {
    ribbon::ThesisCord& cord = coupling.cord(pull.cord).thesis();
    const int point = index_of(pull.cord, pull.point);
    cord.set_velocity(point, cord.velocities()[at(point)] + (dt / cord.def().point_mass) * pull.force);
  }
}

void CoupledWorld::step_world() {
  const int substeps = method_.chain ? method_.substeps : 1;
  for (int k = 0; k < substeps; ++k) {
    for (const Pull& pull : pulls_) {
      if (!method_.chain) break;
      const Chain& chain = chains_[at(pull.cord)];
      const int end = end_of(chain, pull.cord, pull.point);
      chain.boxes.box_of(end).ApplyForce(to_float(pull.force), chain.boxes.point(end), true);
    }
    world.Step(static_cast<float>(dt / substeps), method_.velocity_iterations, method_.position_iterations);
  }
}

std::vector<Vec2> CoupledWorld::points(int cord) const {
  if (!method_.chain) {
    const auto positions = coupling.cord(cord).positions();
    std::vector<Vec2> points;
    const int count = defs_[at(cord)].points * defs_[at(cord)].rows;
    for (int p = 0; p < count; ++p) points.push_back(positions[at(index_of(cord, p))]);
    return points;
  }
  const JointChain& boxes = chains_[at(cord)].boxes;
  std::vector<Vec2> points;
  for (int k = 0; k < boxes.points(); ++k) points.push_back(to_double(boxes.point(k)));
  return points;
}

std::vector<Vec2> CoupledWorld::outline(int cord) const {
  if (!is_closed(cord)) return points(cord);
  return outline_of(coupling.cord(cord).positions(), rows(cord));
}

double CoupledWorld::tension(int cord, int point) const {
  const bool first = is_first(cord, point);
  if (method_.thesis) return std::numeric_limits<double>::quiet_NaN();
  if (!method_.chain) {
    const auto tensions = coupling.cord(cord).direct().tensions();
    return first ? tensions.front() : tensions.back();
  }
  const Chain& chain = chains_[at(cord)];
  b2Joint* joint = first ? chain.first : chain.last;
  const float rate = static_cast<float>(method_.substeps / dt);
  return joint == nullptr ? 0.0 : static_cast<double>(joint->GetReactionForce(rate).Length());
}

double CoupledWorld::energy() const {
  const Vec2 gravity = to_double(world.GetGravity());
  double sum = 0.0;
  for (int c = 0; c < coupling.size(); ++c) {
    sum += method_.thesis ? energy_of(coupling.cord(c).thesis(), gravity)
                          : energy_of(coupling.cord(c).direct(), gravity).total();
  }
  for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
    if (body->GetType() != b2_dynamicBody) continue;
    const Vec2 v = velocity(*body);
    const double mass = static_cast<double>(body->GetMass());
    const double turning = static_cast<double>(body->GetAngularVelocity());
    sum += mass * (0.5 * dot(v, v) - dot(gravity, to_double(body->GetWorldCenter())));
    sum += 0.5 * static_cast<double>(body->GetInertia()) * turning * turning;
  }
  for (const Pull& pull : pulls_) {
    if (method_.thesis) sum -= dot(pull.force, points(pull.cord)[at(pull.point)]);
    if (!method_.chain) continue;  // included in the cord's energy
    const Chain& chain = chains_[at(pull.cord)];
    sum -= dot(pull.force, to_double(chain.boxes.point(end_of(chain, pull.cord, pull.point))));
  }
  return sum;
}

double CoupledWorld::energy_scale() const {
  double mass = 0.0;
  double longest = 0.0;
  for (const ribbon::CordDef& def : defs_) {
    longest = std::max(longest, def.length);
    if (!method_.chain) mass += def.mass_per_length * def.length;
  }
  for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
    mass += static_cast<double>(body->GetMass());
  }
  double force = mass * length(to_double(world.GetGravity()));
  for (const Pull& pull : pulls_) force += length(pull.force);
  return force * longest;
}

void CoupledWorld::settle(int ticks) {
  damp_bodies(6.0F);
  for (int k = 0; k < ticks; ++k) {
    tick();
    for (int c = 0; c < coupling.size(); ++c) {
      method_.thesis ? slow_down(coupling.cord(c).thesis()) : slow_down(coupling.cord(c).direct());
    }
  }
  damp_bodies(0.0F);
}

void CoupledWorld::damp_bodies(float damping) {
  for (b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
    body->SetLinearDamping(damping);
    body->SetAngularDamping(damping);
  }
}

}  // namespace test_support
