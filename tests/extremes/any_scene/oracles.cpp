#include "tests/extremes/any_scene/oracles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "tests/support/slot.h"

namespace any_scene {

using ribbon::Vec2;

namespace {

constexpr int same_crossing = 4;           // links by which a crossing may slide in a tick and still count as the same
constexpr double coincident_share = 1e-6;  // of the contact distance: links that are nearer have no sides

using test_support::slot;

struct Pair {
  int i;
  int j;
};

int apart(int i, int j, const Outline& line) {
  const int d = std::abs(i - j);
  return line.closed ? std::min(d, line.links() - d) : d;
}

/// Returns the pairs of links that cross. If both outlines are one line, each pair counts once.
std::vector<Pair> crossing_pairs(const Outline& a, const Outline& b, bool itself) {
  std::vector<Pair> found;
  for (int i = 0; i < a.links(); ++i) {
    if (a.is_on_wheel(i)) continue;
    for (int j = itself ? i + 2 : 0; j < b.links(); ++j) {
      if (!b.is_on_wheel(j) && crosses(a.start(i), a.end(i), b.start(j), b.end(j))) found.push_back({i, j});
    }
  }
  return found;
}

Swept swept(const Outline& before, const Outline& after, int point) {
  const std::size_t k = slot(point) % before.points.size();
  return {before.points[k], after.points[k]};
}

/// Returns whether the place s of a link is within `margin` of a free end. A passage around a free end is no crossing.
bool is_at_end(const Outline& line, int link, double s, double margin) {
  if (line.closed) return false;
  const double size = length(line.end(link) - line.start(link));
  return (link == 0 && s * size < margin) || (link == line.links() - 1 && (1.0 - s) * size < margin);
}

/// Returns whether a point passes through a link of a line, away from its ends.
template <typename Skip>
bool passes_line(Swept p, const Outline& before, const Outline& after, double margin, Skip&& skip) {
  for (int j = 0; j < before.links(); ++j) {
    if (before.is_on_wheel(j)) continue;
    const auto where = passes(p, swept(before, after, j), swept(before, after, j + 1));
    if (where && !is_at_end(after, j, *where, margin) && !skip(j)) return true;
  }
  return false;
}

Outline in_frame(const Outline& line, const Pose& pose) {
  Outline local = line;
  for (Vec2& p : local.points) p = pose.to_local(p);
  return local;
}

}  // namespace

Oracles::Oracles(const Scene& scene) : scene_(scene) {
  for (const SceneCord& cord : scene.cords) {
    near_.push_back(neighbours(cord.def));
    links_.push_back(outline_at_rest(cord.def).links());
    joined_.emplace_back();
    if (cord.cut_from >= 0) joined_.back() = neighbours(scene.cords[slot(cord.cut_from)].def, cord.def);
  }
}

bool Oracles::meet(int a, int b) const {
  const SceneCord& first = scene_.cords[slot(a)];
  const SceneCord& second = scene_.cords[slot(b)];
  if (a == b) return first.def.self_contact;
  if (first.family >= 0 && first.family == second.family) {
    return first.def.self_contact && !first.split && !second.split;
  }
  return first.def.cord_contact && second.def.cord_contact;
}

std::vector<CrossedPair> Oracles::crossings(const Snapshot& before, const Snapshot& after) const {
  const auto has_wheel = [](const Outline& line) { return !line.on_wheel.empty(); };
  const bool any = std::any_of(before.cords.begin(), before.cords.end(), has_wheel) ||
                   std::any_of(after.cords.begin(), after.cords.end(), has_wheel);
  if (!any) return crossings_off_wheels(before, after);
  Snapshot first = before;
  Snapshot second = after;
  for (std::size_t c = 0; c < first.cords.size(); ++c) {
    std::vector<char>& on = first.cords[c].on_wheel;
    on.resize(slot(first.cords[c].links()));
    for (int link = 0; link < first.cords[c].links(); ++link) {
      on[slot(link)] = before.cords[c].is_on_wheel(link) || after.cords[c].is_on_wheel(link) ? 1 : 0;
    }
    second.cords[c].on_wheel = on;
  }
  return crossings_off_wheels(first, second);
}

std::vector<CrossedPair> Oracles::crossings_off_wheels(const Snapshot& before, const Snapshot& after) const {
  std::vector<CrossedPair> found;
  const int cords = static_cast<int>(scene_.cords.size());
  for (int a = 0; a < cords; ++a) {
    for (int b = a; b < cords; ++b) {
      if (meet(a, b) && cords_crossed(a, b, before, after)) found.push_back({a, b, false});
    }
    for (int s = 0; s < static_cast<int>(scene_.solids.size()); ++s) {
      if (is_held_by(a, s)) continue;
      const bool is_edge = scene_.solids[slot(s)].shape == Shape::edge;
      const bool crossed = is_edge ? edge_crossed(a, s, before, after) : solid_crossed(a, s, before, after);
      const bool pressed = before.pressed[slot(s)] != 0 || after.pressed[slot(s)] != 0;
      if (crossed) found.push_back({a, s, true, pressed});
    }
  }
  return found;
}

/// Returns whether a solid holds a cord or another piece of the same one, or carries a wheel of it.
bool Oracles::is_held_by(int cord, int solid) const {
  const int family = scene_.cords[slot(cord)].family;
  for (int other = 0; other < static_cast<int>(scene_.cords.size()); ++other) {
    const bool same = other == cord || (family >= 0 && family == scene_.cords[slot(other)].family);
    if (same && (holds(scene_, solid, other) || carries(scene_, solid, other))) return true;
  }
  return false;
}

/// Returns whether two links were near each other in the cord from which both were cut.
bool Oracles::were_close(int a, int i, int b, int j) const {
  if (scene_.cords[slot(a)].cut_from == b) return were_close(b, j, a, i);
  if (scene_.cords[slot(b)].cut_from != a) return false;
  return joined_[slot(b)][slot(i * links_[slot(b)] + j)] != 0;
}

/// Returns whether two links are near a place where cords are tied.
bool Oracles::are_tied(int a, int i, int b, int j, const Snapshot& now) const {
  const double reach = 3.0 * std::max(scene_.cords[slot(a)].def.radius, scene_.cords[slot(b)].def.radius);
  const auto is_near = [reach](const Outline& line, int link, Vec2 place) {
    return distance(place, line.start(link), line.end(link)) <= reach;
  };
  return std::any_of(now.ties.begin(), now.ties.end(), [&](Vec2 place) {
    return is_near(now.cords[slot(a)], i, place) && is_near(now.cords[slot(b)], j, place);
  });
}

/// A crossing is new if the number of crossings grew and no crossing was near it before.
bool Oracles::cords_crossed(int a, int b, const Snapshot& before, const Snapshot& after) const {
  const Outline& a0 = before.cords[slot(a)];
  const Outline& b0 = before.cords[slot(b)];
  const Outline& a1 = after.cords[slot(a)];
  const Outline& b1 = after.cords[slot(b)];
  const int links = b1.links();
  const double margin = scene_.cords[slot(a)].def.radius + scene_.cords[slot(b)].def.radius;
  const auto close = [&](int i, int j) {
    if (a == b) return near_[slot(a)][slot(i * links + j)] != 0;
    if (were_close(a, i, b, j) || are_tied(a, i, b, j, after)) return true;
    const double gap = distance(a0.start(i), a0.end(i), b0.start(j), b0.end(j));  // 0 where a tie was untied
    return gap <= coincident_share * margin;
  };
  const std::vector<Pair> was = crossing_pairs(a0, b0, a == b);
  const std::vector<Pair> is = crossing_pairs(a1, b1, a == b);
  if (is.size() > was.size()) {
    for (const Pair& now : is) {
      const bool same = std::any_of(was.begin(), was.end(), [&](const Pair& then) {
        return apart(now.i, then.i, a1) <= same_crossing && apart(now.j, then.j, b1) <= same_crossing;
      });
      if (!same && !close(now.i, now.j)) return true;
    }
  }
  if (!was.empty()) return false;
  const auto passes_other = [&](const Outline& p0, const Outline& p1, const Outline& q0, const Outline& q1,
                                const auto& is_close) {
    for (int k = 0; k < static_cast<int>(p0.points.size()); ++k) {
      if (p0.is_at_wheel(k)) continue;
      const auto skip = [&](int j) {
        const int n = static_cast<int>(p0.points.size());
        const int last = p0.closed ? k : std::min(k, n - 2);
        const int first = p0.closed ? (k + n - 1) % n : std::max(k - 1, 0);
        return is_close(first, j) || is_close(last, j);
      };
      if (passes_line(swept(p0, p1, k), q0, q1, margin, skip)) return true;
    }
    return false;
  };
  const auto close_to_a = [&](int i, int j) { return close(j, i); };
  return passes_other(a0, a1, b0, b1, close) || (a != b && passes_other(b0, b1, a0, a1, close_to_a));
}

/// Returns the depth of the deepest link, m.
double Oracles::depth_of(int cord, int solid, const Snapshot& now) const {
  const Outline& line = now.cords[slot(cord)];
  double deepest = -std::numeric_limits<double>::infinity();
  for (int k = 0; k < line.links(); ++k) {
    if (line.is_on_wheel(k)) continue;
    deepest = std::max(deepest, depth(scene_.solids[slot(solid)], now.solids[slot(solid)], line.start(k), line.end(k)));
  }
  return deepest;
}

bool Oracles::solid_crossed(int cord, int solid, const Snapshot& before, const Snapshot& after) const {
  const Solid& what = scene_.solids[slot(solid)];
  const double radius = scene_.cords[slot(cord)].def.radius;
  const double least = std::min(what.half.x, what.half.y);
  const double deep = what.shape == Shape::circle ? what.half.x - 0.5 * (what.half.x + radius)
                                                  : std::min(radius + 0.2 * least, 0.9 * least);
  const bool was_in = depth_of(cord, solid, before) > deep;
  if (was_in) return false;
  if (depth_of(cord, solid, after) > deep) return true;
  const Swept center{before.solids[slot(solid)].position, after.solids[slot(solid)].position};
  return passes_line(center, before.cords[slot(cord)], after.cords[slot(cord)], radius, [](int) { return false; });
}

/// Works in the edge's own frame.
bool Oracles::edge_crossed(int cord, int solid, const Snapshot& before, const Snapshot& after) const {
  const double half = scene_.solids[slot(solid)].half.x;
  const Outline edge{{{-half, 0.0}, {half, 0.0}}};
  const Outline line0 = in_frame(before.cords[slot(cord)], before.solids[slot(solid)]);
  const Outline line1 = in_frame(after.cords[slot(cord)], after.solids[slot(solid)]);
  const std::size_t was = crossing_pairs(line0, edge, false).size();
  if (crossing_pairs(line1, edge, false).size() > was) return true;
  if (was > 0) return false;
  const double margin = scene_.cords[slot(cord)].def.radius;
  for (int k = 0; k < static_cast<int>(line0.points.size()); ++k) {
    if (!line0.is_at_wheel(k) && passes_line(swept(line0, line1, k), edge, edge, margin, [](int) { return false; }))
      return true;
  }
  return false;
}

/// Returns the distance between the lines of two cords, or of one with itself, m; `within` if it is greater.
double Oracles::nearest(int a, int b, const Snapshot& now, double within) const {
  const Outline& first = now.cords[slot(a)];
  const Outline& second = now.cords[slot(b)];
  double least = within;
  for (int i = 0; i < first.links(); ++i) {
    if (first.is_on_wheel(i)) continue;
    const Vec2 middle = 0.5 * (first.start(i) + first.end(i));
    const double size = 0.5 * length(first.end(i) - first.start(i));
    for (int j = a == b ? i + 2 : 0; j < second.links(); ++j) {
      const double far = size + 0.5 * length(second.end(j) - second.start(j)) + least;
      if (second.is_on_wheel(j)) continue;
      if (length(0.5 * (second.start(j) + second.end(j)) - middle) > far) continue;
      if (a == b ? near_[slot(a)][slot(i * second.links() + j)] != 0 : were_close(a, i, b, j)) continue;
      least = std::min(least, distance(first.start(i), first.end(i), second.start(j), second.end(j)));
    }
  }
  return least;
}

Depth Oracles::penetration(const Snapshot& now) const {
  Depth deepest;
  const auto take = [&](double share, const CrossedPair& where) {
    if (share > deepest.share) deepest = {share, where};
  };
  const int cords = static_cast<int>(scene_.cords.size());
  for (int a = 0; a < cords; ++a) {
    const double radius = scene_.cords[slot(a)].def.radius;
    for (int b = a; b < cords; ++b) {
      const double contact_distance = radius + scene_.cords[slot(b)].def.radius;
      if (!meet(a, b) || contact_distance == 0.0) continue;
      take(1.0 - nearest(a, b, now, contact_distance) / contact_distance, {a, b, false});
    }
    for (int s = 0; s < static_cast<int>(scene_.solids.size()); ++s) {
      const double contact_distance = radius + skin(scene_.solids[slot(s)]);
      if (is_held_by(a, s) || contact_distance == 0.0) continue;
      take(1.0 + depth_of(a, s, now) / contact_distance, {a, s, true});
    }
  }
  return deepest;
}

}  // namespace any_scene
