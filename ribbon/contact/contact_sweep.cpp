#include "ribbon/contact/contact_sweep.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ribbon/linear/reserve_more.h"

namespace ribbon {
namespace {

constexpr double distance_tolerance = 1e-3;  // of the contact distance, to which an advancement ends
constexpr int max_advances = 32;
constexpr double separated_of_start = 0.995;  // of the distance at the start, what separate_groups leaves
constexpr int max_reductions = 12;            // of the fraction of a group, before it has to stop

/// An upper bound of the length of v that takes no root.
double sum_of_sizes(Vec2 v) { return std::abs(v.x) + std::abs(v.y); }

}  // namespace

void ContactSweep::reserve(std::size_t anchors, std::size_t slots) {
  reserve_more(ends_, anchors);
  reserve_more(group_limits_, slots);
}

void ContactSweep::set_path(ContactScene& scene, std::span<const Vec2> from, std::span<const Vec2> to) {
  scene.anchors.positions(from, KinematicTime::start, from_);
  scene.anchors.positions(to, KinematicTime::current, to_);
  scene.list_candidates(from_, to_);
}

/// With n the normal now, the distance of the disc o and any point p of the segment is
///
///     |o − p| ≥ n·(o − p).
///
/// The right side is linear in time and in p. So the larger approach speed along n of the two ends bounds the approach
/// on the whole path. A pair that separates is free, at any depth, and so is one of cords that coincides: it has no
/// sides to change.
double ContactSweep::free_fraction(const PairGeometry& pair, Clearance clearance, double max) const {
  const auto displacement = [this](int anchor) { return to_[at(anchor)] - from_[at(anchor)]; };
  const Vec2 disc = displacement(pair.disc);
  const Vec2 past_a = disc - displacement(pair.a);
  const Vec2 past_b = disc - displacement(pair.b);
  const double distance = clearance.fraction * pair.contact_distance;
  const auto may_touch = [&](double approach) {
    return may_be_within(distance + max * approach, from_[at(pair.disc)], from_[at(pair.a)], from_[at(pair.b)]);
  };
  // Most pairs are apart by so much that an upper bound of the speed, which takes no root, shows it.
  if (!may_touch(std::max(sum_of_sizes(past_a), sum_of_sizes(past_b)))) return max;
  const double speed = std::sqrt(std::max(dot(past_a, past_a), dot(past_b, past_b)));
  if (speed == 0.0 || !may_touch(speed)) return max;
  const auto gap = [&](double fraction) {
    const auto there = [&](int anchor) { return from_[at(anchor)] + fraction * displacement(anchor); };
    return find_separation(there(pair.disc), there(pair.a), there(pair.b));
  };
  Separation now = gap(0.0);
  if (pair.is_mutual && now.distance <= ContactPair::coincident_share * pair.contact_distance) return max;
  double fraction = 0.0;
  const double nearest = std::min(distance, clearance.of_start * now.distance);
  for (int k = 0; k < max_advances; ++k) {
    if (now.distance - nearest <= distance_tolerance * pair.contact_distance && k > 0) break;
    const double approach = -std::min(dot(now.normal, past_a), dot(now.normal, past_b));
    if (!(now.distance - nearest < approach * (max - fraction))) return max;
    fraction += (now.distance - nearest) / approach;
    now = gap(fraction);
  }
  return fraction;
}

Separation ContactSweep::gap_at(const ContactPair& pair, double fraction, std::span<Vec2> positions) const {
  for (const int anchor : {pair.disc, pair.a, pair.b, pair.previous, pair.next}) {
    if (anchor < 0) continue;
    positions[at(anchor)] = from_[at(anchor)] + fraction * (to_[at(anchor)] - from_[at(anchor)]);
  }
  return separation_of(pair, positions[at(pair.disc)], positions[at(pair.a)], positions[at(pair.b)]);
}

bool ContactSweep::may_end_within(const PairGeometry& pair, double distance) const {
  const auto end = [this](int anchor) { return from_[at(anchor)] + 1.0 * (to_[at(anchor)] - from_[at(anchor)]); };
  return may_be_within(distance, end(pair.disc), end(pair.a), end(pair.b));
}

double ContactSweep::collision_free_fraction(ContactScene& scene, std::span<const Vec2> x, std::span<const Vec2> to,
                                             KinematicTime kinematic_end) {
  scene.anchors.positions(x, KinematicTime::current, from_);
  scene.anchors.positions(to, kinematic_end, to_);
  scene.list_candidates(from_, to_);
  double fraction = 1.0;
  for (const std::size_t k : scene.candidates.pairs_to_check()) {
    fraction = free_fraction(scene.pairs.geometry(k), Clearance::collision_free(), fraction);
  }
  return fraction;
}

bool ContactSweep::path_is_clear(ContactScene& scene, std::span<const Vec2> from, std::span<const Vec2> x) {
  set_path(scene, from, x);
  const std::span<const std::size_t> candidates = scene.candidates.pairs_to_check();
  return std::all_of(candidates.begin(), candidates.end(), [&](std::size_t k) {
    return free_fraction(scene.pairs.geometry(k), Clearance::passing(), 1.0) == 1.0;
  });
}

double ContactSweep::fraction_to_impact(ContactScene& scene, std::span<const Vec2> x, std::span<const Vec2> to,
                                        ImpactsOf what) {
  scene.anchors.positions(x, KinematicTime::current, from_);
  scene.anchors.positions(to, KinematicTime::target, to_);
  scene.list_candidates(from_, to_);
  const auto is_moving_body = [&](int anchor) {
    return scene.anchors.is_dynamic(anchor) ||
           (scene.anchors.is_kinematic(anchor) && from_[at(anchor)] != to_[at(anchor)]);
  };
  double fraction = 1.0;
  for (const std::size_t k : scene.candidates.pairs_to_check()) {
    const PairGeometry& pair = scene.pairs.geometry(k);
    if (what == ImpactsOf::moving_bodies && !is_moving_body(pair.disc) && !is_moving_body(pair.a)) continue;
    if (free_fraction(pair, {pair.overlap_fraction, Clearance::of_start_in_a_move}, fraction) < fraction) {
      fraction = free_fraction(pair, {1.0, 1.0}, fraction);
    }
  }
  return fraction;
}

bool ContactSweep::separate_groups(ContactScene& scene, std::span<const Vec2> from, std::span<const Vec2> to,
                                   std::span<const int> group_of, std::span<double> fractions) {
  set_path(scene, from, to);
  ends_.assign(to_.begin(), to_.end());
  move_groups(scene, group_of, fractions);
  for (int k = 0;; ++k) {
    group_limits_.assign(fractions.size(), 1.0);
    if (limit_groups(scene, group_of, k + 1 >= max_reductions)) return k == 0;
    bool changed = false;
    for (std::size_t g = 0; g < fractions.size(); ++g) {
      changed = changed || (group_limits_[g] < 1.0 && fractions[g] > 0.0);
      fractions[g] *= group_limits_[g];
    }
    if (!changed) return false;  // what moves into them is kinematic
    move_groups(scene, group_of, fractions);
  }
}

/// Sets to_ to where the fractions of the groups lead.
void ContactSweep::move_groups(const ContactScene& scene, std::span<const int> group_of,
                               std::span<const double> fractions) {
  for (const std::size_t i : scene.candidates.anchors()) {
    const int g = scene.anchors.group(static_cast<int>(i), group_of);
    if (g >= 0) to_[i] = from_[i] + fractions[at(g)] * (ends_[i] - from_[i]);
  }
}

/// Limits the groups of each pair that overlaps on the path: to what is free of it, or, if this is the last try, to
/// nothing. Returns whether no pair does.
bool ContactSweep::limit_groups(ContactScene& scene, std::span<const int> group_of, bool is_last) {
  bool are_separate = true;
  for (const std::size_t k : scene.candidates.pairs_to_check()) {
    const PairGeometry& pair = scene.pairs.geometry(k);
    const std::array<int, 3> groups = {scene.anchors.group(pair.disc, group_of), scene.anchors.group(pair.a, group_of),
                                       scene.anchors.group(pair.b, group_of)};
    // Where all of its groups are limited already, a pair only counts if it limits them further.
    double limit = 0.0;
    for (const int g : groups) limit = std::max(limit, g >= 0 ? group_limits_[at(g)] : 0.0);
    if (limit == 0.0) limit = 1.0;
    const double free = free_fraction(pair, {pair.overlap_fraction, separated_of_start}, limit);
    if (free == limit) continue;
    are_separate = false;
    for (const int g : groups) {
      if (g >= 0) group_limits_[at(g)] = std::min(group_limits_[at(g)], is_last ? 0.0 : free);
    }
  }
  return are_separate;
}

}  // namespace ribbon
