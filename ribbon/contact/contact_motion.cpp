#include <algorithm>
#include <cmath>

#include "ribbon/contact/contacts.h"
#include "ribbon/contact/held_body.h"
#include "ribbon/geometry/rotation.h"

// How far what may touch can go, and where what nothing pushes goes.

namespace ribbon {
namespace {

constexpr double kept_share = 0.25;      // of the reach, that who is watched is at least
constexpr double nearest_share = 0.9;    // of the reach, nearer than which nobody comes in a move
constexpr double passing_share = 0.5;    // of it, nearer than which who passes straight has gone through
constexpr double approach_share = 0.98;  // of the distance, if that is less already
constexpr double arrived_share = 1e-3;   // of the reach: no use in creeping nearer to the limit than this
constexpr int most_advances = 32;

}  // namespace

/// Finds the pairs that may touch on the way, if it leaves what those known are good for; and on as long a way again,
/// for Newton steps get shorter. Who keeps to his slack is left as he was found, and so are pairs of such.
void Contacts::watch(std::span<const Vec2> from, std::span<const Vec2> to) {
  const bool first = watched_from_.size() != from.size();
  if (first) {
    const std::size_t room = points_ + spots_.capacity();
    watched_from_.reserve(room);
    slacks_.reserve(room);
    left_.reserve(room);
    watched_.reserve(pairs_.capacity());
    near_.reserve(pairs_.capacity());
    paired_.reserve(room);
    watched_from_.assign(from.begin(), from.end());
    slacks_.assign(from.size(), 0.0);
    left_.assign(from.size(), 1);
    watched_.resize(pairs_.size());
    find_paired();
  } else if (!find_left(from, to)) {
    return;
  }
  for (const std::size_t i : paired_) {
    if (left_[i] == 0) continue;
    const double last = std::min(length(from[i] - watched_from_[i]), slacks_[i]);
    slacks_[i] = std::max(least_slack_, 2.0 * std::max(length(to[i] - from[i]), last));
    watched_from_[i] = from[i];
  }
  near_.clear();
  count_visits(pairs_.size());
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const Corner& pair = corners_[k];
    if (left_[at(pair.disc)] != 0 || left_[at(pair.a)] != 0 || left_[at(pair.b)] != 0) watched_[k] = is_near(pair);
    if (watched_[k] != 0) near_.push_back(k);
  }
}

/// The anchors that any pair has, in order.
void Contacts::find_paired() {
  std::vector<char>& is_paired = left_;
  std::fill(is_paired.begin(), is_paired.end(), 0);
  for (const Corner& pair : corners_) is_paired[at(pair.disc)] = is_paired[at(pair.a)] = is_paired[at(pair.b)] = 1;
  paired_.clear();
  for (std::size_t i = 0; i < is_paired.size(); ++i) {
    if (is_paired[i] != 0) paired_.push_back(i);
  }
}

/// Who leaves his slack.
bool Contacts::find_left(std::span<const Vec2> from, std::span<const Vec2> to) {
  char any = 0;
  const bool goes = from.data() != to.data();
  for (const std::size_t i : paired_) {
    const Vec2 here = from[i] - watched_from_[i];
    const Vec2 there = goes ? to[i] - watched_from_[i] : here;
    const double slack2 = slacks_[i] * slacks_[i];
    left_[i] = dot(here, here) <= slack2 && dot(there, there) <= slack2 ? 0 : 1;
    any = static_cast<char>(any | left_[i]);
  }
  return any != 0;
}

/// Whether the pair may touch while all of it keep to their slacks.
bool Contacts::is_near(const Corner& pair) const {
  const Vec2 disc = watched_from_[at(pair.disc)];
  const Vec2 a = watched_from_[at(pair.a)];
  const Vec2 b = watched_from_[at(pair.b)];
  const double slack = slacks_[at(pair.disc)] + std::max(slacks_[at(pair.a)], slacks_[at(pair.b)]);
  const double near = (1.0 + kept_share) * pair.reach + slack;
  return may_be_within(near, disc, a, b) && find_separation(disc, a, b).distance <= near;
}

double Contacts::free_way(std::span<const Vec2> x, std::span<const Vec2> to, bool led, double most) {
  place(x, false, from_);
  place(to, led, to_);
  watch(from_, to_);
  double share = most;
  count_visits(near_.size());
  for (const std::size_t k : near_) share = free_share(corners_[k], nearest_share, share, approach_share);
  return share;
}

bool Contacts::is_straight(std::span<const Vec2> from, std::span<const Vec2> x) {
  place(from, false, from_);
  place(x, false, to_);
  for (std::size_t k = 0; k < spots_.size(); ++k) {
    if (spots_[k].center < 0) from_[points_ + k] = spots_[k].begun;
  }
  watch(from_, to_);
  count_visits(near_.size());
  return std::all_of(near_.begin(), near_.end(), [this](std::size_t k) {
    return free_share(corners_[k], passing_share, 1.0, approach_share) == 1.0;
  });
}

/// While the ends move evenly, no point p of the segment comes nearer to the disc o than along a fixed direction: with
/// n the normal now, |o − p| ≥ n·(o − p), which is linear in time and p, so that the greater of the speeds at which the
/// ends come along n bounds it for all the way. Who parts is free, however deep he is.
double Contacts::free_share(const Corner& pair, double share_of_reach, double most, double kept) const {
  const auto way = [this](int anchor) { return to_[at(anchor)] - from_[at(anchor)]; };
  const Vec2 disc = way(pair.disc);
  const Vec2 past_a = disc - way(pair.a);
  const Vec2 past_b = disc - way(pair.b);
  const double speed = std::sqrt(std::max(dot(past_a, past_a), dot(past_b, past_b)));
  if (speed == 0.0) return most;
  const double near = share_of_reach * pair.reach + most * speed;
  if (!may_be_within(near, from_[at(pair.disc)], from_[at(pair.a)], from_[at(pair.b)])) return most;
  const auto gap = [&](double share) {
    const auto there = [&](int anchor) { return from_[at(anchor)] + share * way(anchor); };
    return find_separation(there(pair.disc), there(pair.a), there(pair.b));
  };
  Separation now = gap(0.0);
  double share = 0.0;
  const double nearest = std::min(share_of_reach * pair.reach, kept * now.distance);
  for (int k = 0; k < most_advances; ++k) {
    if (now.distance - nearest <= arrived_share * pair.reach && k > 0) break;
    const double approach = -std::min(dot(now.normal, past_a), dot(now.normal, past_b));
    if (!(now.distance - nearest < approach * (most - share))) return most;
    share += (now.distance - nearest) / approach;
    now = gap(share);
  }
  return share;
}

void Contacts::aim(double time) {
  for (Spot& spot : spots_) {
    if (spot.center >= 0) continue;
    spot.begun = spot.here;
    spot.turned_goal = time * spot.turning;
    spot.goal = spot.from + time * spot.velocity + times(rotation(spot.turned_goal), spot.arm);
  }
}

void Contacts::place_led(double time) {
  aim(time);
  lead(1.0);
}

void Contacts::lead(double share) {
  for (Spot& spot : spots_) {
    if (spot.center >= 0) continue;
    if (share == 1.0) {
      spot.here = spot.goal;
      spot.turned = spot.turned_goal;
    } else {
      spot.here += share * (spot.goal - spot.here);
      spot.turned += share * (spot.turned_goal - spot.turned);
    }
  }
}

}  // namespace ribbon
