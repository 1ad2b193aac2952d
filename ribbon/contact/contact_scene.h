#pragma once

#include <span>
#include <vector>

#include "ribbon/contact/candidate_list.h"
#include "ribbon/contact/contact_anchors.h"
#include "ribbon/contact/contact_pairs.h"

namespace ribbon {

/// What may touch in a step: anchors, the pairs of them, and the list of the pairs that are near.
struct ContactScene {
  ContactAnchors anchors;
  ContactPairs pairs;
  CandidateList candidates;

  /// Removes all pairs and body anchors; the cords have so many points.
  void clear(std::size_t points) {
    anchors.clear(points);
    pairs.clear();
    candidates.clear();
  }
  /// Returns the index of the new anchor.
  int add(const BodyAnchor& anchor) { return anchors.add(anchor); }
  void add(const ContactPair& pair) {
    const bool is_disc = anchors.is_point(pair.disc);  // of the cord
    pairs.add(pair, is_disc ? pair.disc_radius : pair.contact_distance - pair.disc_radius);
  }
  /// Starts a substep that ends at this fraction of the step, 0 … 1: so much of initial penetrations is removed.
  void begin_substep(double fraction) {
    pairs.set_depenetration(fraction);
    candidates.reserve(pairs.capacity(), anchors.capacity());
  }
  /// Makes the list of candidates valid for straight motion of the anchors between these positions, m.
  void list_candidates(std::span<const Vec2> from, std::span<const Vec2> to) { candidates.update(pairs, from, to); }
};

}  // namespace ribbon
