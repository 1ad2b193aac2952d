#include "ribbon/contact/contact_pairs.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ribbon {
namespace {

constexpr std::size_t initial_pairs = 64;  // few scenes need more, so few steps allocate
constexpr double min_overlap_fraction = 0.5;
constexpr double max_overlap_fraction = 0.95;

}  // namespace

void ContactPairs::clear() {
  pairs_.clear();
  geometries_.clear();
  pressed_.clear();
}

void ContactPairs::add(const ContactPair& pair, double cord_radius) {
  if (pairs_.empty()) pairs_.reserve(initial_pairs);
  pairs_.push_back(pair);
  geometries_.reserve(pairs_.capacity());
  pressed_.reserve(pairs_.capacity());
  // A stuck friction of −0 too: it ends as 0.
  if (pair.touch.force != 0.0 || pair.touch.stuck != 0.0 || std::signbit(pair.touch.stuck)) {
    pressed_.push_back(pairs_.size() - 1);
  }
  const double overlap =
      std::clamp(1.0 - cord_radius / pair.contact_distance, min_overlap_fraction, max_overlap_fraction);
  geometries_.push_back(
      {pair.disc, pair.a, pair.b, pair.is_mutual, pair.contact_distance, pair.initial_penetration, overlap});
}

double ContactPairs::min_contact_distance() const {
  double least = std::numeric_limits<double>::infinity();
  for (const PairGeometry& pair : geometries_) least = std::min(least, pair.contact_distance);
  return geometries_.empty() ? 0.0 : least;
}

Separation separation_of(const ContactPair& pair, Vec2 o, Vec2 a, Vec2 b) {
  Separation gap = find_separation(o, a, b);
  if (pair.parting != Vec2{} && gap.distance <= ContactPair::coincident_share * pair.contact_distance) {
    gap.normal = pair.parting;
  }
  return gap;
}

bool is_local_minimum(const ContactPair& pair, const Separation& gap, std::span<const Vec2> positions) {
  if (gap.is_interior()) return true;
  const int vertex = gap.along == 0.0 ? pair.a : pair.b;
  if (!pair.owns_ends || (pair.is_mutual && pair.disc > vertex)) return false;
  if (gap.along == 0.0) return pair.previous < 0;
  if (pair.next < 0) return true;
  const auto at = [positions](int anchor) { return positions[static_cast<std::size_t>(anchor)]; };
  const Vec2 b = at(pair.b);
  return dot(at(pair.disc) - b, at(pair.next) - b) <= 0.0;
}

}  // namespace ribbon
