#include <algorithm>
#include <cmath>

#include "ribbon/complex.h"
#include "ribbon/contacts.h"
#include "ribbon/held_body.h"

// How far what may touch can go, and where what nothing pushes goes.

namespace ribbon {
namespace {

constexpr double nearest_share = 0.9;    // of the reach, nearer than which nobody comes in a move
constexpr double passing_share = 0.5;    // of it, nearer than which who passes straight has gone through
constexpr double approach_share = 0.98;  // of the distance, if that is less already
constexpr double arrived_share = 1e-3;   // of the reach: no use in creeping nearer to the limit than this
constexpr int most_advances = 32;

}  // namespace

double Contacts::longest_way(std::span<const Vec2> from, std::span<const Vec2> to) {
  double most2 = 0.0;
  for (std::size_t k = 0; k < to.size(); ++k) most2 = std::max(most2, dot(to[k] - from[k], to[k] - from[k]));
  return std::sqrt(most2);
}

double Contacts::free_way(std::span<const Vec2> x, std::span<const Vec2> to, bool led, double most) {
  place(x, false, from_);
  place(to, led, to_);
  const double way = longest_way(anchors_, from_) + longest_way(from_, to_);
  double share = most;
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    if (travelled_ + way >= clear_until_[k]) share = free_share(pairs_[k], nearest_share, share);
  }
  return share;
}

bool Contacts::is_straight(std::span<const Vec2> from, std::span<const Vec2> x) {
  place(from, false, from_);
  place(x, false, to_);
  for (std::size_t k = 0; k < spots_.size(); ++k) {
    if (spots_[k].center < 0) from_[points_ + k] = spots_[k].begun;
  }
  const double way = longest_way(anchors_, from_) + longest_way(from_, to_);
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    if (travelled_ + way >= clear_until_[k] && free_share(pairs_[k], passing_share, 1.0) < 1.0) return false;
  }
  return true;
}

/// No point of the segment comes nearer to the disc than at the greater of the speeds of its ends.
double Contacts::free_share(const ContactPair& pair, double share_of_reach, double most) const {
  const auto way = [this](int anchor) { return to_[at(anchor)] - from_[at(anchor)]; };
  const Vec2 disc = way(pair.disc);
  const double speed = std::max(length(disc - way(pair.a)), length(disc - way(pair.b)));
  if (speed == 0.0) return most;
  const auto distance = [&](double share) {
    const auto there = [&](int anchor) { return from_[at(anchor)] + share * way(anchor); };
    return gap_between(there(pair.disc), there(pair.a), there(pair.b)).distance;
  };
  double now = distance(0.0);
  const double nearest = std::min(share_of_reach * pair.reach, approach_share * now);
  double share = 0.0;
  for (int k = 0; k < most_advances; ++k) {
    if (now - nearest <= arrived_share * pair.reach && k > 0) break;
    share += (now - nearest) / speed;
    if (share >= most) return most;
    now = distance(share);
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
