#include "ribbon/collision/add_pair.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ribbon/geometry/separation.h"
#include "ribbon/linear/index.h"

namespace ribbon {
namespace {

// Of the contact distance, or of ten links if that is less: a larger depth is no equilibrium of a contact.
constexpr double deep_share = 0.01;
constexpr double depenetrated_share = 0.1;       // of such a depth, by which the step lets it out,
constexpr double max_depenetration_speed = 1.0;  // m/s, but no faster
constexpr double negligible_way = 1e-3;  // of a direction's length: less is that of a straight rope, or rounding

/// m, where an anchor is at the start of the step.
Vec2 anchor_position(const IslandState& state, const Contacts& contacts, int anchor) {
  if (at(anchor) < state.points) return state.positions[at(anchor)];
  return contacts.scene.anchors.body(anchor).current;
}

/// Restores what the cord stored of the contact in the last step. A body that was near in that step and is gone may
/// have made the contact stiffer: then it cannot be compressed by as much as the force would need.
void restore_touch(const StoredTouches& touches, ContactPair& pair) {
  if (const Touch* before = touches.find(pair.touch)) pair.touch = *before;
  pair.touch.force = std::min(pair.touch.force, pair.stiffness * pair.contact_distance);
  pair.touch.impulse = 0.0;
  pair.touch.push = {};
}

/// Reduces the contact distance of a pair that penetrates deeply, for example because a body was moved without regard
/// to cords. The contact does not get the energy of that depth; the penetration ends over one step or several. This
/// step removes no more than its share.
void limit_penetration(const IslandState& state, double distance, double size, double share, ContactPair& pair) {
  const double depth = pair.contact_distance - distance;
  if (depth > deep_share * size) pair.contact_distance = distance + depenetrated_share * depth;
  pair.initial_penetration = std::max(0.0, pair.contact_distance - distance - pair.touch.force / pair.stiffness);
  const double max_in = std::min(state.dt * max_depenetration_speed, share * pair.initial_penetration);
  if (pair.initial_penetration > max_in) {
    pair.contact_distance -= pair.initial_penetration - max_in;
    pair.initial_penetration = max_in;
  }
}

/// Returns the sum of the directions from a point to its neighbours in its cord; zero within a straight rope.
Vec2 toward_neighbours(const IslandState& state, int slot) {
  const auto p = at(slot);
  const Member& member = *std::find_if(state.members.begin(), state.members.end(),
                                       [p](const Member& candidate) { return candidate.has_point(p); });
  const auto rows = static_cast<std::size_t>(member.cord->def.rows);
  const std::size_t i = p - member.first_point;
  Vec2 sum;
  const auto add = [&](std::size_t neighbour) {
    const Vec2 way = state.positions[neighbour] - state.positions[p];
    if (const double size = length(way); size > 0.0) sum += (1.0 / size) * way;
  };
  if (i >= rows) add(p - rows);
  if (i + rows < member.points) add(p + rows);
  if (i % rows > 0) add(p - 1);
  if (i % rows + 1 < rows) add(p + 1);
  return sum;
}

/// Returns the direction in which a point leaves a link of a cord that it coincides with, as where a tie has ended: to
/// the side on which its own cord is, away from where the other one is. Returns zero if both are on both sides.
Vec2 parting_direction(const IslandState& state, const ContactPair& pair) {
  const Separation gap =
      find_separation(state.positions[at(pair.disc)], state.positions[at(pair.a)], state.positions[at(pair.b)]);
  Vec2 way = toward_neighbours(state, pair.disc);
  if (!gap.is_interior()) {
    way -= toward_neighbours(state, gap.along == 0.0 ? pair.a : pair.b);
  } else {
    way = dot(way, perp(gap.tangent)) * perp(gap.tangent);
  }
  const double size = length(way);
  return size > negligible_way ? (1.0 / size) * way : Vec2{};
}

}  // namespace

int add_anchor(IslandState& state, Contacts& contacts, int body, Vec2 arm) {
  const RigidBody& rigid = state.rigid[at(body)];
  BodyAnchor anchor;
  anchor.arm = arm;
  anchor.current = rigid.start_of(arm);
  if (rigid.inverse_mass > 0.0) {
    anchor.center = static_cast<int>(state.center(state.solved_body(body)));
  } else {
    anchor.body_position = rigid.position;
    anchor.velocity = rigid.velocity;
    anchor.angular_velocity = rigid.angular_velocity;
  }
  return contacts.scene.add(anchor);
}

double initial_distance(const IslandState& state, const Contacts& contacts, const ContactPair& pair) {
  const Vec2 disc = anchor_position(state, contacts, pair.disc);
  const Vec2 a = anchor_position(state, contacts, pair.a);
  const Vec2 b = anchor_position(state, contacts, pair.b);
  if (!may_be_within(pair.contact_distance, disc, a, b)) return std::numeric_limits<double>::infinity();
  return find_separation(disc, a, b).distance;
}

void add_pair(const IslandState& state, Contacts& contacts, const PairSurfaces& surfaces, double distance,
              ContactPair& pair) {
  const Member& member = surfaces.member;
  const CordDef& def = member.cord->def;
  pair.cord = static_cast<std::size_t>(&member - state.members.data());
  pair.stiffness =
      (state.accuracy.soft_contacts ? CompliantContacts::soft_stiffness_factor : CompliantContacts::stiffness_factor) *
      surfaces.mass / (state.dt * state.dt);
  pair.friction = std::sqrt(def.friction * surfaces.friction);
  pair.restitution = std::max(def.restitution, surfaces.restitution);
  restore_touch(surfaces.touches, pair);
  if (pair.is_mutual && distance <= ContactPair::coincident_share * pair.contact_distance) {
    pair.parting = parting_direction(state, pair);
  }
  limit_penetration(state, distance, std::min(pair.contact_distance, large_circle * member.cord->state.rest[0]),
                    member.cord->state.depenetration_share, pair);
  contacts.scene.add(pair);
}

}  // namespace ribbon
