#include "tests/study/tunnelling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "ribbon/box2d/convert.h"
#include "tests/study/trace.h"
#include "tests/support/contact_figures.h"

namespace study {
namespace {

using ribbon::Vec2;
using ribbon::box2d::to_double;
using Line = std::vector<Vec2>;

constexpr std::size_t lag = 15;    // ticks, accepted delay between a run and its reference
constexpr double untouched = 3.0;  // radii at rest from a tie, within which its cords do not touch: see Coupling::tie

bool is_circle(const b2Fixture& fixture) { return fixture.GetType() == b2Shape::e_circle; }

Vec2 center_of(const b2Fixture& fixture) {
  const b2Shape& shape = *fixture.GetShape();
  b2Vec2 local{0.0F, 0.0F};
  if (is_circle(fixture)) local = static_cast<const b2CircleShape&>(shape).m_p;
  if (fixture.GetType() == b2Shape::e_polygon) local = static_cast<const b2PolygonShape&>(shape).m_centroid;
  return to_double(fixture.GetBody()->GetWorldPoint(local));
}

double radius_of(const b2Fixture& fixture) {
  return is_circle(fixture) ? static_cast<double>(fixture.GetShape()->m_radius) : 0.0;
}

std::vector<const b2Fixture*> fixtures_of(const b2World& world, const b2Filter& filter) {
  std::vector<const b2Fixture*> fixtures;
  for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
    for (const b2Fixture* fixture = body->GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext()) {
      if (test_support::meets(*fixture, filter)) fixtures.push_back(fixture);
    }
  }
  return fixtures;
}

LinkAndPoint link_and_point(const TunnellingDetector::Moment& moment, std::size_t cord, std::size_t link,
                            std::size_t fixture) {
  const Line& line = moment.lines[cord];
  return {line[link], line[link + 1], moment.centers[fixture]};
}

/// Returns for each column of a cord whether one of its points is driven.
std::vector<char> driven_columns(const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord) {
  const ribbon::box2d::CordShape shape = coupling.cord(cord).shape();
  std::vector<char> driven(static_cast<std::size_t>(shape.columns), 0);
  for (int p = 0; p < shape.columns * shape.rows; ++p) {
    if (coupling.cord(cord).kind(p) != ribbon::PointKind::free) driven[static_cast<std::size_t>(p / shape.rows)] = 1;
  }
  return driven;
}

/// Returns whether the body holds the cord. Then they do not collide.
bool holds(const b2Body& body, const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord) {
  const std::optional<ribbon::box2d::CordPoint> place = coupling.body(body).held_place();
  return place && place->cord == cord;
}

/// Returns whether the link is, or was, so near that it may have crossed the fixture.
bool may_overlap(const b2Fixture& fixture, const LinkAndPoint& was, const LinkAndPoint& is) {
  b2AABB box;
  fixture.GetShape()->ComputeAABB(&box, fixture.GetBody()->GetTransform(), 0);
  const Vec2 low = to_double(box.lowerBound) - (is.c - was.c);
  const Vec2 high = to_double(box.upperBound) - (is.c - was.c);
  const auto [left, right] = std::minmax({was.a.x, was.b.x, is.a.x, is.b.x});
  const auto [bottom, top] = std::minmax({was.a.y, was.b.y, is.a.y, is.b.y});
  return std::min(low.x, to_double(box.lowerBound).x) <= right &&
         left <= std::max(high.x, to_double(box.upperBound).x) && std::min(low.y, to_double(box.lowerBound).y) <= top &&
         bottom <= std::max(high.y, to_double(box.upperBound).y);
}

/// Returns whether a link of this half thickness is on both sides of the fixture, or moved to its other side.
bool is_through(const b2Fixture& fixture, const LinkAndPoint& was, const LinkAndPoint& is, double half_thickness) {
  if (!may_overlap(fixture, was, is)) return false;
  const double depth = test_support::depth(fixture, is.a, is.b);
  switch (fixture.GetType()) {
    case b2Shape::e_edge: return depth > 0.0;
    case b2Shape::e_circle: return depth > std::max(radius_of(fixture) - half_thickness, 0.0) || crosses(was, is);
    default: return depth > half_thickness || crosses(was, is);
  }
}

bool is_marked(const std::vector<Crossings>& crossings, std::size_t from, std::size_t to, std::size_t cord, int kind) {
  for (std::size_t k = from; k < std::min(to, crossings.size()); ++k) {
    if (cord < crossings[k].size() && (crossings[k][cord] & kind) != 0) return true;
  }
  return false;
}

/// Cords of the thesis do not declare contacts; for them every contact counts as declared.
bool may_declare(const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord, bool ribbon::CordDef::*contact) {
  return coupling.cord(cord).solver() == ribbon::box2d::Solver::thesis || coupling.cord(cord).direct().def().*contact;
}

void mark(Crossings& crossings, int cord, Crossed kind) {
  unsigned char& bits = crossings[static_cast<std::size_t>(cord)];
  bits = static_cast<unsigned char>(bits | kind);
}

/// A cord of a tie: its columns at rest, and where it is tied.
struct TiedCord {
  TiedCord(const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId id, int point) {
    const ribbon::CordDef& def = coupling.cord(id).direct().def();
    for (int link = 0; link + 1 < def.points; ++link)
      arcs.push_back(arcs.back() + coupling.cord(id).direct().rest_length(link));
    tied = arcs[static_cast<std::size_t>(point / def.rows)];
    reach = untouched * def.radius;
  }

  /// Returns whether a link begins or ends so near the tie that its end touches nothing of the other cord there.
  bool is_near_with_an_end(std::size_t link) const {
    return std::min(std::abs(arcs[link] - tied), std::abs(arcs[link + 1] - tied)) < reach;
  }
  /// Returns whether any place of a link is so near.
  bool is_near(std::size_t link) const { return arcs[link] - tied < reach && tied - arcs[link + 1] < reach; }

  std::vector<double> arcs{0.0};  // m
  double tied = 0.0;              // m
  double reach = 0.0;             // m
};

/// Returns the crossings of two cords that are not near one of their ties, where they do not touch by definition.
int crossings_beside_ties(const b2World& world, const ribbon::box2d::Coupling& coupling, const std::vector<Line>& lines,
                          ribbon::box2d::CordId a, ribbon::box2d::CordId b) {
  const Line& line = lines[static_cast<std::size_t>(a)];
  const Line& other = lines[static_cast<std::size_t>(b)];
  const int all = test_support::mutual_crossings(line, false, other, false);
  if (all == 0) return 0;
  ribbon::box2d::Coupling::State state;
  coupling.save(world, state);
  std::vector<std::pair<TiedCord, TiedCord>> ties;
  for (const ribbon::box2d::TieMemory& tie : state.ties) {
    const auto [own, its] = tie.place.cord == a ? std::pair(tie.place, tie.other) : std::pair(tie.other, tie.place);
    if (own.cord != a || its.cord != b) continue;
    ties.emplace_back(TiedCord(coupling, a, own.point), TiedCord(coupling, b, its.point));
  }
  if (ties.empty()) return all;
  int count = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    for (std::size_t j = 0; j + 1 < other.size(); ++j) {
      if (!test_support::is_crossing(line[i], line[i + 1], other[j], other[j + 1])) continue;
      const bool is_near_a_tie = std::any_of(ties.begin(), ties.end(), [i, j](const auto& tie) {
        const auto& [own, its] = tie;
        return (own.is_near_with_an_end(i) && its.is_near(j)) || (its.is_near_with_an_end(j) && own.is_near(i));
      });
      count += is_near_a_tie ? 0 : 1;
    }
  }
  return count;
}

void mark_crossings(Crossings& crossings, const b2World& world, const ribbon::box2d::Coupling& coupling,
                    const std::vector<Line>& lines) {
  for (const ribbon::box2d::CordId a : coupling.cords()) {
    const Line& line = lines[static_cast<std::size_t>(a)];
    if (may_declare(coupling, a, &ribbon::CordDef::self_contact) && test_support::self_crossings(line, false) > 0) {
      mark(crossings, a, through_itself);
    }
    if (!may_declare(coupling, a, &ribbon::CordDef::cord_contact)) continue;
    for (const ribbon::box2d::CordId b : coupling.cords()) {
      if (b >= a) break;
      if (!may_declare(coupling, b, &ribbon::CordDef::cord_contact)) continue;
      if (coupling.cord(a).solver() != coupling.cord(b).solver()) continue;  // these never touch
      if (crossings_beside_ties(world, coupling, lines, a, b) == 0) continue;
      mark(crossings, a, through_cord);
      mark(crossings, b, through_cord);
    }
  }
}

}  // namespace

bool crosses(const LinkAndPoint& before, const LinkAndPoint& after) {
  // Relative to c the ends are p + t·dp and q + t·dq. They are in line with c where their cross product is 0.
  const Vec2 p = before.a - before.c;
  const Vec2 q = before.b - before.c;
  const Vec2 dp = after.a - after.c - p;
  const Vec2 dq = after.b - after.c - q;
  const double c0 = cross(p, q);
  const double c1 = cross(p, dq) + cross(dp, q);
  const double c2 = cross(dp, dq);
  const auto is_between = [&](double t) { return t > 0.0 && t <= 1.0 && dot(p + t * dp, q + t * dq) < 0.0; };
  const double root = std::sqrt(std::max(c1 * c1 - 4.0 * c2 * c0, 0.0));
  if (c1 * c1 < 4.0 * c2 * c0) return false;
  // Both roots without cancellation; one is NaN if the equation is linear.
  const double sum = -0.5 * (c1 + std::copysign(root, c1));
  return (sum != 0.0 && is_between(c0 / sum)) || (c2 != 0.0 && is_between(sum / c2));
}

Crossings TunnellingDetector::detect(const b2World& world, const ribbon::box2d::Coupling& coupling,
                                     const b2Filter& filter) {
  const std::vector<const b2Fixture*> fixtures = fixtures_of(world, filter);
  Moment now;
  for (const b2Fixture* fixture : fixtures) now.centers.push_back(center_of(*fixture));
  if (coupling.size() > 0) now.lines.resize(static_cast<std::size_t>(coupling.cords().back()) + 1);
  for (const ribbon::box2d::CordId c : coupling.cords()) {
    now.lines[static_cast<std::size_t>(c)] = middle_line(coupling, c);
  }
  const bool centers_known = before_.centers.size() == now.centers.size();

  Crossings found(now.lines.size(), 0);
  for (const ribbon::box2d::CordId c : coupling.cords()) {
    const auto line = static_cast<std::size_t>(c);
    const bool is_known = centers_known && line < before_.lines.size() &&
                          before_.lines[line].size() == now.lines[line].size();  // not one that is new, or was cut
    const Moment& before = is_known ? before_ : now;
    const std::vector<char> driven = driven_columns(coupling, c);
    const double half_thickness = 0.5 * coupling.cord(c).shape().thickness;
    for (std::size_t k = 0; k + 1 < driven.size(); ++k) {
      if (driven[k] != 0 || driven[k + 1] != 0) continue;
      for (std::size_t f = 0; f < fixtures.size(); ++f) {
        const LinkAndPoint was = link_and_point(before, line, k, f);
        const LinkAndPoint is = link_and_point(now, line, k, f);
        if (is_through(*fixtures[f], was, is, half_thickness) && !holds(*fixtures[f]->GetBody(), coupling, c))
          mark(found, c, through_body);
      }
    }
  }
  mark_crossings(found, world, coupling, now.lines);
  before_ = std::move(now);
  return found;
}

unsigned char declared_contacts(const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord) {
  Crossings declared = {through_body};
  if (coupling.cord(cord).solver() == ribbon::box2d::Solver::direct) {
    if (coupling.cord(cord).direct().def().self_contact) mark(declared, 0, through_itself);
    if (coupling.cord(cord).direct().def().cord_contact) mark(declared, 0, through_cord);
  }
  return declared.front();
}

std::string tunnelling_failure(const std::vector<Crossings>& run, const std::vector<Crossings>& reference,
                               const Crossings& declared, std::size_t ticks) {
  constexpr std::array<std::pair<Crossed, const char*>, 3> kinds = {
      {{through_body, "a body"}, {through_itself, "itself"}, {through_cord, "another cord"}}};
  for (std::size_t k = 0; k < run.size(); ++k) {
    const std::size_t from = std::min(k, ticks) - std::min({k, ticks, lag});
    const std::size_t to = k < ticks ? k + lag + 1 : reference.size();
    for (std::size_t c = 0; c < std::min(run[k].size(), declared.size()); ++c) {
      for (const auto& [kind, what] : kinds) {
        if ((run[k][c] & declared[c] & kind) == 0 || is_marked(reference, from, to, c, kind)) continue;
        return "cord " + std::to_string(c + 1) + " went through " + what + " in tick " + std::to_string(k + 1);
      }
    }
  }
  return {};
}

}  // namespace study
