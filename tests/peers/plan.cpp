#include "tests/peers/plan.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "ribbon/box2d/convert.h"

namespace peers {
namespace {

using nlohmann::ordered_json;
using ribbon::Vec2;
using ribbon::box2d::to_double;
using test_support::CoupledWorld;

/// Returns the bodies in order of creation; Box2D lists the newest first.
std::vector<const b2Body*> in_creation_order(const b2World& world) {
  std::vector<const b2Body*> bodies;
  for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) bodies.push_back(body);
  std::reverse(bodies.begin(), bodies.end());
  return bodies;
}

void add_shape(BodyPlan& plan, const b2Fixture& fixture, const b2Body& body) {
  plan.friction = static_cast<double>(fixture.GetFriction());
  if (fixture.GetType() == b2Shape::e_circle) {
    plan.radius = static_cast<double>(fixture.GetShape()->m_radius);
    return;
  }
  if (fixture.GetType() != b2Shape::e_edge) {
    throw std::invalid_argument("a plan has circles, edges and the links of cords; there is another shape");
  }
  const auto& edge = static_cast<const b2EdgeShape&>(*fixture.GetShape());
  plan.edges.emplace_back(to_double(body.GetWorldPoint(edge.m_vertex1)), to_double(body.GetWorldPoint(edge.m_vertex2)));
}

bool is_link(const b2Body& body) {
  const b2Fixture* fixture = body.GetFixtureList();
  return fixture != nullptr && fixture->GetFilterData().categoryBits == CoupledWorld::box_category;
}

BodyPlan body_plan(const b2Body& body) {
  BodyPlan plan;
  plan.dynamic = body.GetType() == b2_dynamicBody;
  plan.position = to_double(body.GetPosition());
  plan.angle = static_cast<double>(body.GetAngle());
  plan.mass = static_cast<double>(body.GetMass());
  plan.inertia = static_cast<double>(body.GetInertia());
  if (is_link(body)) {
    plan.friction = static_cast<double>(body.GetFixtureList()->GetFriction());
    return plan;
  }
  for (const b2Fixture* fixture = body.GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext()) {
    add_shape(plan, *fixture, body);
  }
  return plan;
}

/// Assigns the links to cords. Links are created cord by cord, each from the first point on.
void assign_links(Plan& plan, const std::vector<const b2Body*>& bodies) {
  std::size_t next = 0;
  for (CordPlan& cord : plan.cords) {
    for (int k = 0; k + 1 < cord.def.points; ++k) {
      while (!is_link(*bodies.at(next))) ++next;
      cord.links.push_back(static_cast<int>(next));
      BodyPlan& link = plan.bodies[next++];
      link.radius = cord.def.radius;
      const std::size_t p = static_cast<std::size_t>(k);
      link.half_length = 0.5 * length(cord.def.positions[p + 1] - cord.def.positions[p]);
    }
  }
}

/// Returns the point of a cord at which a link's hinge is: only the ends of a chain are held.
int point_of(const CordPlan& cord, int link) { return link == cord.links.front() ? 0 : cord.def.points - 1; }

void add_hinges(Plan& plan, const std::vector<const b2Body*>& bodies, b2World& world) {
  std::map<const b2Body*, int> places;  // for lookup only: the order of pointers is not deterministic
  for (std::size_t k = 0; k < bodies.size(); ++k) places[bodies[k]] = static_cast<int>(k);
  for (b2Joint* joint = world.GetJointList(); joint != nullptr; joint = joint->GetNext()) {
    plan.hinges.push_back({places.at(joint->GetBodyA()), places.at(joint->GetBodyB()), to_double(joint->GetAnchorB())});
  }
  std::reverse(plan.hinges.begin(), plan.hinges.end());
  for (const HingePlan& hinge : plan.hinges) {
    if (plan.bodies[static_cast<std::size_t>(hinge.a)].half_length > 0.0) continue;
    if (!plan.bodies[static_cast<std::size_t>(hinge.a)].dynamic) continue;  // a pin
    for (CordPlan& cord : plan.cords) {
      if (std::find(cord.links.begin(), cord.links.end(), hinge.b) == cord.links.end()) continue;
      cord.held.emplace_back(point_of(cord, hinge.b), hinge.a);
    }
  }
}

ordered_json json_of(Vec2 v) { return {v.x, v.y}; }

ordered_json json_of(const BodyPlan& body) {
  ordered_json json{{"dynamic", body.dynamic},       {"position", json_of(body.position)},
                    {"angle", body.angle},           {"mass", body.mass},
                    {"inertia", body.inertia},       {"friction", body.friction},
                    {"radius", body.radius},         {"halfLength", body.half_length},
                    {"edges", ordered_json::array()}};
  for (const auto& [a, b] : body.edges) json["edges"].push_back({json_of(a), json_of(b)});
  return json;
}

ordered_json json_of(const CordPlan& cord) {
  const ribbon::CordDef& def = cord.def;
  ordered_json json{{"points", def.points},
                    {"rows", def.rows},
                    {"mass", def.mass_per_length * def.length},
                    {"radius", def.radius},
                    {"width", def.width},
                    {"friction", def.friction},
                    {"selfContact", def.self_contact},
                    {"cordContact", def.cord_contact},
                    {"pins", def.pins},
                    {"links", cord.links},
                    {"held", ordered_json::array()},
                    {"positions", ordered_json::array()}};
  for (const auto& [point, body] : cord.held) json["held"].push_back({{"point", point}, {"body", body}});
  for (const Vec2 position : def.positions) json["positions"].push_back(json_of(position));
  return json;
}

}  // namespace

std::vector<b2Body*> moving_bodies_of(b2World& world) {
  std::vector<b2Body*> list;
  for (b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
    if (body->GetType() == b2_dynamicBody && !is_link(*body)) list.push_back(body);
  }
  std::reverse(list.begin(), list.end());  // Box2D lists the newest first
  return list;
}

std::vector<int> Plan::moving_bodies() const {
  std::vector<int> list;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (bodies[k].dynamic && bodies[k].half_length == 0.0) list.push_back(static_cast<int>(k));
  }
  return list;
}

Plan plan_of(const SetUp& set_up, int settling_ticks, int ticks) {
  // Create the cords first, because ribbons have no chain.
  CoupledWorld cords(test_support::CordMethod{});
  set_up(cords);
  test_support::CordMethod how;
  how.chain = cords.cords() > 0 && cords.def(0).rows == 1;
  CoupledWorld world(how);
  set_up(world);

  Plan plan;
  plan.gravity = to_double(world.world.GetGravity());
  plan.settling_ticks = settling_ticks;
  plan.ticks = ticks;
  for (int c = 0; c < world.cords(); ++c) plan.cords.push_back({world.def(c)});
  const std::vector<const b2Body*> bodies = in_creation_order(world.world);
  for (const b2Body* body : bodies) plan.bodies.push_back(body_plan(*body));
  if (how.chain) {
    assign_links(plan, bodies);
    add_hinges(plan, bodies, world.world);
  }
  return plan;
}

std::string to_json(const Plan& plan) {
  ordered_json json{{"dt", CoupledWorld::dt},
                    {"gravity", json_of(plan.gravity)},
                    {"settlingTicks", plan.settling_ticks},
                    {"ticks", plan.ticks},
                    {"bodies", ordered_json::array()},
                    {"hinges", ordered_json::array()},
                    {"movingBodies", plan.moving_bodies()},
                    {"cords", ordered_json::array()}};
  for (const BodyPlan& body : plan.bodies) json["bodies"].push_back(json_of(body));
  for (const HingePlan& hinge : plan.hinges) {
    json["hinges"].push_back({{"a", hinge.a}, {"b", hinge.b}, {"place", json_of(hinge.place)}});
  }
  for (const CordPlan& cord : plan.cords) json["cords"].push_back(json_of(cord));
  return json.dump();
}

}  // namespace peers
