#include "game/simulation/tether.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace game {
namespace {

using ribbon::Vec2;

/// Returns points in equal steps of `link` from one place to another: a zigzag whose every link leans by the same
/// angle, to one side and the other in turn.
std::vector<Vec2> folded(Vec2 from, Vec2 to, int links, double link) {
  const Vec2 step = (1.0 / links) * (to - from);
  const double ahead = std::min(length(step), link);
  const Vec2 along = length(step) > 0.0 ? (1.0 / length(step)) * step : Vec2{1.0, 0.0};
  const Vec2 aside = std::sqrt(std::max(0.0, link * link - ahead * ahead)) * Vec2{-along.y, along.x};
  std::vector<Vec2> points;
  for (int k = 0; k <= links; ++k) {
    points.push_back(from + (k * ahead) * along + (k % 2 == 1 ? aside : Vec2{}));
  }
  return points;
}

bool is_level_ground(const b2Contact& contact, bool is_b) {
  constexpr double upright = 0.7;  // least upward component of the normal
  if (!contact.IsTouching()) return false;
  b2WorldManifold manifold;
  contact.GetWorldManifold(&manifold);
  return static_cast<double>(is_b ? manifold.normal.y : -manifold.normal.y) > upright;
}

}  // namespace

Tether::Tether(ribbon::box2d::CordId cord, Player& first, Player& second, ribbon::box2d::Coupling& coupling)
    : cord_(cord), length_(coupling.cord(cord).direct().def().length) {
  tie(first, second, coupling);
}

void Tether::tie(Player& first, Player& second, ribbon::box2d::Coupling& coupling) {
  const int last = coupling.cord(cord_).shape().columns - 1;
  grips_[0] = coupling.hold(cord_, 0, first.body(), {0.0F, 0.0F});
  grips_[1] = coupling.hold(cord_, last, second.body(), {0.0F, 0.0F});
  first.set_tether(grips_[0]);
  second.set_tether(grips_[1]);
}

void Tether::reel(int direction, ribbon::box2d::Coupling& coupling, double dt) {
  if (direction == 0 || !coupling.cord(cord_).is_valid()) return;
  if (direction < 0 && pull(coupling) > max_pull) return;  // a partner is stuck at an edge
  const double whole = coupling.cord(cord_).direct().def().length;
  const double speed = direction < 0 ? reel_in_speed : reel_out_speed;
  length_ = std::clamp(length_ + direction * speed * dt, std::min(min_length, whole), whole);
  coupling.cord(cord_).direct().reel(0, coupling.cord(cord_).shape().columns - 1, length_, speed);
}

/// Returns the larger pull of the cord at a player, N.
double Tether::pull(const ribbon::box2d::Coupling& coupling) const {
  double largest = 0.0;
  for (const ribbon::box2d::GripId id : grips_) {
    if (coupling.grip(id).is_valid()) largest = std::max(largest, ribbon::length(coupling.grip(id).state().pull));
  }
  return largest;
}

void Tether::lay(Player& first, Player& second, ribbon::box2d::Coupling& coupling) {
  if (!coupling.cord(cord_).is_valid()) return;
  ribbon::CordDef def = coupling.cord(cord_).direct().def();
  const int links = coupling.cord(cord_).shape().columns - 1;
  def.positions = folded(first.position(), second.position(), links, def.length / links);
  const b2Filter filter = coupling.cord(cord_).filter();
  coupling.cord(cord_).replace(ribbon::Cord(def), filter);
  length_ = def.length;
  tie(first, second, coupling);
}

void Tether::add_to(ribbon::box2d::Hasher& hasher) const {
  hasher.add(cord_);
  hasher.add(length_);
  for (const ribbon::box2d::GripId grip : grips_) hasher.add(grip);
}

void brace(Player& player, bool stands_still) {
  for (b2ContactEdge* edge = player.body().GetContactList(); edge != nullptr; edge = edge->next) {
    const bool is_b = edge->contact->GetFixtureB()->GetBody() == &player.body();
    const bool holds = stands_still && is_level_ground(*edge->contact, is_b);
    edge->contact->SetFriction(holds ? static_cast<float>(Tether::foot_friction) : 0.0F);
  }
}

}  // namespace game
