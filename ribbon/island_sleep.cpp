#include <algorithm>
#include <bit>
#include <cstdint>
#include <initializer_list>

#include "ribbon/island.h"

// Cords at rest among what does not move are not stepped: CordDef::allow_sleep.

namespace ribbon {
namespace {

constexpr double restful_speed = 0.01;  // m/s, as b2_linearSleepTolerance

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

/// What a cord at rest lies among; 0 if some of it moves, or can be pushed.
std::uint64_t stillness(const Surroundings& met, std::span<const RigidBody> bodies, Vec2 gravity) {
  Fingerprint print;
  print.add(gravity);
  bool still = true;
  const auto add_body = [&](int index) {
    const RigidBody& body = bodies[static_cast<std::size_t>(index)];
    still = still && body.inverse_mass == 0.0 && body.velocity == Vec2{} && body.angular_velocity == 0.0;
    print.add(body.position);
  };
  for (const RigidCircle& circle : met.circles) {
    add_body(circle.body);
    print.add(circle.offset);
    for (const double number : {circle.radius, circle.friction, circle.restitution}) print.add(number);
  }
  for (const RigidSegment& segment : met.segments) {
    add_body(segment.body);
    for (const Vec2 v : {segment.a, segment.b}) print.add(v);
    for (const double number : {segment.radius, segment.friction, segment.restitution}) print.add(number);
  }
  for (const Grip& grip : met.grips) {
    add_body(grip.body);
    still = still && grip.travel == Vec2{} && grip.climb == 0.0;
    print.add(static_cast<std::uint64_t>(grip.point));
    print.add(grip.offset);
    print.add(grip.along);
  }
  return still ? std::max(print.value(), std::uint64_t{1}) : 0;
}

}  // namespace

/// Whether all of the cords sleep and nothing has come to wake them.
bool Island::sleep_on(std::span<const IslandCord> cords) const {
  return std::all_of(cords.begin(), cords.end(), [this](const IslandCord& cord) {
    return cord.cord->is_asleep() && cord.cord->still_among_ == stillness(cord.met, rigid_, gravity_);
  });
}

/// For how long each cord has rested by now.
void Island::count_rest(double dt, const CordReport& report) {
  for (const Member& member : members_) {
    Cord& cord = *member.cord;
    if (!cord.def_.allow_sleep) continue;
    const std::uint64_t among = stillness(member.met, rigid_, gravity_);
    const bool rests = among != 0 && among == cord.still_among_ && report.unconverged == 0 && report.unlocked == 0 &&
                       !cord.is_winding() && std::all_of(cord.velocities_.begin(), cord.velocities_.end(), [](Vec2 v) {
                         return dot(v, v) < restful_speed * restful_speed;
                       });
    cord.rested_ = rests ? std::min(cord.rested_ + dt, Cord::time_to_sleep) : 0.0;
    cord.still_among_ = among;
  }
}

}  // namespace ribbon
