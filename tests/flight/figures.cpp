#include "tests/flight/figures.h"

#include <algorithm>
#include <cmath>

#include "engine/replay/cord_extremes.h"
#include "ribbon/cord_forces.h"
#include "ribbon/geometry/rotation.h"
#include "ribbon/geometry/separation.h"
#include "ribbon/system/held_body.h"
#include "tests/support/move_body.h"

namespace flight {
namespace {

using ribbon::Cord;
using ribbon::RigidBody;
using ribbon::Vec2;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// The pose of a body.
struct Place {
  RigidBody body;
  Vec2 turn{1.0, 0.0};  ///< rotation, as a complex number

  Vec2 of(Vec2 offset) const { return body.position + times(turn, offset); }
};

Place after_step(RigidBody body, double dt) {
  if (body.rests) return {body};
  const double turned = test_support::move_body(body, dt);
  return {body, ribbon::rotation(turned)};
}

double energy_of(const RigidBody& body) {
  if (body.inverse_mass == 0.0) return 0.0;
  double sum = (0.5 * dot(body.velocity, body.velocity) - dot(body.acceleration, body.position)) / body.inverse_mass;
  if (body.inverse_inertia > 0.0) sum += 0.5 * body.angular_velocity * body.angular_velocity / body.inverse_inertia;
  return sum;
}

struct Link {
  Vec2 a, b;
  int column;
};

/// Returns the links of a rope, or of a ribbon's outline.
std::vector<Link> outline(const Cord& cord) {
  std::vector<Link> links;
  const ribbon::CordDef& def = cord.def();
  const auto add = [&](int i, int j, int to_i, int to_j) {
    links.push_back({cord.positions()[at(cord.index(i, j))], cord.positions()[at(cord.index(to_i, to_j))], i});
  };
  for (int j = 0; j < def.rows; j += std::max(1, def.rows - 1)) {
    for (int i = 0; i + 1 < def.points; ++i) add(i, j, i + 1, j);
  }
  for (const int i : {0, def.points - 1}) {
    for (int j = 0; j + 1 < def.rows; ++j) add(i, j, i, j + 1);
  }
  return links;
}

/// Returns the distance of two links, m; `within` if it is greater.
double distance(const Link& p, const Link& q, double within) {
  double nearest = within;
  const auto take = [&nearest](Vec2 point, const Link& link) {
    if (!ribbon::may_be_within(nearest, point, link.a, link.b)) return;
    nearest = std::min(nearest, ribbon::find_separation(point, link.a, link.b).distance);
  };
  take(p.a, q);
  take(p.b, q);
  take(q.a, p);
  take(q.b, p);
  const auto side = [](const Link& link, Vec2 point) { return cross(link.b - link.a, point - link.a) > 0.0; };
  const bool cross_each_other = side(p, q.a) != side(p, q.b) && side(q, p.a) != side(q, p.b);
  return cross_each_other ? 0.0 : nearest;
}

/// Returns the penetration of two cords, m; ignores links that are near each other along one cord.
double depth_between(const Cord& a, const Cord& b, bool is_same) {
  const std::vector<Link> links_a = outline(a);
  const std::vector<Link> links_b = is_same ? links_a : outline(b);
  const ribbon::CordDef& def = a.def();
  const double contact = def.radius + b.def().radius;
  const int apart = 2 + static_cast<int>(std::ceil((2.0 * contact + def.width) / def.length * (def.points - 1)));
  double deepest = 0.0;
  for (std::size_t k = 0; k < links_a.size(); ++k) {
    for (std::size_t l = is_same ? k + 1 : 0; l < links_b.size(); ++l) {
      if (is_same && std::abs(links_a[k].column - links_b[l].column) < apart) continue;
      deepest = std::max(deepest, contact - distance(links_a[k], links_b[l], contact));
    }
  }
  return deepest;
}

double cord_depth(const std::vector<Cord>& cords) {
  double deepest = 0.0;
  for (std::size_t a = 0; a < cords.size(); ++a) {
    if (cords[a].def().self_contact) deepest = std::max(deepest, depth_between(cords[a], cords[a], true));
    if (!cords[a].def().cord_contact) continue;
    for (std::size_t b = a + 1; b < cords.size(); ++b) {
      if (cords[b].def().cord_contact) deepest = std::max(deepest, depth_between(cords[a], cords[b], false));
    }
  }
  return deepest;
}

void take_depth_in_bodies(const engine::SolverStep::Cord& recorded, const Cord& cord, int index,
                          const std::vector<Place>& places, Figures& figures) {
  const std::vector<Link> links = outline(cord);
  const auto take = [&](const Link& edge, double contact, int body) {
    for (const Link& link : links) {
      const double depth = contact - distance(edge, link, contact);
      if (depth <= figures.penetration) continue;
      figures.penetration = depth;
      figures.deep_cord = index;
      figures.deep_body = body;
    }
  };
  for (const ribbon::RigidCircle& circle : recorded.circles) {
    const Vec2 center = places[at(circle.body)].of(circle.offset);
    take({center, center, 0}, circle.radius + cord.def().radius, circle.body);
  }
  for (const ribbon::RigidSegment& segment : recorded.segments) {
    const Place& place = places[at(segment.body)];
    take({place.of(segment.a), place.of(segment.b), 0}, segment.radius + cord.def().radius, segment.body);
  }
}

double gap_of(const ribbon::Grip& grip, const Cord& cord, const std::vector<Place>& places, bool moved) {
  const Vec2 hand = places[at(grip.body)].of(moved ? grip.offset + grip.travel : grip.offset);
  const int column_before = grip.point / cord.def().rows;
  const double column = column_before + grip.along + (moved ? grip.climb : 0.0);
  const int last = cord.def().points - 1;
  const int first = std::clamp(static_cast<int>(std::floor(column)), 0, last);
  const int row = grip.point % cord.def().rows;
  const Vec2 a = cord.positions()[at(cord.index(first, row))];
  const Vec2 b = cord.positions()[at(cord.index(std::min(first + 1, last), row))];
  return length(a + std::clamp(column - first, 0.0, 1.0) * (b - a) - hand);
}

}  // namespace

Figures figures_of(const engine::SolverStep& step, const std::vector<Cord>& cords, const std::vector<RigidBody>& bodies,
                   bool moved) {
  Figures figures;
  std::vector<Place> places;
  for (const RigidBody& body : bodies) places.push_back(moved ? after_step(body, step.dt) : Place{body});
  for (const Place& place : places) figures.energy += energy_of(place.body);
  for (std::size_t k = 0; k < cords.size(); ++k) {
    const Cord& cord = cords[k];
    const int index = static_cast<int>(k);
    figures.finite = figures.finite && engine::is_finite(cord);
    const double stretch = engine::largest_stretch(cord);
    if (k == 0 || stretch > figures.stretch) figures.stretch = stretch, figures.stretched_cord = index;
    take_depth_in_bodies(step.cords[k], cord, index, places, figures);
    figures.speed = std::max(figures.speed, engine::largest_speed(cord));
    figures.energy += energy_of(cord, step.gravity).total();
    for (const ribbon::Grip& grip : step.cords[k].grips) {
      figures.grip_gap = std::max(figures.grip_gap, gap_of(grip, cord, places, moved));
    }
  }
  figures.cord_penetration = cord_depth(cords);
  return figures;
}

}  // namespace flight
