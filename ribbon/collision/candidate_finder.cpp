#include "ribbon/collision/candidate_finder.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>

#include "ribbon/collision/add_pair.h"
#include "ribbon/collision/outline.h"
#include "ribbon/geometry/separation.h"
#include "ribbon/linear/index.h"

namespace ribbon {
namespace {

bool grips(const Member& member, int body) {
  const auto& grips = member.surroundings.grips;
  return std::any_of(grips.begin(), grips.end(), [body](const Grip& grip) { return grip.body == body; });
}

/// A body does not touch a cord that it holds, as bodies that a joint connects do not touch each other. It does not
/// touch other pieces of that cord either: where it was cut they may lie in the body.
bool holds(const IslandState& state, const Member& member, int body) {
  if (grips(member, body)) return true;
  if (member.cord->state.family == 0) return false;
  return std::any_of(state.members.begin(), state.members.end(), [&](const Member& other) {
    return other.cord->is_piece_with(*member.cord) && grips(other, body);
  });
}

double longest_link(const IslandState& state, const Member& member) {
  double longest2 = 0.0;
  for (int k = 0; k < outline_links(*member.cord); ++k) {
    const Vec2 along = state.positions[outline_slot(member, k + 1)] - state.positions[outline_slot(member, k)];
    longest2 = std::max(longest2, dot(along, along));
  }
  return std::sqrt(longest2);
}

/// Returns whether a link is constrained within contact distance of a circle. If neither moves, nothing that the cord
/// could do would part them: a bridge hangs from the corner of a rock.
bool is_fixed_in(const IslandState& state, const ContactPair& link, Vec2 center, double contact_distance) {
  const auto is_in = [&](int end) {
    return state.constrained[at(end)] != 0 && length(state.positions[at(end)] - center) < contact_distance;
  };
  return is_in(link.a) || is_in(link.b);
}

/// Returns the mean displacement of all points in free motion, m: cords that move together do not touch for it.
Vec2 mean_displacement(const IslandState& state, std::span<const Vec2> ends) {
  Vec2 sum;
  for (std::size_t p = 0; p < state.points; ++p) sum += ends[p] - state.positions[p];
  return (1.0 / static_cast<double>(state.points)) * sum;
}

/// Returns the distance [m] of a point and a link that in free motion may come within another distance of each other.
std::optional<double> distance_within(const IslandState& state, std::span<const Vec2> ends, std::size_t disc,
                                      const Member& member, int link, double distance) {
  const std::size_t a = outline_slot(member, link);
  const std::size_t b = outline_slot(member, link + 1);
  const auto& x = state.positions;
  const Vec2 displacement = ends[disc] - x[disc];
  const Vec2 past_a = displacement - (ends[a] - x[a]);
  const Vec2 past_b = displacement - (ends[b] - x[b]);
  const double swept = distance + std::sqrt(std::max(dot(past_a, past_a), dot(past_b, past_b)));
  if (!may_be_within(swept, x[disc], x[a], x[b])) return std::nullopt;
  const double now = find_separation(x[disc], x[a], x[b]).distance;
  if (!(now <= swept)) return std::nullopt;
  return now;
}

bool may_touch_cords(const IslandState& state, const CordDef& def) {
  return def.self_contact || (def.cord_contact && state.members.size() > 1);
}

}  // namespace

CandidateFinder::LinkBoxes::LinkBoxes() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  left.fill(infinity);
  right.fill(-infinity);
  bottom.fill(infinity);
  top.fill(-infinity);
}

void CandidateFinder::LinkBoxes::set(std::size_t k, const Box& box) {
  left[k] = box.low.x;
  right[k] = box.high.x;
  bottom[k] = box.low.y;
  top[k] = box.high.y;
}

unsigned CandidateFinder::LinkBoxes::overlapping(const Box& box) const {
  unsigned bits = 0;
  for (std::size_t k = 0; k < block; ++k) {
    // Without branches: which boxes overlap is not predictable.
    const auto x = static_cast<unsigned>(left[k] <= box.high.x) & static_cast<unsigned>(box.low.x <= right[k]);
    const auto y = static_cast<unsigned>(bottom[k] <= box.high.y) & static_cast<unsigned>(box.low.y <= top[k]);
    bits |= (x & y) << k;
  }
  return bits;
}

void CandidateFinder::find(IslandState& state, MotionBounds& bounds, Contacts& contacts) {
  contacts.clear(state.points);
  state.touch_changed = false;
  bounds.disable();
  if (std::none_of(state.members.begin(), state.members.end(), std::mem_fn(&Member::may_touch))) return;
  bounds.find(state);
  for (std::size_t m = 0; m < state.members.size(); ++m) {
    const Member& member = state.members[m];
    touches_.list(*member.cord);
    const Search search{state, bounds, contacts, member, touches_, bounds.of(m), {}};
    sweep_outline(search);
    const double longest = member.surroundings.circles.empty() ? 0.0 : longest_link(state, member);
    for (const RigidCircle& circle : member.surroundings.circles) {
      if (!holds(state, member, circle.body)) find_circle(search, circle, longest);
    }
    for (const RigidSegment& segment : member.surroundings.segments) {
      if (!holds(state, member, segment.body)) find_segment(search, segment);
    }
    state.touch_changed = state.touch_changed || member.cord->state.touch_changed;
  }
  find_cords(state, bounds, contacts);
}

/// Finds the boxes in which the points of the outline stay.
void CandidateFinder::sweep_outline(const Search& search) {
  outline_boxes_.clear();
  for (const int point : search.member.cord->outline) {
    const std::size_t p = search.member.first_point + at(point);
    outline_boxes_.push_back(box_around(search.state.positions[p], search.bounds.ends()[p], 0.0));
  }
  swept_aabb_ = outline_boxes_[0];
  for (const Box& box : outline_boxes_) swept_aabb_ = joined(swept_aabb_, box);
  swept_aabb_ = widened(swept_aabb_, search.bound);
}

/// Adds the links that may touch a circle. Between the points of a circle with radius R ≥ 10·L a link of length L is
/// deeper by L²/8R at most, an eightieth of a link. A cord that is straight by that little has one minimum of the
/// distance to it, and a cord that bends around it has one per link. As one became the other, the contact energy would
/// jump. So the points touch such a circle.
void CandidateFinder::find_circle(const Search& search, const RigidCircle& circle, double longest_link) {
  IslandState& state = search.state;
  const Member& member = search.member;
  const RigidBody& body = state.rigid[at(circle.body)];
  const double contact_distance = circle.radius + member.cord->def.radius;
  const Box box = widened(search.bounds.anchor_box(state, body, circle.offset), contact_distance);
  if (!overlap(box, swept_aabb_)) return;
  const Box near = widened(box, search.bound);
  const bool by_points = contact_distance >= large_circle * longest_link;
  const int points = static_cast<int>(member.cord->outline.size());
  const int count = by_points ? points : outline_links(*member.cord);
  int disc = -1;
  for (int k = 0; k < count; ++k) {
    const Box& start = outline_boxes_[at(k)];
    const Box& end = outline_boxes_[at(by_points ? k : k + 1 < points ? k + 1 : 0)];
    if (!overlap(joined(start, end), near) || is_on_wheel(*member.cord, k, by_points)) continue;
    ContactPair pair = by_points ? pair_with_point(member, k) : pair_with_link(member, k);
    if (body.inverse_mass == 0.0 && is_fixed_in(state, pair, body.position + circle.offset, contact_distance)) continue;
    if (disc < 0) disc = add_anchor(state, search.contacts, circle.body, circle.offset);
    pair.disc = disc;
    pair.contact_distance = contact_distance;
    pair.disc_radius = circle.radius;
    pair.tangent_speed = circle.tangent_speed;
    pair.touch.other = circle.id;
    pair.touch.feature = by_points ? 2 * k + 1 : 2 * k;
    add_pair(state, search.contacts,
             {member, search.touches, member.pressing_mass, circle.friction, circle.restitution},
             initial_distance(state, search.contacts, pair), pair);
  }
}

/// Adds the points that may touch the inside of an edge; its ends are circles.
void CandidateFinder::find_segment(const Search& search, const RigidSegment& segment) {
  IslandState& state = search.state;
  const Member& member = search.member;
  const CordParts& cord = *member.cord;
  const RigidBody& body = state.rigid[at(segment.body)];
  const double contact_distance = segment.radius + cord.def.radius;
  const Box box = widened(
      joined(search.bounds.anchor_box(state, body, segment.a), search.bounds.anchor_box(state, body, segment.b)),
      contact_distance);
  if (!overlap(box, swept_aabb_)) return;
  const Box near = widened(box, search.bound);
  int a = -1;
  int b = -1;
  for (int k = 0; k < static_cast<int>(cord.outline.size()); ++k) {
    if (!overlap(outline_boxes_[at(k)], near) || is_on_wheel(cord, k, true)) continue;
    const std::size_t point = outline_slot(member, k);
    if (body.inverse_mass == 0.0 && state.constrained[point] != 0) continue;
    if (a < 0) {
      a = add_anchor(state, search.contacts, segment.body, segment.a);
      b = add_anchor(state, search.contacts, segment.body, segment.b);
    }
    ContactPair pair;
    pair.disc = static_cast<int>(point);
    pair.a = a;
    pair.b = b;
    pair.owns_ends = false;
    pair.contact_distance = contact_distance;
    pair.disc_radius = cord.def.radius;
    pair.tangent_speed = segment.tangent_speed;
    pair.touch.other = segment.id;
    pair.touch.feature = 2 * k + 1;
    add_pair(state, search.contacts,
             {member, search.touches, member.pressing_mass, segment.friction, segment.restitution},
             initial_distance(state, search.contacts, pair), pair);
  }
}

/// Adds pairs of points of cords and links of the same or of other cords, for the cords that declare such contacts.
/// They are looked for by blocks of neighbours, which mostly are all near each other or all apart.
void CandidateFinder::find_cords(IslandState& state, const MotionBounds& bounds, Contacts& contacts) {
  const Vec2 drift = mean_displacement(state, bounds.ends());
  box_links(state, bounds, drift);
  if (link_boxes_.empty()) return;
  build_tree();
  for (std::size_t m = 0; m < state.members.size(); ++m) {
    const Member& member = state.members[m];
    if (!member.cord->def.self_contact && !member.cord->def.cord_contact) continue;
    touches_.list(*member.cord);
    rest_positions_.clear();
    if (member.cord->def.self_contact) list_rest_positions(member.cord->def, rest_positions_);
    const Search search{state, bounds, contacts, member, touches_, bounds.of(m), rest_positions_};
    for (std::size_t k = 0; k < member.cord->outline.size(); k += block) find_block(search, k, drift);
  }
}

void CandidateFinder::box_links(const IslandState& state, const MotionBounds& bounds, Vec2 drift) {
  link_boxes_.clear();
  links_.clear();
  block_boxes_.clear();
  for (std::size_t m = 0; m < state.members.size(); ++m) {
    const Member& member = state.members[m];
    if (!may_touch_cords(state, member.cord->def)) continue;
    const auto swept = [&](int k) {
      const std::size_t p = outline_slot(member, k);
      return box_around(state.positions[p], bounds.ends()[p] - drift, 0.0);
    };
    for (int k = 0; k < outline_links(*member.cord); ++k) {
      const Box box = widened(joined(swept(k), swept(k + 1)), member.cord->def.radius + bounds.of(m));
      const std::size_t place = links_.size() % block;
      if (place == 0) {
        link_boxes_.emplace_back();
        block_boxes_.push_back(box);
      } else {
        block_boxes_.back() = joined(block_boxes_.back(), box);
      }
      link_boxes_.back().set(place, box);
      links_.push_back({m, k});
    }
  }
}

void CandidateFinder::build_tree() {
  if (!tree_ || tree_capacity_ < block_boxes_.size()) {
    tree_capacity_ = 2 * block_boxes_.size();
    tree_ = std::make_unique<Quadtree>(static_cast<int>(tree_capacity_));
  }
  tree_->build(block_boxes_);
}

/// Looks for links near a block of the outline's points, from k on.
void CandidateFinder::find_block(const Search& search, std::size_t k, Vec2 drift) {
  const CordParts& cord = *search.member.cord;
  std::array<Box, block> boxes;
  const std::size_t count = std::min(block, cord.outline.size() - k);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t p = search.member.first_point + at(cord.outline[k + i]);
    boxes[i] = box_around(search.state.positions[p], search.bounds.ends()[p] - drift, cord.def.radius + search.bound);
  }
  const Box all =
      std::accumulate(boxes.begin() + 1, boxes.begin() + static_cast<std::ptrdiff_t>(count), boxes[0], joined);
  tree_->query(all, [&](int item) {
    for (std::size_t i = 0; i < count; ++i) {
      if (!overlap(boxes[i], block_boxes_[at(item)])) continue;
      for (unsigned near = link_boxes_[at(item)].overlapping(boxes[i]); near != 0; near &= near - 1) {
        const OutlineLink& link = links_[block * at(item) + static_cast<std::size_t>(std::countr_zero(near))];
        find_link(search, static_cast<int>(k + i), link, search.bounds.of(link.member));
      }
    }
  });
}

/// Adds the outline's point k of a cord and a link of this or another cord, if they may touch.
void CandidateFinder::find_link(const Search& search, int k, const OutlineLink& link, double other_bound) {
  IslandState& state = search.state;
  const Member& member = search.member;
  const Member& other = state.members[link.member];
  const bool itself = &other == &member;
  if (itself && is_end_of_link(member.cord->def, k, link.link)) return;
  if (is_on_wheel(*member.cord, k, true) || is_on_wheel(*other.cord, link.link, false)) return;
  const CordDef& def = member.cord->def;
  if (itself ? !def.self_contact : !member.cord->meets(*other.cord)) return;
  const std::size_t disc = outline_slot(member, k);
  const double contact_distance = def.radius + other.cord->def.radius;
  const double bound =
      itself && are_close(*member.cord, k, link.link) ? search.bounds.near_of(link.member) : search.bound + other_bound;
  const std::optional<double> distance =
      distance_within(state, search.bounds.ends(), disc, other, link.link, contact_distance + bound);
  if (!distance) return;
  const bool near_at_rest = itself && may_be_neighbours(def, search.rest, k, link.link);
  const auto is_excluded = [&](int of_other) {
    if (itself) return near_at_rest && are_neighbours(def, search.rest, k, of_other);
    return were_neighbours(member, k, other, of_other) || are_tied(state, member, k, other, of_other);
  };
  if (is_excluded(link.link)) return;
  ContactPair pair = pair_with_link(other, link.link);
  pair.disc = static_cast<int>(disc);
  pair.is_mutual = true;
  // At a fold the next link may be the point's neighbour. Then this link alone decides whether it touches.
  if (is_excluded(link.link - 1)) pair.previous = -1;
  if (is_excluded(link.link + 1)) pair.next = -1;
  pair.contact_distance = contact_distance;
  pair.disc_radius = def.radius;
  pair.touch.other = other.id;
  pair.touch.feature = 2 * k + 1;
  pair.touch.other_feature = link.link + 1;
  const double mass = itself ? member.pressing_mass : member.pressing_mass + other.pressing_mass;
  add_pair(state, search.contacts,
           {member, search.touches, mass, other.cord->def.friction, other.cord->def.restitution}, *distance, pair);
}

}  // namespace ribbon
