#include "ribbon/contact/candidate_list.h"

#include <algorithm>

namespace ribbon {
namespace {

constexpr double listing_margin = 0.25;    // of the contact distance, within which a pair is listed in any case
constexpr double min_skin_fraction = 0.1;  // of the least contact distance

}  // namespace

void CandidateList::clear() {
  listed_at_.clear();
  min_skin_ = 0.0;
}

void CandidateList::reserve(std::size_t pairs, std::size_t anchors) {
  is_candidate_.reserve(pairs);
  candidates_.reserve(pairs);
  anchors_.reserve(anchors);
  listed_at_.reserve(anchors);
  skins_.reserve(anchors);
  left_skin_.reserve(anchors);
}

void CandidateList::update(const ContactPairs& pairs, std::span<const Vec2> from, std::span<const Vec2> to) {
  if (listed_at_.size() != from.size()) {
    start(pairs, from);
  } else if (!find_left_skins(from, to)) {
    return;
  }
  renew_skins(from, to);
  candidates_.clear();
  checks_ += static_cast<std::int64_t>(pairs.size());
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const PairGeometry& pair = pairs.geometry(k);
    if (left_skin_[at(pair.disc)] != 0 || left_skin_[at(pair.a)] != 0 || left_skin_[at(pair.b)] != 0) {
      is_candidate_[k] = is_near(pair);
    }
    if (is_candidate_[k] != 0) candidates_.push_back(k);
  }
}

std::span<const std::size_t> CandidateList::pairs_to_check() {
  checks_ += static_cast<std::int64_t>(candidates_.size());
  return candidates_;
}

void CandidateList::start(const ContactPairs& pairs, std::span<const Vec2> positions) {
  listed_at_.assign(positions.begin(), positions.end());
  skins_.assign(positions.size(), 0.0);
  is_candidate_.resize(pairs.size());
  min_skin_ = min_skin_fraction * pairs.min_contact_distance();
  left_skin_.assign(positions.size(), 0);
  for (const PairGeometry& pair : pairs.geometries()) {
    left_skin_[at(pair.disc)] = left_skin_[at(pair.a)] = left_skin_[at(pair.b)] = 1;
  }
  anchors_.clear();
  for (std::size_t i = 0; i < left_skin_.size(); ++i) {
    if (left_skin_[i] != 0) anchors_.push_back(i);
  }
}

/// Marks the anchors that leave their skins. Returns whether there are any.
bool CandidateList::find_left_skins(std::span<const Vec2> from, std::span<const Vec2> to) {
  char any = 0;
  const bool moves = from.data() != to.data();
  for (const std::size_t i : anchors_) {
    const Vec2 start = from[i] - listed_at_[i];
    const Vec2 end = moves ? to[i] - listed_at_[i] : start;
    const double skin2 = skins_[i] * skins_[i];
    left_skin_[i] = dot(start, start) <= skin2 && dot(end, end) <= skin2 ? 0 : 1;
    any = static_cast<char>(any | left_skin_[i]);
  }
  return any != 0;
}

/// Lists the anchors that left their skins where they are now.
void CandidateList::renew_skins(std::span<const Vec2> from, std::span<const Vec2> to) {
  for (const std::size_t i : anchors_) {
    if (left_skin_[i] == 0) continue;
    const double last = std::min(length(from[i] - listed_at_[i]), skins_[i]);
    skins_[i] = std::max(min_skin_, 2.0 * std::max(length(to[i] - from[i]), last));
    listed_at_[i] = from[i];
  }
}

/// Whether the pair may touch while its anchors stay within their skins.
bool CandidateList::is_near(const PairGeometry& pair) const {
  const Vec2 disc = listed_at_[at(pair.disc)];
  const Vec2 a = listed_at_[at(pair.a)];
  const Vec2 b = listed_at_[at(pair.b)];
  const double skin = skins_[at(pair.disc)] + std::max(skins_[at(pair.a)], skins_[at(pair.b)]);
  const double distance = (1.0 + listing_margin) * pair.contact_distance + skin;
  return may_be_within(distance, disc, a, b) && find_separation(disc, a, b).distance <= distance;
}

}  // namespace ribbon
