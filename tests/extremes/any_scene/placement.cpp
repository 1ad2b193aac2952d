#include "tests/extremes/any_scene/placement.h"

#include <algorithm>
#include <cmath>

#include "tests/extremes/any_scene/edit.h"
#include "tests/extremes/any_scene/oracles.h"
#include "tests/support/slot.h"

namespace any_scene {

using ribbon::CordDef;
using ribbon::Vec2;

namespace {

constexpr double clearance = 1e-3;       // m
constexpr double holder_overlap = 1e-6;  // m, allowed overlap of a holder and its cord
constexpr int tries = 100;

using test_support::slot;

/// Rotates by the angle 2·atan(t).
Vec2 turned(Vec2 d, double t) {
  const double cos = (1.0 - t * t) / (1.0 + t * t);
  const double sin = 2.0 * t / (1.0 + t * t);
  return {cos * d.x - sin * d.y, sin * d.x + cos * d.y};
}

Vec2 unit(Vec2 d) { return (1.0 / length(d)) * d; }

/// Returns columns with links of the rest length: straight, on an arc or in a zigzag.
std::vector<Vec2> line(Dice& dice, const CordDef& def, Vec2 start) {
  const double link = def.length / (def.points - 1);
  Vec2 d = direction(dice);
  const int kind = random_integer(dice, 0, def.rows > 1 ? 1 : 2);
  const double most_turn = def.rows > 1 ? 0.5 * link / (link + def.width) / (def.points - 1) : 2.2 / (def.points - 1);
  const double turn = kind == 1 ? dice(-1.0, 1.0) * most_turn : 0.0;
  const double corner = kind == 2 ? dice(0.1, 0.5) : 0.0;
  const int leg = random_integer(dice, 2, 8);
  std::vector<Vec2> points{start};
  for (int i = 1; i < def.points; ++i) {
    points.push_back(points.back() + link * d);
    d = unit(turned(d, turn));
    if (kind == 2 && i % leg == 0) d = unit(turned(d, (i / leg) % 2 == 0 ? corner : -corner));
  }
  return points;
}

/// Returns the rows of a ribbon around its middle line.
std::vector<Vec2> rows_of(const CordDef& def, const std::vector<Vec2>& middle) {
  std::vector<Vec2> positions;
  for (int i = 0; i < def.points; ++i) {
    const Vec2 along = middle[slot(std::min(i + 1, def.points - 1))] - middle[slot(std::max(i - 1, 0))];
    const Vec2 across = perp(unit(along));
    for (int j = 0; j < def.rows; ++j) {
      const double share = def.rows > 1 ? 1.0 * j / (def.rows - 1) - 0.5 : 0.0;
      positions.push_back(middle[slot(i)] + (share * def.width) * across);
    }
  }
  return positions;
}

bool is_clear_of_itself(const CordDef& def, const Outline& around) {
  const std::vector<char> near = neighbours(def);
  for (int i = 0; i < around.links(); ++i) {
    for (int j = i + 2; j < around.links(); ++j) {
      if (near[slot(i * around.links() + j)] != 0) continue;
      const double apart = distance(around.start(i), around.end(i), around.start(j), around.end(j));
      if (apart < 2.0 * def.radius + clearance) return false;
    }
  }
  return true;
}

bool are_clear(const CordDef& a, const Outline& around_a, const CordDef& b, const Outline& around_b) {
  for (int i = 0; i < around_a.links(); ++i) {
    for (int j = 0; j < around_b.links(); ++j) {
      const double apart = distance(around_a.start(i), around_a.end(i), around_b.start(j), around_b.end(j));
      if (apart < a.radius + b.radius + clearance) return false;
    }
  }
  return true;
}

/// Returns the support function: the distance from a solid's origin to its surface in the direction n, m.
double support(const Solid& solid, Vec2 n) {
  const Pose pose{{}, std::cos(solid.angle), std::sin(solid.angle)};
  const Vec2 local = pose.to_local(n);
  if (solid.shape == Shape::circle) return solid.half.x;
  return std::abs(local.x) * solid.half.x + std::abs(local.y) * solid.half.y;
}

}  // namespace

int random_integer(Dice& dice, int low, int high) {
  return std::min(low + static_cast<int>(dice() * (high - low + 1)), high);
}

bool chance(Dice& dice, double share) { return dice() < share; }

double log_uniform(Dice& dice, double low, double high) {
  int octaves = 0;
  for (double x = low; 2.0 * x <= high; x *= 2.0) ++octaves;
  double value = low;
  for (int k = random_integer(dice, 0, octaves); k > 0; --k) value *= 2.0;
  return std::min(value * dice(1.0, 2.0), high);
}

Vec2 direction(Dice& dice) {
  for (;;) {
    const double x = dice(-1.0, 1.0);
    const double y = dice(-1.0, 1.0);
    const double size2 = x * x + y * y;
    if (size2 <= 1.0 && size2 > 0.01) return unit({x, y});
  }
}

bool Placer::is_clear(const Solid& solid, int except) const {
  for (int k = 0; k < static_cast<int>(scene_.solids.size()); ++k) {
    if (k != except && overlap(solid, scene_.solids[slot(k)]) > -clearance) return false;
  }
  return std::none_of(scene_.cords.begin(), scene_.cords.end(), [&](const SceneCord& cord) {
    return overlap(cord.def, outline(cord.def, cord.def.positions), solid) > -clearance;
  });
}

bool Placer::is_clear(const CordDef& def, const std::vector<Vec2>& positions) const {
  const Outline around = outline(def, positions);
  if (!is_clear_of_itself(def, around)) return false;
  for (const Solid& solid : scene_.solids) {
    if (overlap(def, around, solid) > -clearance) return false;
  }
  return std::all_of(scene_.cords.begin(), scene_.cords.end(), [&](const SceneCord& other) {
    return are_clear(def, around, other.def, outline(other.def, other.def.positions));
  });
}

bool Placer::add_solid(Dice& dice, Solid solid, Vec2 low, Vec2 high) {
  for (int k = 0; k < tries; ++k) {
    solid.position.x = dice(low.x, high.x);
    solid.position.y = dice(low.y, high.y);
    if (!is_clear(solid)) continue;
    scene_.solids.push_back(solid);
    return true;
  }
  return false;
}

bool Placer::add_cord(Dice& dice, CordDef def, Vec2 low, Vec2 high) {
  for (int k = 0; k < tries; ++k) {
    const double x = dice(low.x, high.x);
    const double y = dice(low.y, high.y);
    def.positions = rows_of(def, line(dice, def, {x, y}));
    if (!is_clear(def, def.positions)) continue;
    scene_.cords.push_back({def, {}});
    return true;
  }
  return false;
}

bool Placer::place_holder(Dice& dice, int solid, int cord, double arc, Hold& hold) {
  const CordDef& def = scene_.cords[slot(cord)].def;
  const bool left = dice.coin();
  hold.solid = solid;
  hold.cord = cord;
  hold.arc = arc;
  hold.row = left ? def.rows - 1 : 0;
  const Vec2 hand = place_of(scene_, hold);
  const int column = std::min(static_cast<int>(arc / def.length * (def.points - 1)), def.points - 2);
  const Vec2 a = def.positions[slot(column * def.rows + hold.row)];
  const Vec2 b = def.positions[slot((column + 1) * def.rows + hold.row)];
  const Vec2 n = (left ? 1.0 : -1.0) * perp(unit(b - a));
  Solid moved = scene_.solids[slot(solid)];
  moved.position = hand + (support(moved, n) + skin(moved) + def.radius) * n;
  return hold_at(solid, moved, hand, hold);
}

bool Placer::add_load(Solid solid, int cord, bool last) {
  const CordDef& def = scene_.cords[slot(cord)].def;
  const Vec2 hand = last ? def.positions.back() : def.positions.front();
  const Vec2 n = unit(hand - (last ? def.positions[def.positions.size() - 2] : def.positions[1]));
  solid.position = hand + (support(solid, n) + skin(solid) + def.radius) * n;
  Hold hold;
  hold.solid = static_cast<int>(scene_.solids.size());
  hold.cord = cord;
  hold.arc = last ? def.length : 0.0;
  scene_.solids.push_back(solid);
  if (!hold_at(hold.solid, solid, hand, hold)) return false;
  scene_.holds.push_back(hold);
  return true;
}

/// Moves a solid to where it is to hold a cord, unless it would overlap something.
bool Placer::hold_at(int solid, const Solid& moved, Vec2 hand, Hold& hold) {
  const CordDef& def = scene_.cords[slot(hold.cord)].def;
  Scene others = scene_;
  others.cords.erase(others.cords.begin() + hold.cord);
  if (!Placer(others).is_clear(moved, solid)) return false;
  if (overlap(def, outline(def, def.positions), moved) > holder_overlap) return false;
  scene_.solids[slot(solid)] = moved;
  hold.local_anchor = pose_of(moved).to_local(hand);
  return true;
}

}  // namespace any_scene
