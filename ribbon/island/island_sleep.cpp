#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <numbers>

#include "ribbon/island/island.h"

// Cords at rest among what is at rest are not stepped: CordDef::allow_sleep.

namespace ribbon {
namespace {

// Below which a body of Box2D falls asleep: b2_linearSleepTolerance and b2_angularSleepTolerance.
constexpr double restful_speed = 0.01;                              // m/s
constexpr double restful_turning = 2.0 / 180.0 * std::numbers::pi;  // rad/s

/// Tells surroundings apart, by each of their bits.
class Fingerprint {
 public:
  void add(std::uint64_t bits) {
    value_ = (value_ ^ bits) * 0x9e3779b97f4a7c15U;  // 2⁶⁴ by the golden ratio, which spreads upwards
    value_ ^= value_ >> 32U;                         // and this downwards
  }
  void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
  void add(Vec2 v) {
    add(v.x);
    add(v.y);
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 1;
};

bool is_slow(Vec2 velocity) { return dot(velocity, velocity) < restful_speed * restful_speed; }

/// A body that can be pushed does not keep a cord awake if it sleeps, or goes to sleep with it.
bool is_still(const RigidBody& body, bool asleep) {
  if (body.inverse_mass == 0.0) return body.velocity == Vec2{} && body.angular_velocity == 0.0;
  if (asleep) return !body.awake;
  return body.may_sleep && is_slow(body.velocity) && std::abs(body.angular_velocity) < restful_turning;
}

/// A number for what a cord at rest lies among, 0 if some of it moves: where everything is, but what creeps to its own
/// rest. Of a cord that is asleep nothing does.
std::uint64_t stillness(const Surroundings& met, std::span<const RigidBody> bodies, Vec2 gravity, bool asleep) {
  Fingerprint print;
  print.add(gravity);
  bool still = true;
  const auto add_place = [&](int index, std::initializer_list<Vec2> places) {
    const RigidBody& body = bodies[static_cast<std::size_t>(index)];
    still = still && is_still(body, asleep);
    if (body.inverse_mass > 0.0) return;
    print.add(body.position);
    for (const Vec2 place : places) print.add(place);
  };
  for (const RigidCircle& circle : met.circles) {
    add_place(circle.body, {circle.offset});
    print.add(circle.id);
    for (const double number : {circle.radius, circle.friction, circle.restitution}) print.add(number);
  }
  for (const RigidSegment& segment : met.segments) {
    add_place(segment.body, {segment.a, segment.b});
    print.add(segment.id);
    for (const double number : {segment.radius, segment.friction, segment.restitution}) print.add(number);
  }
  for (const Grip& grip : met.grips) {
    add_place(grip.body, {grip.offset});
    still = still && grip.travel == Vec2{} && grip.climb == 0.0;
    print.add(static_cast<std::uint64_t>(grip.point));
    print.add(grip.along);
  }
  return still ? std::max(print.value(), std::uint64_t{1}) : 0;
}

}  // namespace

/// Whether all of the cords sleep and nothing has come to wake them; or all, and what they lie among, have rested for
/// long enough, so that they do from now on.
bool Island::sleep_on(std::span<const IslandCord> cords) const {
  const auto is_asleep = [](const IslandCord& cord) { return cord.cord->asleep_; };
  const auto may_sleep = [](const IslandCord& cord) { return cord.cord->rest_time_ >= Cord::time_to_sleep; };
  if (!std::all_of(cords.begin(), cords.end(), may_sleep)) return wake(cords);
  const bool asleep = std::all_of(cords.begin(), cords.end(), is_asleep);
  for (const IslandCord& cord : cords) {
    if (stillness(cord.met, rigid_, gravity_, asleep) != cord.cord->rest_surroundings_hash_) return wake(cords);
  }
  // What nothing pushes is other islands' as well.
  const auto rest = [this](int body) {
    if (rigid_[at(body)].inverse_mass > 0.0) rigid_[at(body)].rests = true;
  };
  for (const IslandCord& cord : cords) {
    cord.cord->fall_asleep();
    for (const RigidCircle& circle : cord.met.circles) rest(circle.body);
    for (const RigidSegment& segment : cord.met.segments) rest(segment.body);
    for (const Grip& grip : cord.met.grips) rest(grip.body);
  }
  return true;
}

/// False.
bool Island::wake(std::span<const IslandCord> cords) {
  for (const IslandCord& cord : cords) {
    if (cord.cord->asleep_) cord.cord->wake();
  }
  return false;
}

/// For how long each cord has rested by now.
void Island::count_rest(double dt, const CordReport& report) {
  for (const Member& member : members_) {
    Cord& cord = *member.cord;
    if (!cord.def_.allow_sleep) continue;
    const std::uint64_t among = stillness(member.met, rigid_, gravity_, false);
    const bool rests = among != 0 && among == cord.rest_surroundings_hash_ && report.unconverged == 0 &&
                       report.unlocked == 0 && !cord.is_reeling() &&
                       std::all_of(cord.velocities_.begin(), cord.velocities_.end(), is_slow);
    cord.rest_time_ = rests ? std::min(cord.rest_time_ + dt, Cord::time_to_sleep) : 0.0;
    cord.rest_surroundings_hash_ = among;
  }
}

}  // namespace ribbon
