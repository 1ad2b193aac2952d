#include "ribbon/contact/contacts.h"

#include <algorithm>
#include <cmath>

#include "ribbon/contact/held_body.h"
#include "ribbon/geometry/rotation.h"

namespace ribbon {
namespace {

constexpr double friction_share = 0.1;  // of a contact's stiffness, that friction's anchor has
constexpr double settled_share = 1e-3;
constexpr double settled_depth = 1e-10;  // m, that rounding explains
constexpr double kept_share = 0.25;      // of the reach, further off than which who pressed has let go
constexpr double slack_share = 0.1;
constexpr double passing_share = 0.5;  // of a reach, nearer than which a centre line is in whatever it touches
constexpr double most_passing_share = 0.95;
constexpr double shallow_share = 0.01;
constexpr double stuck_share = 0.99;  // of the limit, below which friction begins as it ended the last step: stuck
constexpr int most_turns = 3;         // of who slides, before it is braked instead
// Room that there is from the first on, so that what comes near in a game seldom takes memory.
constexpr std::size_t usual_pairs = 64;
constexpr std::size_t usual_spots = 16;

/// A value for each pair, in memory that grows as seldom as that of the pairs: twice as much each time, while an
/// assignment alone would take it anew with each pair more than there ever were.
template <typename T>
void assign_each(std::vector<T>& all, const std::vector<ContactPair>& pairs, T value) {
  all.reserve(pairs.capacity());
  all.assign(pairs.size(), value);
}

}  // namespace

void Contacts::clear(std::size_t points) {
  watched_from_.clear();
  least_slack_ = 0.0;
  points_ = points;
  spots_.clear();
  pairs_.clear();
  corners_.clear();
  active_.clear();
  evaluated_ = false;
  touching_.clear();
  hit_.clear();  // no substep begins without pairs: who asks what was hit must not hear of another island's
}

int Contacts::add(const Spot& spot) {
  if (spots_.empty()) spots_.reserve(usual_spots);
  spots_.push_back(spot);
  return static_cast<int>(points_ + spots_.size()) - 1;
}

void Contacts::add(const ContactPair& pair) {
  const double slack = slack_share * pair.reach;
  if (pairs_.empty() || slack < least_slack_) least_slack_ = slack;
  if (pairs_.empty()) pairs_.reserve(usual_pairs);
  pairs_.push_back(pair);
  corners_.reserve(pairs_.capacity());
  const double cord_radius = at(pair.disc) < points_ ? pair.disc_radius : pair.reach - pair.disc_radius;
  const double passing = std::clamp(1.0 - cord_radius / pair.reach, passing_share, most_passing_share);
  corners_.push_back({pair.disc, pair.a, pair.b, pair.reach, pair.in, passing});
}

void Contacts::place(std::span<const Vec2> x, bool led, std::vector<Vec2>& anchors) const {
  anchors.reserve(points_ + spots_.capacity());
  anchors.resize(points_ + spots_.size());
  std::copy(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(points_), anchors.begin());
  int turned_by = -1;  // the slot of the angle that `turn` is of: a body's spots follow each other
  Vec2 turn;
  for (std::size_t k = 0; k < spots_.size(); ++k) {
    const Spot& spot = spots_[k];
    Vec2& anchor = anchors[points_ + k];
    if (spot.center < 0) {
      anchor = led ? spot.goal : spot.here;
      continue;
    }
    anchor = x[at(spot.center)];
    if (spot.arm == Vec2{}) continue;
    if (turned_by != spot.center + 1) {
      turned_by = spot.center + 1;
      turn = rotation(x[at(turned_by)].x);
    }
    anchor += times(turn, spot.arm);
  }
}

void Contacts::begin(std::span<const Vec2> x, double share) {
  emerged_ = share;
  evaluated_ = false;
  is_posed_ = false;
  active_.reserve(pairs_.capacity());
  rows_.reserve(pairs_.capacity());
  frictions_.reserve(pairs_.capacity());
  posed_.reserve(pairs_.capacity());
  posed_before_.reserve(pairs_.capacity());
  kept_posed_.reserve(pairs_.capacity());
  for (auto* kept : {&kept_forces_, &kept_presses_, &kept_rubs_}) kept->reserve(pairs_.capacity());
  ends_.reserve(points_ + spots_.capacity());
  cuts_.reserve(x.size());
  place(x, false, starts_);
  slots_then_.assign(x.begin(), x.end());
  turned_then_.reserve(spots_.capacity());
  turned_then_.resize(spots_.size());
  for (std::size_t k = 0; k < spots_.size(); ++k) turned_then_[k] = spots_[k].turned;
  assign_each(forces_, pairs_, 0.0);
  assign_each(presses_, pairs_, 0.0);
  assign_each(rubs_, pairs_, 0.0);
  assign_each(holds_, pairs_, '\0');
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    forces_[k] = pairs_[k].touch.force;
    const double pull = friction_share * pairs_[k].stiffness * std::abs(pairs_[k].touch.stuck);
    holds_[k] = pull < stuck_share * pairs_[k].friction * forces_[k] ? 1 : 0;
  }
  rubbed_by_.reserve(pairs_.capacity());
  rubbed_by_ = forces_;
  evaluate(x);
  first_.reserve(pairs_.capacity());
  first_ = touching_;
  assign_each(hit_, pairs_, '\0');
}

bool Contacts::evaluate(std::span<const Vec2> x) {
  if (is_evaluated(x)) return false;
  touched_.swap(touching_);
  find_touching(x);
  return touched_ != touching_;
}

void Contacts::begin_stage() {
  assign_each(slid_, pairs_, 0.0);
  assign_each(turns_, pairs_, 0);
}

void Contacts::prepare(std::span<const Vec2> x, bool strict) {
  if (strict) {
    std::fill(holds_.begin(), holds_.end(), 0);
    std::fill(slid_.begin(), slid_.end(), 0.0);
  }
  find_touching(x, strict ? 0.0 : kept_share);
}

bool Contacts::is_settled(std::span<const Vec2> x, double tolerated) {
  evaluate(x);
  double sum = 0.0;
  double off = 0.0;
  double off_depth = 0.0;
  const auto take = [&](const ContactPair& pair, double difference) {
    off = std::max(off, std::abs(difference));
    off_depth = std::max(off_depth, std::abs(difference) / pair.stiffness);
  };
  for (const std::size_t k : near_) {
    if (touching_[k] == 0) take(pairs_[k], presses_[k]);
  }
  for (const Active& active : active_) {
    const ContactPair& pair = pairs_[active.pair];
    const double force = pair.stiffness * depth(active);
    sum += force + settled_depth * pair.stiffness / settled_share;
    take(pair, force - forces_[active.pair]);
    if (pair.friction == 0.0) continue;
    const double most = pair.friction * force;
    const double slid = stretch(active, tangent_row(pair, active.gap, x), x);
    const double rub = std::clamp(-friction_share * pair.stiffness * slid, -most, most);
    take(pair, rub - rubs_[active.pair]);
  }
  return off <= settled_share * sum || off_depth <= tolerated / soft_firmness;
}

bool Contacts::are_shallow() const {
  return std::all_of(active_.begin(), active_.end(), [this](const Active& active) {
    return active.gap.distance > (1.0 - shallow_share) * pairs_[active.pair].reach;
  });
}

bool Contacts::change(std::span<const Vec2> x) {
  evaluate(x);
  return changed();
}

/// Whether that would find what the last time did.
bool Contacts::is_evaluated(std::span<const Vec2> x) {
  if (!evaluated_) return false;
  place(x, false, from_);
  return from_ == anchors_;
}

void Contacts::find_touching(std::span<const Vec2> x, double kept) {
  place(x, false, anchors_);
  watch(anchors_, anchors_);
  evaluated_ = kept == 0.0;
  active_.clear();
  assign_each(touching_, pairs_, '\0');
  count_visits(near_.size());
  for (const std::size_t k : near_) {
    const Corner& corner = corners_[k];
    const double reach = reach_now(corner.reach, corner.in) + (forces_[k] > 0.0 ? kept * corner.reach : 0.0);
    const Vec2 disc = anchors_[at(corner.disc)];
    const Vec2 a = anchors_[at(corner.a)];
    const Vec2 b = anchors_[at(corner.b)];
    if (!may_be_within(reach, disc, a, b)) continue;
    const Separation gap = find_separation(disc, a, b);
    if (!(gap.distance < reach) || !is_minimum(pairs_[k], gap)) continue;
    active_.push_back({k, gap});
    touching_[k] = 1;
  }
}

double Contacts::depth(const Active& active) const {
  const ContactPair& pair = pairs_[active.pair];
  return reach_now(pair.reach, pair.in) - active.gap.distance;
}

/// Whether the distance is a local minimum along what the segment is part of, and this pair the one to say so: at a
/// vertex the one of the segment before it.
bool Contacts::is_minimum(const ContactPair& pair, const Separation& gap) const {
  if (gap.is_interior()) return true;
  const int vertex = gap.along == 0.0 ? pair.a : pair.b;
  if (!pair.ends || (pair.mutual && pair.disc > vertex)) return false;
  if (gap.along == 0.0) return pair.before < 0;
  if (pair.after < 0) return true;
  const Vec2 b = anchors_[at(pair.b)];
  return dot(anchors_[at(pair.disc)] - b, anchors_[at(pair.after)] - b) <= 0.0;
}

double Contacts::potential(std::span<const Vec2> x) {
  find_touching(x);
  double sum = 0.0;
  for (const Active& active : active_) {
    const ContactPair& pair = pairs_[active.pair];
    const double in = depth(active);
    sum += 0.5 * pair.stiffness * in * in;
    const double most = pair.friction * forces_[active.pair];
    if (most == 0.0) continue;
    const double stiffness = friction_share * pair.stiffness;
    const double slip = std::abs(stretch(active, tangent_row(pair, active.gap, x), x));
    sum += stiffness * slip <= most ? 0.5 * stiffness * slip * slip : most * (slip - 0.5 * most / stiffness);
  }
  return sum;
}

double Contacts::energy() const {
  if (is_posed_) return pressing_energy();
  double sum = 0.0;
  for (const Active& active : active_) {
    const ContactPair& pair = pairs_[active.pair];
    const double in = depth(active);
    sum += 0.5 * pair.stiffness * in * in;
  }
  return sum;
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

void Contacts::load(std::span<const Vec2> x, BlockLdlt& matrix, std::span<Vec2> force) {
  if (!rebounds_.empty()) {
    load_rebounds(x, matrix, force);
    return;
  }
  rows_.clear();
  frictions_.clear();
  for (const Active& active : active_) {
    const ContactPair& pair = pairs_[active.pair];
    const Separation& gap = active.gap;
    const auto push = [&](const Row& row, double by) {
      for (int i = 0; i < row.size; ++i) force[at(row.slot[at(i)])] += by * row.by[at(i)];
    };
    const Row normal = normal_row(pair, gap, x);
    rows_.push_back(normal);
    push(normal, pair.stiffness * depth(active));
    matrix.add_outer(pair.stiffness, normal.slots(), normal.derivatives());
    const double expected = forces_[active.pair];
    if (gap.is_interior() && gap.distance > 0.0) {
      const Row turning = turning_row(pair, gap, x);
      matrix.add_outer(expected / gap.distance, turning.slots(), turning.derivatives());
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
    // Full steps from sliding one way to sliding the other, and back, would never end where it sticks. So who turns is
    // taken to stick, and stays stuck as long as that solve says so; who still turns is braked by the secant of its
    // force, as long a way to the solution as that may be.
    const std::size_t k = active.pair;
    const bool turns = slid_[k] * pull < 0.0;
    if (turns) ++turns_[k];
    const bool braked = turns_[k] > most_turns;
    friction.sticks = std::abs(pull) <= most || (!braked && (turns || holds_[k] != 0));
    friction.force = friction.sticks ? pull : std::clamp(pull, -most, most);
    if (friction.sticks || braked) friction.stiffness = friction.sticks ? stiffness : stiffness * most / std::abs(pull);
    push(friction.tangent, friction.force);
    if (friction.stiffness > 0.0) {
      matrix.add_outer(friction.stiffness, friction.tangent.slots(), friction.tangent.derivatives());
    }
  }
}

void Contacts::update(std::span<const Vec2> direction) {
  if (!rebounds_.empty()) return;
  std::fill(presses_.begin(), presses_.end(), 0.0);
  std::fill(forces_.begin(), forces_.end(), 0.0);
  std::fill(holds_.begin(), holds_.end(), 0);
  std::fill(slid_.begin(), slid_.end(), 0.0);
  for (std::size_t k = 0; k < active_.size(); ++k) {
    const ContactPair& pair = pairs_[active_[k].pair];
    const double in = depth(active_[k]) - rows_[k].along(direction);
    const std::size_t p = active_[k].pair;
    const Friction& friction = frictions_[k];
    presses_[p] = pair.stiffness * in;
    forces_[p] = std::max(0.0, presses_[p]);
    // What friction pulled with in this solve: where it sticks by the step, and else as much as it was let.
    rubs_[p] = friction.force - friction.stiffness * friction.tangent.along(direction);
    holds_[p] = friction.sticks && std::abs(rubs_[p]) <= pair.friction * forces_[p] ? 1 : 0;
    slid_[p] = friction.sticks ? 0.0 : friction.force;
  }
}

void Contacts::finish(std::span<const Vec2> x) {
  evaluate(x);
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    pairs_[k].touch.force = 0.0;
    pairs_[k].touch.impulse += impulses_[k];
    if (touching_[k] == 0) pairs_[k].touch.stuck = 0.0;
  }
  for (const Active& active : active_) {
    ContactPair& pair = pairs_[active.pair];
    Touch& touch = pair.touch;
    const double slid = stretch(active, tangent_row(pair, active.gap, x), x);
    touch.force = is_posed_ ? forces_[active.pair] : pair.stiffness * depth(active);
    const double most = pair.friction * touch.force / (friction_share * pair.stiffness);
    touch.stuck = std::clamp(slid, -most, most);
    touch.normal = active.gap.normal;
    touch.point = anchors_[at(pair.disc)] - pair.disc_radius * active.gap.normal;
  }
}

}  // namespace ribbon
