#include "ribbon/contacts.h"

#include <algorithm>
#include <cmath>

#include "ribbon/complex.h"
#include "ribbon/held_body.h"

namespace ribbon {
namespace {

constexpr double friction_share = 0.1;   // of a contact's stiffness, that friction's anchor has
constexpr double nearest_share = 0.9;    // of the reach, nearer than which nobody comes in a move
constexpr double passing_share = 0.5;    // of it, nearer than which who passes straight has gone through
constexpr double approach_share = 0.98;  // of the distance, if that is less already
constexpr double arrived_share = 1e-3;   // of the reach: no use in creeping nearer to the limit than this
constexpr double slowest_impact = 0.1;   // m/s, slower than which a hit is none
constexpr double slowest_rebound = 0.5;  // m/s, slower than which nothing rebounds
constexpr int most_advances = 32;
constexpr double settled_share = 1e-3;
constexpr double settled_depth = 1e-10;  // m, that rounding explains

void add_outer(BlockLdlt& matrix, double factor, std::span<const int> slots, std::span<const Vec2> by) {
  for (std::size_t i = 0; i < slots.size(); ++i) {
    const Vec2 g = factor * by[i];
    matrix.add(slots[i], g.x * by[i].x, g.x * by[i].y, g.y * by[i].y);
    for (std::size_t j = i + 1; j < slots.size(); ++j) {
      matrix.add(slots[i], slots[j], g.x * by[j].x, g.x * by[j].y, g.y * by[j].x, g.y * by[j].y);
    }
  }
}

}  // namespace

void Contacts::Row::add(int s, Vec2 d) {
  for (int i = 0; i < size; ++i) {
    if (slot[at(i)] != s) continue;
    by[at(i)] += d;
    return;
  }
  slot[at(size)] = s;
  by[at(size++)] = d;
}

double Contacts::Row::along(std::span<const Vec2> step) const {
  double sum = 0.0;
  for (int i = 0; i < size; ++i) sum += dot(by[at(i)], step[at(slot[at(i)])]);
  return sum;
}

double Contacts::longest_way(std::span<const Vec2> from, std::span<const Vec2> to) {
  double most2 = 0.0;
  for (std::size_t k = 0; k < to.size(); ++k) most2 = std::max(most2, dot(to[k] - from[k], to[k] - from[k]));
  return std::sqrt(most2);
}

void Contacts::clear(std::size_t points) {
  travelled_ = 0.0;
  clear_until_.clear();
  anchors_.clear();
  points_ = points;
  spots_.clear();
  pairs_.clear();
  active_.clear();
  touching_.clear();
}

int Contacts::add(const Spot& spot) {
  spots_.push_back(spot);
  return static_cast<int>(points_ + spots_.size()) - 1;
}

void Contacts::place(std::span<const Vec2> x, bool led, std::vector<Vec2>& anchors) const {
  anchors.resize(points_ + spots_.size());
  std::copy(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(points_), anchors.begin());
  for (std::size_t k = 0; k < spots_.size(); ++k) {
    const Spot& spot = spots_[k];
    Vec2& anchor = anchors[points_ + k];
    if (spot.center < 0) {
      anchor = led ? spot.goal : spot.here;
    } else {
      anchor = x[at(spot.center)];
      if (!(spot.arm == Vec2{})) anchor += times(rotation(x[at(spot.center) + 1].x), spot.arm);
    }
  }
}

void Contacts::begin(std::span<const Vec2> x) {
  place(x, false, starts_);
  slots_then_.assign(x.begin(), x.end());
  turned_then_.resize(spots_.size());
  for (std::size_t k = 0; k < spots_.size(); ++k) turned_then_[k] = spots_[k].turned;
  forces_.resize(pairs_.size());
  rubs_.assign(pairs_.size(), 0.0);
  for (std::size_t k = 0; k < pairs_.size(); ++k) forces_[k] = pairs_[k].touch.force;
  evaluate(x);
  first_ = touching_;
  hit_.assign(pairs_.size(), 0);
}

void Contacts::remember_hits(double weight) {
  for (const Active& active : active_) {
    const ContactPair& pair = pairs_[active.pair];
    hit_[active.pair] = 1;
    impulses_[active.pair] += weight * pair.stiffness * (pair.reach - active.gap.distance);
  }
}

void Contacts::scale_impulses(double factor) {
  impulses_.resize(pairs_.size());
  for (double& impulse : impulses_) impulse = factor == 0.0 ? 0.0 : factor * impulse;
}

bool Contacts::evaluate(std::span<const Vec2> x) {
  touched_.swap(touching_);
  find_touching(x);
  return touched_ != touching_;
}

bool Contacts::is_settled(std::span<const Vec2> x) {
  if (evaluate(x)) return false;
  double sum = 0.0;
  double off = 0.0;
  for (const Active& active : active_) {
    const ContactPair& pair = pairs_[active.pair];
    const double force = pair.stiffness * (pair.reach - active.gap.distance);
    sum += force + settled_depth * pair.stiffness / settled_share;
    off = std::max(off, std::abs(force - forces_[active.pair]));
    if (pair.friction == 0.0) continue;
    const double most = pair.friction * force;
    const double slid = stretch(active, tangent_row(pair, active.gap, x), x);
    const double rub = std::clamp(-friction_share * pair.stiffness * slid, -most, most);
    off = std::max(off, std::abs(rub - rubs_[active.pair]));
  }
  return off <= settled_share * sum;
}

bool Contacts::change(std::span<const Vec2> x) {
  evaluate(x);
  return changed();
}

/// Who was well apart where he was last looked at need not be looked at again until somebody has come half that way.
void Contacts::find_touching(std::span<const Vec2> x) {
  from_.swap(anchors_);
  place(x, false, anchors_);
  if (from_.size() != anchors_.size()) from_ = anchors_;
  travelled_ += longest_way(from_, anchors_);
  active_.clear();
  touching_.assign(pairs_.size(), 0);
  clear_until_.resize(pairs_.size(), 0.0);
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    if (travelled_ < clear_until_[k]) continue;
    const ContactPair& pair = pairs_[k];
    const Gap gap = gap_between(anchors_[at(pair.disc)], anchors_[at(pair.a)], anchors_[at(pair.b)]);
    clear_until_[k] = travelled_ + 0.5 * (gap.distance - pair.reach);
    if (!(gap.distance < pair.reach) || !is_minimum(pair, gap)) continue;
    active_.push_back({k, gap});
    touching_[k] = 1;
  }
}

/// Whether the distance is a local minimum along what the segment is part of, and this pair the one to say so: at a
/// vertex the one of the segment before it.
bool Contacts::is_minimum(const ContactPair& pair, const Gap& gap) const {
  if (gap.inside()) return true;
  const int vertex = gap.along == 0.0 ? pair.a : pair.b;
  if (!pair.ends || (pair.mutual && pair.disc > vertex)) return false;
  if (gap.along == 0.0) return pair.before < 0;
  if (pair.after < 0) return true;
  const Vec2 b = anchors_[at(pair.b)];
  return dot(anchors_[at(pair.disc)] - b, anchors_[at(pair.after)] - b) <= 0.0;
}

void Contacts::add_place(Row& row, int anchor, Vec2 by, Vec2 lever) const {
  if (at(anchor) < points_) {
    row.add(anchor, by);
  } else if (const int center = spot(anchor).center; center >= 0) {
    row.add(center, by);
    row.add(center + 1, {cross(lever, by), 0.0});
  }
}

/// From the centre of the body to the spot.
Vec2 Contacts::lever(int anchor, std::span<const Vec2> x) const {
  return is_moved_spot(anchor) ? anchors_[at(anchor)] - x[at(spot(anchor).center)] : Vec2{};
}

/// δd.
Contacts::Row Contacts::normal_row(const ContactPair& pair, const Gap& gap, std::span<const Vec2> x) const {
  Row row;
  add_place(row, pair.disc, gap.normal, lever(pair.disc, x));
  add_place(row, pair.a, -(1.0 - gap.along) * gap.normal, lever(pair.a, x));
  add_place(row, pair.b, -gap.along * gap.normal, lever(pair.b, x));
  return row;
}

/// How far one slides along the other, at the cord's axis, for its points cannot take a torque.
Contacts::Row Contacts::tangent_row(const ContactPair& pair, const Gap& gap, std::span<const Vec2> x) const {
  const Vec2 to_axis = pair.reach * gap.normal;
  Row row;
  add_place(row, pair.disc, gap.tangent, lever(pair.disc, x) - to_axis);
  add_place(row, pair.a, -(1.0 - gap.along) * gap.tangent, lever(pair.a, x) + to_axis);
  add_place(row, pair.b, -gap.along * gap.tangent, lever(pair.b, x) + to_axis);
  return row;
}

/// d·E/L − U: −δ²d = ((d·E/L − U)² − U²)/d, of which the first is the part that makes no matrix indefinite.
Contacts::Row Contacts::turning_row(const ContactPair& pair, const Gap& gap, std::span<const Vec2> x) const {
  const Vec2 across = (gap.distance / gap.length) * gap.normal;
  Row row;
  add_place(row, pair.disc, gap.tangent, lever(pair.disc, x));
  add_place(row, pair.a, -across - (1.0 - gap.along) * gap.tangent, lever(pair.a, x));
  add_place(row, pair.b, across - gap.along * gap.tangent, lever(pair.b, x));
  return row;
}

/// Of friction's anchor: how far the disc has slid since the substep began, and what was left from before.
double Contacts::stretch(const Active& active, const Row& tangent, std::span<const Vec2> x) const {
  const ContactPair& pair = pairs_[active.pair];
  double slip = pair.touch.stuck;
  for (int i = 0; i < tangent.size; ++i) {
    const std::size_t slot = at(tangent.slot[at(i)]);
    slip += dot(tangent.by[at(i)], x[slot] - slots_then_[slot]);
  }
  const auto add_led = [&](int anchor, double weight, double radius) {
    if (at(anchor) < points_ || spot(anchor).center >= 0) return;
    const double turned = spot(anchor).turned - turned_then_[at(anchor) - points_];
    slip += weight * (dot(active.gap.tangent, anchors_[at(anchor)] - starts_[at(anchor)]) + radius * turned);
  };
  const double axis = pair.reach * cross(active.gap.tangent, active.gap.normal);
  add_led(pair.disc, 1.0, axis);
  add_led(pair.a, -(1.0 - active.gap.along), -axis);
  add_led(pair.b, -active.gap.along, -axis);
  return slip;
}

double Contacts::potential(std::span<const Vec2> x) {
  find_touching(x);
  double sum = 0.0;
  for (const Active& active : active_) {
    const ContactPair& pair = pairs_[active.pair];
    const double depth = pair.reach - active.gap.distance;
    sum += 0.5 * pair.stiffness * depth * depth;
    const double most = pair.friction * forces_[active.pair];
    if (most == 0.0) continue;
    const double stiffness = friction_share * pair.stiffness;
    const double slip = std::abs(stretch(active, tangent_row(pair, active.gap, x), x));
    sum += stiffness * slip <= most ? 0.5 * stiffness * slip * slip : most * (slip - 0.5 * most / stiffness);
  }
  return sum;
}

double Contacts::energy() const {
  double sum = 0.0;
  for (const Active& active : active_) {
    const ContactPair& pair = pairs_[active.pair];
    const double depth = pair.reach - active.gap.distance;
    sum += 0.5 * pair.stiffness * depth * depth;
  }
  return sum;
}

bool Contacts::leans() const {
  const auto is_led = [this](int anchor) { return at(anchor) >= points_ && spot(anchor).center < 0; };
  return std::any_of(pairs_.begin(), pairs_.end(), [&](const ContactPair& pair) {
    return hit_[static_cast<std::size_t>(&pair - pairs_.data())] != 0 && (is_led(pair.disc) || is_led(pair.a));
  });
}

bool Contacts::are_coupled(const BlockLdlt& matrix) const {
  for (const Active& active : active_) {
    const Row row = slots_of(pairs_[active.pair]);
    for (int i = 0; i < row.size; ++i) {
      for (int j = i + 1; j < row.size; ++j) {
        if (!matrix.is_coupled(row.slot[at(i)], row.slot[at(j)])) return false;
      }
    }
  }
  return true;
}

void Contacts::couple(BlockLdlt& matrix) const {
  for (const Active& active : active_) {
    const Row row = slots_of(pairs_[active.pair]);
    for (int i = 0; i < row.size; ++i) {
      for (int j = i + 1; j < row.size; ++j) matrix.couple(row.slot[at(i)], row.slot[at(j)]);
    }
  }
}

Contacts::Row Contacts::slots_of(const ContactPair& pair) const {
  Row row;
  for (const int anchor : {pair.disc, pair.a, pair.b}) add_place(row, anchor, {}, {});
  return row;
}

bool Contacts::find_rebounds(std::span<const Vec2> x, std::span<const Vec2> before, std::span<const Vec2> after,
                             double dt) {
  place(x, false, anchors_);
  active_.clear();
  rebounds_.clear();
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const ContactPair& pair = pairs_[k];
    if (hit_[k] == 0) continue;
    const Gap gap = gap_between(anchors_[at(pair.disc)], anchors_[at(pair.a)], anchors_[at(pair.b)]);
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
double Contacts::led_speed(const ContactPair& pair, const Gap& gap) const {
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
    add_outer(matrix, pair.stiffness, normal.slots(), normal.derivatives());
  }
}

void Contacts::load(std::span<const Vec2> x, BlockLdlt& matrix, std::span<Vec2> force) {
  if (!rebounds_.empty()) {
    load_rebounds(x, matrix, force);
    return;
  }
  rows_.clear();
  frictions_.clear();
  for (const Active& active : active_) {
    const ContactPair& pair = pairs_[active.pair];
    const Gap& gap = active.gap;
    const auto push = [&](const Row& row, double by) {
      for (int i = 0; i < row.size; ++i) force[at(row.slot[at(i)])] += by * row.by[at(i)];
    };
    const Row normal = normal_row(pair, gap, x);
    rows_.push_back(normal);
    push(normal, pair.stiffness * (pair.reach - gap.distance));
    add_outer(matrix, pair.stiffness, normal.slots(), normal.derivatives());
    const double expected = forces_[active.pair];
    if (gap.inside() && gap.distance > 0.0) {
      const Row turning = turning_row(pair, gap, x);
      add_outer(matrix, expected / gap.distance, turning.slots(), turning.derivatives());
    }
    if (is_moved_spot(pair.disc)) {  // a spot that swings about its centre
      const double swing = expected * dot(gap.normal, lever(pair.disc, x));
      if (swing > 0.0) matrix.add(spot(pair.disc).center + 1, swing, 0.0, 0.0);
    }
    frictions_.emplace_back();
    if (pair.friction * expected == 0.0) continue;
    Friction& friction = frictions_.back();
    friction.tangent = tangent_row(pair, gap, x);
    const double stiffness = friction_share * pair.stiffness;
    const double pull = -stiffness * stretch(active, friction.tangent, x);
    const double most = pair.friction * expected;
    friction.sticks = std::abs(pull) <= most;
    friction.force = std::clamp(pull, -most, most);
    push(friction.tangent, friction.force);
    if (friction.sticks) add_outer(matrix, stiffness, friction.tangent.slots(), friction.tangent.derivatives());
  }
}

void Contacts::update(std::span<const Vec2> direction) {
  if (!rebounds_.empty()) return;
  std::fill(forces_.begin(), forces_.end(), 0.0);
  for (std::size_t k = 0; k < active_.size(); ++k) {
    const ContactPair& pair = pairs_[active_[k].pair];
    const double depth = pair.reach - active_[k].gap.distance - rows_[k].along(direction);
    // What friction pulled with in this solve: where it sticks by the step, and else as much as it was let.
    double& rub = rubs_[active_[k].pair];
    rub = frictions_[k].force;
    if (frictions_[k].sticks) rub -= friction_share * pair.stiffness * frictions_[k].tangent.along(direction);
    forces_[active_[k].pair] = pair.stiffness * std::max(0.0, depth);
  }
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

void Contacts::finish(std::span<const Vec2> x) {
  find_touching(x);
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    pairs_[k].touch.force = 0.0;
    pairs_[k].touch.impulse += impulses_[k];
    if (touching_[k] == 0) pairs_[k].touch.stuck = 0.0;
  }
  for (const Active& active : active_) {
    ContactPair& pair = pairs_[active.pair];
    Touch& touch = pair.touch;
    const double slid = stretch(active, tangent_row(pair, active.gap, x), x);
    touch.force = pair.stiffness * (pair.reach - active.gap.distance);
    const double most = pair.friction * touch.force / (friction_share * pair.stiffness);
    touch.stuck = std::clamp(slid, -most, most);
    touch.normal = active.gap.normal;
    touch.point = anchors_[at(pair.disc)] - pair.disc_radius * active.gap.normal;
  }
}

}  // namespace ribbon
