#include <algorithm>

#include "ribbon/contact/contacts.h"

// Who is hit, with what impulse, and how he rebounds.

namespace ribbon {
namespace {

constexpr double slowest_impact = 0.1;   // m/s, slower than which a hit is none
constexpr double slowest_rebound = 0.5;  // m/s, slower than which nothing rebounds

}  // namespace

bool Contacts::find_rebounds(std::span<const Vec2> x, std::span<const Vec2> before, std::span<const Vec2> after,
                             double dt) {
  place(x, false, anchors_);
  evaluated_ = false;
  active_.clear();
  rebounds_.clear();
  rebounds_.reserve(pairs_.capacity());
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const ContactPair& pair = pairs_[k];
    if (hit_[k] == 0) continue;
    const Separation gap = find_separation(anchors_[at(pair.disc)], anchors_[at(pair.a)], anchors_[at(pair.b)]);
    if (!(gap.distance < 2.0 * pair.reach) || !is_minimum(pair, gap)) continue;
    const Row normal = normal_row(pair, gap, x);
    const double led = led_speed(pair, gap);
    const double approach = -(normal.along(before) + led);
    if (approach < slowest_impact) continue;
    const double restitution = approach > slowest_rebound ? pair.restitution : 0.0;
    active_.push_back({k, gap});
    rebounds_.push_back(dt * (restitution * approach - normal.along(after) - led));
  }
  return !active_.empty();
}

/// m/s, at which what nothing pushes takes a disc away from its segment.
double Contacts::led_speed(const ContactPair& pair, const Separation& gap) const {
  const auto along = [&](int anchor) {
    if (at(anchor) < points_ || spot(anchor).center >= 0) return 0.0;
    const Spot& led = spot(anchor);
    return dot(gap.normal, led.velocity + led.turning * perp(anchors_[at(anchor)] - led.from));
  };
  return along(pair.disc) - (1.0 - gap.along) * along(pair.a) - gap.along * along(pair.b);
}

void Contacts::end_rebounds(std::span<const Vec2> x) {
  rebounds_.clear();
  find_touching(x);
}

/// Normal rows alone, each to be opened by so much.
void Contacts::load_rebounds(std::span<const Vec2> x, BlockLdlt& matrix, std::span<Vec2> force) const {
  for (std::size_t k = 0; k < active_.size(); ++k) {
    const ContactPair& pair = pairs_[active_[k].pair];
    const Row normal = normal_row(pair, active_[k].gap, x);
    for (int i = 0; i < normal.size; ++i) {
      force[at(normal.slot[at(i)])] += pair.stiffness * rebounds_[k] * normal.by[at(i)];
    }
    matrix.add_outer(pair.stiffness, normal.slots(), normal.derivatives());
  }
}

bool Contacts::leans() const {
  const auto is_led = [this](int anchor) { return at(anchor) >= points_ && spot(anchor).center < 0; };
  return std::any_of(pairs_.begin(), pairs_.end(), [&](const ContactPair& pair) {
    return hit_[static_cast<std::size_t>(&pair - pairs_.data())] != 0 && (is_led(pair.disc) || is_led(pair.a));
  });
}

void Contacts::remember_hits(double weight) {
  if (is_posed_) {
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
      if (forces_[k] <= 0.0) continue;
      hit_[k] = 1;
      impulses_[k] += weight * forces_[k];
    }
    return;
  }
  for (const Active& active : active_) {
    hit_[active.pair] = 1;
    impulses_[active.pair] += weight * pairs_[active.pair].stiffness * depth(active);
  }
}

void Contacts::scale_impulses(double factor) {
  impulses_.reserve(pairs_.capacity());
  impulses_.resize(pairs_.size());
  for (double& impulse : impulses_) impulse = factor == 0.0 ? 0.0 : factor * impulse;
}

}  // namespace ribbon
