#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "ribbon/contact/contact_pairs.h"
#include "ribbon/linear/index.h"

namespace ribbon {

/// The pairs that are near enough to touch (Verlet list). Each anchor has a skin: the list holds as long as no anchor
/// is further from where it was listed than its skin.
class CandidateList {
 public:
  /// Forgets the list. The number of checks remains.
  void clear();
  /// Reserves memory for so many pairs and anchors.
  void reserve(std::size_t pairs, std::size_t anchors);
  /// Makes the list valid for straight motion of the anchors between these positions, m. If one leaves its skin,
  /// the new skin is twice the motion, or twice the last displacement (at most the old skin) if that is larger.
  void update(const ContactPairs& pairs, std::span<const Vec2> from, std::span<const Vec2> to);

  /// Indices of the pairs in the list, ascending.
  std::span<const std::size_t> pairs() const { return candidates_; }
  /// The same for a pass that checks each of them; counts the checks.
  std::span<const std::size_t> pairs_to_check();
  /// Returns the number of pairs checked since this function was called last.
  std::int64_t take_checks() { return std::exchange(checks_, 0); }
  /// Anchors that any pair refers to, ascending.
  std::span<const std::size_t> anchors() const { return anchors_; }

 private:
  void start(const ContactPairs& pairs, std::span<const Vec2> positions);
  bool find_left_skins(std::span<const Vec2> from, std::span<const Vec2> to);
  void renew_skins(std::span<const Vec2> from, std::span<const Vec2> to);
  bool is_near(const PairGeometry& pair) const;

  std::vector<std::size_t> candidates_;
  std::vector<char> is_candidate_;  // by pair
  std::vector<std::size_t> anchors_;
  std::vector<Vec2> listed_at_;  // m, by anchor: the centre of its skin
  std::vector<double> skins_;    // m, by anchor
  std::vector<char> left_skin_;  // by anchor: it must be listed again
  double min_skin_ = 0.0;        // m
  std::int64_t checks_ = 0;
};

}  // namespace ribbon
