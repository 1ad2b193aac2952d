#include "ribbon/island/sleep.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <numbers>

#include "ribbon/linear/index.h"
#include "ribbon/medium.h"

namespace ribbon {
namespace {

// A body of Box2D that is slower than both falls asleep: b2_linearSleepTolerance and b2_angularSleepTolerance.
constexpr double sleep_speed = 0.01;                              // m/s
constexpr double sleep_turning = 2.0 / 180.0 * std::numbers::pi;  // rad/s

/// Hashes surroundings, by each of their bits.
class SurroundingsHash {
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

bool is_slow(Vec2 velocity) { return dot(velocity, velocity) < sleep_speed * sleep_speed; }

/// A body that can be pushed does not keep a cord awake if it sleeps, or falls asleep with it.
bool is_at_rest(const RigidBody& body, bool asleep) {
  if (body.inverse_mass == 0.0) return body.velocity == Vec2{} && body.angular_velocity == 0.0;
  if (asleep) return !body.awake;
  return body.may_sleep && is_slow(body.velocity) && std::abs(body.angular_velocity) < sleep_turning;
}

/// Adds what a medium is near the points of a cord: a cord sleeps in a wind that does not change. It is read at places
/// of a grid, so that a cord that still creeps to rest does not change the hash.
void add_medium(SurroundingsHash& hash, const CordParts& cord, const Surroundings& surroundings) {
  if (surroundings.medium == nullptr || !feels_medium(cord.def)) return;
  const double cell = cord.def.length / (cord.def.points - 1);
  for (const Vec2 x : cord.state.positions) {
    const Vec2 place{cell * std::floor(x.x / cell), cell * std::floor(x.y / cell)};
    const MediumSample sample = surroundings.medium->at(place, cell, surroundings.time);
    hash.add(sample.velocity);
    hash.add(sample.density);
  }
}

/// Returns a hash of the surroundings of a cord at rest, 0 if some of them move: where everything is, except for bodies
/// that still creep to rest. Around a cord that is asleep nothing creeps.
std::uint64_t hash_at_rest(const CordParts& cord, const Surroundings& surroundings, std::span<const RigidBody> bodies,
                           Vec2 gravity, bool asleep) {
  SurroundingsHash hash;
  hash.add(gravity);
  add_medium(hash, cord, surroundings);
  bool at_rest = true;
  const auto add_places = [&](int index, std::initializer_list<Vec2> places) {
    const RigidBody& body = bodies[static_cast<std::size_t>(index)];
    at_rest = at_rest && is_at_rest(body, asleep);
    if (body.inverse_mass > 0.0) return;
    hash.add(body.position);
    for (const Vec2 place : places) hash.add(place);
  };
  for (const RigidCircle& circle : surroundings.circles) {
    add_places(circle.body, {circle.offset});
    hash.add(circle.id);
    for (const double number : {circle.radius, circle.friction, circle.restitution}) hash.add(number);
    at_rest = at_rest && circle.tangent_speed == 0.0;
  }
  for (const RigidSegment& segment : surroundings.segments) {
    add_places(segment.body, {segment.a, segment.b});
    hash.add(segment.id);
    for (const double number : {segment.radius, segment.friction, segment.restitution}) hash.add(number);
    at_rest = at_rest && segment.tangent_speed == 0.0;
  }
  for (const Grip& grip : surroundings.grips) {
    add_places(grip.body, {grip.offset});
    at_rest = at_rest && grip.travel == Vec2{} && grip.climb == 0.0;
    hash.add(static_cast<std::uint64_t>(grip.point));
    hash.add(grip.along);
  }
  for (const Support& support : surroundings.supports) {
    if (support.other >= 0) at_rest = at_rest && is_at_rest(bodies[at(support.other)], asleep);
  }
  return at_rest ? std::max(hash.value(), std::uint64_t{1}) : 0;
}

void wake(std::span<const IslandCord> cords) {
  for (const IslandCord& cord : cords) {
    if (cord.cord->is_asleep()) cord.cord->wake();
  }
}

bool may_sleep(std::span<const IslandCord> cords, std::span<const RigidBody> bodies, Vec2 gravity) {
  const auto state_of = [](const IslandCord& cord) -> const Cord::State& { return cord.cord->parts().state; };
  for (const IslandCord& cord : cords) {
    if (state_of(cord).rest_time < Cord::time_to_sleep || !state_of(cord).pulleys.empty()) return false;
  }
  const bool asleep =
      std::all_of(cords.begin(), cords.end(), [&](const IslandCord& cord) { return state_of(cord).asleep; });
  return std::all_of(cords.begin(), cords.end(), [&](const IslandCord& cord) {
    return hash_at_rest(cord.cord->parts(), cord.surroundings, bodies, gravity, asleep) ==
           state_of(cord).surroundings_hash;
  });
}

}  // namespace

bool try_sleep(std::span<const IslandCord> cords, std::span<RigidBody> bodies, Vec2 gravity) {
  if (!may_sleep(cords, bodies, gravity)) {
    wake(cords);
    return false;
  }
  // A body that cannot be pushed belongs to other islands as well.
  const auto rest = [&](int index) {
    RigidBody& body = bodies[static_cast<std::size_t>(index)];
    if (body.inverse_mass > 0.0) body.rests = true;
  };
  for (const IslandCord& cord : cords) {
    cord.cord->parts().fall_asleep();
    for (const RigidCircle& circle : cord.surroundings.circles) rest(circle.body);
    for (const RigidSegment& segment : cord.surroundings.segments) rest(segment.body);
    for (const Grip& grip : cord.surroundings.grips) rest(grip.body);
    for (const Support& support : cord.surroundings.supports) {
      if (support.other >= 0) rest(support.other);
    }
  }
  return true;
}

void count_rest_time(const IslandState& state, const IslandReport& report) {
  for (const Member& member : state.members) {
    const CordParts& cord = *member.cord;
    if (!cord.def.allow_sleep) continue;
    Cord::State& of_cord = member.cord->state;
    const std::uint64_t hash = hash_at_rest(cord, member.surroundings, state.rigid, state.gravity, false);
    const bool rests = hash != 0 && hash == of_cord.surroundings_hash && report.unconverged == 0 &&
                       report.unlocked == 0 && !cord.is_reeling() && !state.overstretched &&
                       std::all_of(of_cord.velocities.begin(), of_cord.velocities.end(), is_slow);
    of_cord.rest_time = rests ? std::min(of_cord.rest_time + state.dt, Cord::time_to_sleep) : 0.0;
    of_cord.surroundings_hash = hash;
  }
}

}  // namespace ribbon
