#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "ribbon/island/island.h"

// The outlines of cords, and where they may touch each other, or themselves.

namespace ribbon {
namespace {

// Times the radius: parts of a cord that lie nearer than that at rest are not in each other's way.
constexpr double own_neighbourhood = 3.0;
constexpr std::size_t block = 8;  // points or links of an outline that are looked for at once

}  // namespace

int Island::links(const Cord& cord) {
  const int points = static_cast<int>(cord.outline_.size());
  return cord.def_.rows == 1 ? points - 1 : points;
}

/// The link k of the outline, as the segment of a pair.
ContactPair Island::pair_with_link(const Member& member, int k) const {
  const std::vector<int>& outline = member.cord->outline_;
  const int n = static_cast<int>(outline.size());
  const bool closed = member.cord->def_.rows > 1;
  const auto anchor = [&](int i) {
    if (closed) return static_cast<int>(member.first) + outline[at((i + n) % n)];
    return i < 0 || i >= n ? -1 : static_cast<int>(member.first) + outline[at(i)];
  };
  ContactPair pair;
  pair.a = anchor(k);
  pair.b = anchor(k + 1);
  pair.before = anchor(k - 1);
  pair.after = anchor(k + 2);
  return pair;
}

/// The point k of the outline, as a segment without length.
ContactPair Island::pair_with_point(const Member& member, int k) {
  ContactPair pair;
  pair.a = static_cast<int>(member.first) + member.cord->outline_[at(k)];
  pair.b = pair.a;
  return pair;
}

double Island::longest_link(const Member& member) const {
  double longest2 = 0.0;
  const std::vector<int>& outline = member.cord->outline_;
  for (int k = 0; k < links(*member.cord); ++k) {
    const std::size_t a = member.first + at(outline[at(k)]);
    const std::size_t b = member.first + at(outline[at(k + 1) < outline.size() ? at(k + 1) : 0]);
    const Vec2 along = positions_[b] - positions_[a];
    longest2 = std::max(longest2, dot(along, along));
  }
  return std::sqrt(longest2);
}

/// Points of cords against links, of the same and of other cords, as far as these declare it: by blocks of neighbours,
/// which mostly are near each other or all of them not.
void Island::meet_each_other() {
  link_boxes_.clear();
  outline_links_.clear();
  block_boxes_.clear();
  const Vec2 drift = mean_way();
  for (std::size_t m = 0; m < members_.size(); ++m) {
    const CordDef& def = members_[m].cord->def_;
    if (!def.self_contact && (!def.cord_contact || members_.size() == 1)) continue;
    for (int k = 0; k < links(*members_[m].cord); ++k) {
      const ContactPair link = pair_with_link(members_[m], k);
      const std::size_t a = at(link.a);
      const std::size_t b = at(link.b);
      const Box box = widened(
          joined(box_around(positions_[a], ends_[a] - drift, 0.0), box_around(positions_[b], ends_[b] - drift, 0.0)),
          def.radius + members_[m].room);
      if (link_boxes_.size() % block == 0) {
        block_boxes_.push_back(box);
      } else {
        block_boxes_.back() = joined(block_boxes_.back(), box);
      }
      link_boxes_.push_back(box);
      outline_links_.push_back({m, k});
    }
  }
  if (link_boxes_.empty()) return;
  if (!tree_ || tree_room_ < block_boxes_.size()) {
    tree_room_ = 2 * block_boxes_.size();
    tree_ = std::make_unique<Quadtree>(static_cast<int>(tree_room_));
  }
  tree_->build(block_boxes_);
  for (const Member& member : members_) {
    const Cord& cord = *member.cord;
    if (!cord.def_.self_contact && !cord.def_.cord_contact) continue;
    for (std::size_t k = 0; k < cord.outline_.size(); k += block) meet_block(member, k, drift);
  }
}

/// The outline's points from k on, a block of them, against all links.
void Island::meet_block(const Member& member, std::size_t k, Vec2 drift) {
  const Cord& cord = *member.cord;
  std::array<Box, block> boxes;
  const std::size_t count = std::min(block, cord.outline_.size() - k);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t p = member.first + at(cord.outline_[k + i]);
    boxes[i] = box_around(positions_[p], ends_[p] - drift, cord.def_.radius + member.room);
  }
  const Box all =
      std::accumulate(boxes.begin() + 1, boxes.begin() + static_cast<std::ptrdiff_t>(count), boxes[0], joined);
  tree_->query(all, [&](int item) {
    const std::size_t first = block * at(item);
    const std::size_t end = std::min(first + block, link_boxes_.size());
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t link = first; link < end; ++link) {
        if (overlap(boxes[i], link_boxes_[link])) meet_link(member, static_cast<int>(k + i), outline_links_[link]);
      }
    }
  });
}

/// How far all of it goes in the step, on average: what goes together does not meet.
Vec2 Island::mean_way() const {
  Vec2 sum;
  for (std::size_t p = 0; p < count_; ++p) sum += ends_[p] - positions_[p];
  return (1.0 / static_cast<double>(count_)) * sum;
}

/// The outline's point k of a cord against a link of this or another one.
void Island::meet_link(const Member& member, int k, const OutlineLink& link) {
  const Member& other = members_[link.member];
  const bool itself = &other == &member;
  const CordDef& def = member.cord->def_;
  if (itself ? !def.self_contact : !def.cord_contact || !other.cord->def_.cord_contact) return;
  const std::size_t disc = member.first + at(member.cord->outline_[at(k)]);
  const double reach = def.radius + other.cord->def_.radius;
  const double room = itself && are_close(*member.cord, k, link.link) ? member.near_room : member.room + other.room;
  if (!may_meet(disc, link, reach + room)) return;
  if (itself && are_neighbours(def, k, link.link)) return;
  ContactPair pair = pair_with_link(other, link.link);
  pair.disc = static_cast<int>(disc);
  pair.mutual = true;
  // At a fold the link next to this one may be the point's neighbour: then none but this one can tell that it touches.
  if (itself && are_neighbours(def, k, link.link - 1)) pair.before = -1;
  if (itself && are_neighbours(def, k, link.link + 1)) pair.after = -1;
  pair.reach = reach;
  pair.disc_radius = def.radius;
  pair.touch.other = other.id;
  pair.touch.feature = 2 * k + 1;
  pair.touch.other_feature = link.link + 1;
  add_pair(member, pair, itself ? member.mass : member.mass + other.mass, other.cord->def_.friction,
           other.cord->def_.restitution);
}

/// Whether on their straight ways a point and a link may come as near each other as that.
bool Island::may_meet(std::size_t disc, const OutlineLink& link, double distance) const {
  const Member& member = members_[link.member];
  const std::vector<int>& outline = member.cord->outline_;
  const std::size_t a = member.first + at(outline[at(link.link)]);
  const std::size_t b = member.first + at(outline[(at(link.link) + 1) % outline.size()]);
  const Vec2 way = ends_[disc] - positions_[disc];
  const Vec2 past_a = way - (ends_[a] - positions_[a]);
  const Vec2 past_b = way - (ends_[b] - positions_[b]);
  const double most = distance + std::sqrt(std::max(dot(past_a, past_a), dot(past_b, past_b)));
  return may_be_within(most, positions_[disc], positions_[a], positions_[b]) &&
         find_separation(positions_[disc], positions_[a], positions_[b]).distance <= most;
}

/// Whether a point of an outline and both ends of a link of it are no more than `close_links` from each other.
bool Island::are_close(const Cord& cord, int k, int link) {
  const int apart = k > link ? k - link : link + 1 - k;
  if (cord.def_.rows == 1) return apart <= close_links;
  const int n = static_cast<int>(cord.outline_.size());
  return std::min(apart, n + 1 - apart) <= close_links;
}

int Island::outline_size(const CordDef& def) { return def.rows == 1 ? def.points : 2 * (def.points + def.rows - 2); }

/// Whether a point and a link of one outline lie so near each other at rest that they could not be kept apart.
bool Island::are_neighbours(const CordDef& def, int k, int link) {
  const double along = def.length / (def.points - 1);
  const double across = def.rows > 1 ? def.width / (def.rows - 1) : 0.0;
  const int n = def.points;
  const int size = outline_size(def);
  const auto at_rest = [&](int i) {
    i = (i + size) % size;
    if (i < n) return Vec2{along * i, 0.0};
    i -= n - 1;
    if (i < def.rows) return Vec2{along * (n - 1), across * i};
    i -= def.rows - 1;
    if (i < n) return Vec2{along * (n - 1 - i), def.width};
    return Vec2{0.0, def.width - across * (i - n + 1)};
  };
  if (def.rows == 1 && (link < 0 || link + 1 >= size)) return false;
  if (k == (link + size) % size || k == (link + 1 + size) % size) return true;
  const Separation gap = find_separation(at_rest(k), at_rest(link), at_rest(link + 1));
  return gap.distance < own_neighbourhood * def.radius;
}

}  // namespace ribbon
