#include "ribbon/collision/outline.h"

#include <algorithm>

#include "ribbon/geometry/separation.h"
#include "ribbon/linear/index.h"

namespace ribbon {
namespace {

constexpr double link_rounding = 1e-9;  // of a link, by which its ends may be off
constexpr double neighbourhood = 3.0;   // radii: parts of a cord that are nearer than that at rest are neighbours

int outline_points(const CordDef& def) { return def.rows == 1 ? def.points : 2 * (def.points + def.rows - 2); }

/// m, where a point of the outline is in the straight cord.
Vec2 rest_position(const CordDef& def, int i) {
  const double along = def.length / (def.points - 1);
  const double across = def.rows > 1 ? def.width / (def.rows - 1) : 0.0;
  const int n = def.points;
  const int size = outline_points(def);
  i = (i + size) % size;
  if (i < n) return {along * i, 0.0};
  i -= n - 1;
  if (i < def.rows) return {along * (n - 1), across * i};
  i -= def.rows - 1;
  if (i < n) return {along * (n - 1 - i), def.width};
  return {0.0, def.width - across * (i - n + 1)};
}

/// Returns whether point k and a link are neighbours, where rest_at(i) is the position of point i, −1 … size + 1.
template <typename RestAt>
bool are_neighbours(const CordDef& def, int size, int k, int link, const RestAt& rest_at) {
  if (def.rows == 1 && (link < 0 || link + 1 >= size)) return false;
  if (is_end_of_link(def, k, link)) return true;
  const double near = neighbourhood * def.radius;
  const Vec2 point = rest_at(k);
  const Vec2 a = rest_at(link);
  const Vec2 b = rest_at(link + 1);
  return may_be_within(near, point, a, b) && find_separation(point, a, b).distance < near;
}

/// m, where a point of the cord, by its index, is in the straight cord.
Vec2 rest_place(const CordDef& def, int point) {
  const double across = def.rows > 1 ? def.width / (def.rows - 1) : 0.0;
  const int column = point / def.rows;
  return {def.length / (def.points - 1) * column, across * (point % def.rows)};
}

}  // namespace

int outline_links(const CordParts& cord) {
  const int points = static_cast<int>(cord.outline.size());
  return cord.def.rows == 1 ? points - 1 : points;
}

std::size_t outline_slot(const Member& member, int k) {
  const int n = static_cast<int>(member.cord->outline.size());
  const int wrapped = k < 0 ? k + n : k >= n ? k - n : k;
  return member.first_point + at(member.cord->outline[at(wrapped)]);
}

ContactPair pair_with_link(const Member& member, int k) {
  const int n = static_cast<int>(member.cord->outline.size());
  const bool closed = member.cord->def.rows > 1;
  const auto anchor = [&](int i) {
    return closed || (i >= 0 && i < n) ? static_cast<int>(outline_slot(member, i)) : -1;
  };
  ContactPair pair;
  pair.a = anchor(k);
  pair.b = anchor(k + 1);
  pair.previous = anchor(k - 1);
  pair.next = anchor(k + 2);
  return pair;
}

ContactPair pair_with_point(const Member& member, int k) {
  ContactPair pair;
  pair.a = static_cast<int>(outline_slot(member, k));
  pair.b = pair.a;
  return pair;
}

bool are_close(const CordParts& cord, int k, int link) {
  const int apart = k > link ? k - link : link + 1 - k;
  if (cord.def.rows == 1) return apart <= close_links;
  const int n = static_cast<int>(cord.outline.size());
  return std::min(apart, n + 1 - apart) <= close_links;
}

bool is_on_wheel(const CordParts& cord, int k, bool is_point) {
  if (cord.on_wheels.empty()) return false;
  if (!is_point) return cord.is_on_wheel(at(k));
  return k > 0 && at(k) < cord.on_wheels.size() && cord.is_on_wheel(at(k) - 1) && cord.is_on_wheel(at(k));
}

bool were_neighbours(const Member& member, int k, const Member& other, int link) {
  const Cord::State& state = member.cord->state;
  const Cord::State& others = other.cord->state;
  const CordDef& def = member.cord->def;
  const CordDef& other_def = other.cord->def;
  const bool after = state.joined_last != 0 && state.joined_last == other.id && others.joined_first == member.id;
  const bool before = state.joined_first != 0 && state.joined_first == other.id && others.joined_last == member.id;
  if (!after && !before) return false;
  const int size = outline_points(other_def);
  if (def.rows == 1 && (link < 0 || link + 1 >= size)) return false;
  const Vec2 shift{after ? def.length : -other_def.length, 0.0};
  const Separation gap = find_separation(rest_position(def, k), rest_position(other_def, link) + shift,
                                         rest_position(other_def, link + 1) + shift);
  return gap.distance < neighbourhood * def.radius;
}

bool are_tied(const IslandState& state, const Member& member, int k, const Member& other, int link) {
  if (!state.ties.any()) return false;
  const int size = outline_points(other.cord->def);
  if (other.cord->def.rows == 1 && (link < 0 || link + 1 >= size)) return false;
  const auto ties_of = [&](const Member& of) {
    const int cord = static_cast<int>(&of - state.members.data());
    return std::equal_range(state.ties.by_cord.begin(), state.ties.by_cord.end(), TiedPoint{0, cord, 0},
                            [](const TiedPoint& a, const TiedPoint& b) { return a.cord < b.cord; });
  };
  const auto [first, end] = ties_of(member);
  for (auto tied = first; tied != end; ++tied) {
    const Vec2 own = rest_position(member.cord->def, k) - rest_place(member.cord->def, tied->point);
    if (length(own) >= neighbourhood * member.cord->def.radius) continue;
    const auto [first_of_other, end_of_other] = ties_of(other);
    for (auto at_other = first_of_other; at_other != end_of_other; ++at_other) {
      if (at_other->group != tied->group) continue;
      const Separation gap =
          find_separation(rest_place(other.cord->def, at_other->point), rest_position(other.cord->def, link),
                          rest_position(other.cord->def, link + 1));
      if (gap.distance < neighbourhood * other.cord->def.radius) return true;
    }
  }
  return false;
}

bool is_end_of_link(const CordDef& def, int k, int link) {
  const int size = outline_points(def);
  const int first = link < 0 ? link + size : link >= size ? link - size : link;
  return k == first || k == (first + 1 < size ? first + 1 : 0);
}

void list_rest_positions(const CordDef& def, std::vector<Vec2>& positions) {
  positions.resize(at(outline_points(def)));
  for (std::size_t k = 0; k < positions.size(); ++k) positions[k] = rest_position(def, static_cast<int>(k));
}

bool are_neighbours(const CordDef& def, int k, int link) {
  return are_neighbours(def, outline_points(def), k, link, [&def](int i) { return rest_position(def, i); });
}

bool are_neighbours(const CordDef& def, std::span<const Vec2> rest, int k, int link) {
  const int size = static_cast<int>(rest.size());
  return are_neighbours(def, size, k, link, [&](int i) {
    return rest[at(i < 0 ? i + size : i >= size ? i - size : i)];
  });
}

bool may_be_neighbours(const CordDef& def, std::span<const Vec2> rest, int k, int link) {
  const double along = def.length / (def.points - 1);
  const double across = def.rows > 1 ? def.width / (def.rows - 1) : 0.0;
  const double near = neighbourhood * def.radius + (1.0 + link_rounding) * std::max(along, across);
  const Vec2 point = rest[at(k)];
  return may_be_within(near, point, rest[at(link)], rest[at(link + 1) % rest.size()]);
}

}  // namespace ribbon
