// Contacts as a problem that is posed once and then kept.

#include <algorithm>
#include <limits>

#include "ribbon/contact/contacts.h"

namespace ribbon {
namespace {

constexpr double friction_share = 0.1;   // of a contact's stiffness, that friction's anchor has
constexpr double posed_share = 0.25;     // of the reach, beyond it, within which a pair is posed
constexpr double nearest_share = 0.9;    // of the reach: who comes so near on the way touches there
constexpr double passing_share = 0.5;    // of it: who comes so near has gone through
constexpr double approach_share = 0.98;  // of the distance, if that is less already: so much nearer it may be
constexpr double kept_share = 0.995;     // the same in the end
constexpr int most_cuts = 12;            // of a group's share

}  // namespace

bool Contacts::pose(std::span<const Vec2> from, std::span<const Vec2> to) {
  go_between(from, to);
  posed_before_.swap(posed_);
  posed_.clear();
  posed_.reserve(pairs_.capacity());
  count_visits(near_.size());
  for (const std::size_t k : near_) pose_pair(k);
  keep_pressing();
  return !std::equal(posed_.begin(), posed_.end(), posed_before_.begin(), posed_before_.end(),
                     [](const Posed& a, const Posed& b) { return a.pair == b.pair; });
}

bool Contacts::pose_missed(std::span<const Vec2> from, std::span<const Vec2> to, double tolerance) {
  go_between(from, to);
  posed_before_.swap(posed_);
  posed_.clear();
  count_visits(near_.size());
  for (const std::size_t k : near_) {
    const Corner& corner = corners_[k];
    const ContactPair& pair = pairs_[k];
    if (free_share(corner, corner.passing, 1.0, kept_share) < 1.0) {
      posed_.push_back({k, gap_at(pair, free_share(corner, nearest_share, 1.0, approach_share))});
      continue;
    }
    const Separation gap = gap_at(pair, 1.0);
    const double pressed = forces_[k] / (posed_stiffness_ * pair.stiffness);
    const bool deep = reach_now(pair.reach, pair.in) - gap.distance > pressed + tolerance;
    if (deep && is_minimum(pair, gap)) posed_.push_back({k, gap});
  }
  const bool any = !posed_.empty();
  keep_before([](const Posed&) { return true; });
  return any;
}

/// Where everything is when the stage begins, and where `to` takes it, to find what is near on that way.
void Contacts::go_between(std::span<const Vec2> from, std::span<const Vec2> to) {
  place(from, false, from_);
  place(to, false, to_);
  for (std::size_t k = 0; k < spots_.size(); ++k) {
    if (spots_[k].center < 0) from_[points_ + k] = spots_[k].begun;
  }
  watch(from_, to_);
  evaluated_ = false;
}

/// What presses stays posed as it was where it is not posed anew, for else it would be gone through in the next solve,
/// be posed by that, and so on.
void Contacts::keep_pressing() {
  keep_before([this](const Posed& before) { return forces_[before.pair] > 0.0; });
}

/// Poses again as they were those that were posed before and are not now. Both lists are in the order of the pairs.
template <typename Condition>
void Contacts::keep_before(Condition&& is_kept) {
  const auto posed_now = static_cast<std::ptrdiff_t>(posed_.size());
  const auto is_before = [](const Posed& a, const Posed& b) { return a.pair < b.pair; };
  for (const Posed& before : posed_before_) {
    if (!is_kept(before)) continue;
    if (!std::binary_search(posed_.begin(), posed_.begin() + posed_now, before, is_before)) posed_.push_back(before);
  }
  std::sort(posed_.begin(), posed_.end(), is_before);
}

void Contacts::pose_none() {
  posed_.clear();
  is_posed_ = false;
}

/// What would go through is posed as it touches.
void Contacts::pose_pair(std::size_t k) {
  const Corner& corner = corners_[k];
  const ContactPair& pair = pairs_[k];
  double share = 1.0;
  if (free_share(corner, passing_share, 1.0, approach_share) < 1.0)
    share = free_share(corner, nearest_share, 1.0, approach_share);
  const Separation gap = gap_at(pair, share);
  if (share == 1.0 && !(gap.distance < (1.0 + posed_share) * pair.reach)) return;
  if (is_minimum(pair, gap)) posed_.push_back({k, gap});
}

/// At that share of the way; leaves the pair's anchors there.
Separation Contacts::gap_at(const ContactPair& pair, double share) {
  for (const int anchor : {pair.disc, pair.a, pair.b, pair.before, pair.after}) {
    if (anchor >= 0) anchors_[at(anchor)] = from_[at(anchor)] + share * (to_[at(anchor)] - from_[at(anchor)]);
  }
  return find_separation(anchors_[at(pair.disc)], anchors_[at(pair.a)], anchors_[at(pair.b)]);
}

/// N, of friction.
double Contacts::limit(const Posed& posed) const { return pairs_[posed.pair].friction * rubbed_by_[posed.pair]; }

void Contacts::append_rows(std::span<const Vec2> x, double shortness, LimitedRows& rows) {
  posed_stiffness_ = shortness * shortness;
  place(x, false, anchors_);
  evaluated_ = false;
  for (const Posed& posed : posed_) {
    const ContactPair& pair = pairs_[posed.pair];
    const Separation& gap = posed.gap;
    const double stiffness = posed_stiffness_ * pair.stiffness;
    const Vec2 near = anchors_[at(pair.a)] + gap.along * (anchors_[at(pair.b)] - anchors_[at(pair.a)]);
    const double separation = dot(gap.normal, anchors_[at(pair.disc)] - near) - reach_now(pair.reach, pair.in);
    rows.add({normal_row(pair, gap, x), separation, 1.0 / stiffness, 0.0, std::numeric_limits<double>::infinity(),
              forces_[posed.pair]});
    const double most = limit(posed);
    if (!(most > 0.0)) continue;
    const Row tangent = tangent_row(pair, gap, x);
    const double slip = stretch({posed.pair, gap}, tangent, x);
    rows.add({tangent, slip, 1.0 / (friction_share * stiffness), -most, most, rubs_[posed.pair]});
  }
}

void Contacts::take_forces(const LimitedRows& rows, bool first) {
  std::fill(presses_.begin(), presses_.end(), 0.0);
  is_posed_ = true;
  std::size_t row = 0;
  for (const Posed& posed : posed_) {
    const double most = limit(posed);
    const double force = rows.rows()[row++].force;
    forces_[posed.pair] = presses_[posed.pair] = force;
    rubs_[posed.pair] = most > 0.0 ? rows.rows()[row++].force : 0.0;
    if (first) rubbed_by_[posed.pair] = force;
  }
}

void Contacts::keep_forces() {
  kept_posed_ = posed_;
  kept_forces_ = forces_;
  kept_presses_ = presses_;
  kept_rubs_ = rubs_;
}

void Contacts::return_to_forces() {
  posed_ = kept_posed_;
  forces_ = kept_forces_;
  presses_ = kept_presses_;
  rubs_ = kept_rubs_;
}

double Contacts::pressing_energy() const {
  double sum = 0.0;
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    if (forces_[k] != 0.0) sum += 0.5 * forces_[k] * forces_[k] / pairs_[k].stiffness;
  }
  return is_posed_ ? sum / posed_stiffness_ : sum;
}

double Contacts::share_to_blow(std::span<const Vec2> x, std::span<const Vec2> to) {
  place(x, false, from_);
  place(to, true, to_);
  watch(from_, to_);
  double share = 1.0;
  count_visits(near_.size());
  for (const std::size_t k : near_) {
    if (free_share(corners_[k], corners_[k].passing, share, approach_share) < share) {
      share = free_share(corners_[k], 1.0, share, 1.0);
    }
  }
  return share;
}

double Contacts::least_reach() const {
  double least = std::numeric_limits<double>::infinity();
  for (const Corner& corner : corners_) least = std::min(least, corner.reach);
  return corners_.empty() ? 0.0 : least;
}

/// What an anchor moves with; −1 for what nothing pushes.
int Contacts::group(int anchor, std::span<const int> group_of) const {
  if (at(anchor) < points_) return group_of[at(anchor)];
  const int center = spot(anchor).center;
  return center < 0 ? -1 : group_of[at(center)];
}

/// A pair is kept from coming nearer than its reach less the cord's radius: centre lines stay out of what they touch.
bool Contacts::keep_apart(std::span<const Vec2> from, std::span<const Vec2> to, std::span<const int> group_of,
                          std::span<double> shares) {
  go_between(from, to);
  ends_.assign(to_.begin(), to_.end());
  const auto go = [&] {
    for (const std::size_t i : paired_) {
      const int g = group(static_cast<int>(i), group_of);
      if (g >= 0) to_[i] = from_[i] + shares[at(g)] * (ends_[i] - from_[i]);
    }
  };
  go();
  for (int cut = 0; cut <= most_cuts; ++cut) {
    cuts_.assign(shares.size(), 1.0);
    bool apart = true;
    count_visits(near_.size());
    for (const std::size_t k : near_) {
      const Corner& corner = corners_[k];
      const double free = free_share(corner, corner.passing, 1.0, kept_share);
      if (free == 1.0) continue;
      apart = false;
      for (const int anchor : {corner.disc, corner.a, corner.b}) {
        const int g = group(anchor, group_of);
        if (g >= 0) cuts_[at(g)] = std::min(cuts_[at(g)], cut + 1 < most_cuts ? free : 0.0);
      }
    }
    if (apart) return cut == 0;
    for (std::size_t g = 0; g < shares.size(); ++g) shares[g] *= cuts_[g];
    go();
  }
  return false;
}

}  // namespace ribbon
