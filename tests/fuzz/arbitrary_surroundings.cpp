#include "tests/fuzz/arbitrary_surroundings.h"

#include <cmath>
#include <cstdint>
#include <numbers>

namespace fuzz {
namespace {

ribbon::RigidBody arbitrary_body(Bytes& bytes) {
  ribbon::RigidBody body;
  body.position = bytes.vector(-2.0, 2.0);
  body.velocity = bytes.vector(-10.0, 10.0);
  if (bytes.boolean()) return body;  // kinematic
  body.angular_velocity = bytes.number(-10.0, 10.0);
  body.inverse_mass = bytes.number(1e-4, 1e4);
  if (bytes.boolean()) body.inverse_inertia = bytes.number(1e-4, 1e4);
  body.acceleration = bytes.vector(-10.0, 10.0);
  return body;
}

}  // namespace

ArbitrarySurroundings::ArbitrarySurroundings(Bytes& bytes, int points) {
  for (int k = bytes.below(4); k > 0; --k) bodies.push_back(arbitrary_body(bytes));
  const int last = static_cast<int>(bodies.size()) - 1;
  if (last < 0) return;
  std::uint64_t id = 1;
  for (int k = bytes.below(4); k > 0; --k) {
    circles.push_back({bytes.integer(0, last), bytes.vector(-1.0, 1.0), bytes.number(0.01, 1.0),
                       bytes.number(0.0, 10.0), bytes.number(0.0, 1.0), ++id});
  }
  for (int k = bytes.below(4); k > 0; --k) {
    segments.push_back({bytes.integer(0, last), bytes.vector(-1.0, 1.0), bytes.vector(-1.0, 1.0),
                        bytes.number(0.0, 0.1), bytes.number(0.0, 10.0), bytes.number(0.0, 1.0), ++id});
  }
  for (int k = bytes.below(4); k > 0; --k) {
    ribbon::Grip grip{bytes.integer(0, points - 1), bytes.integer(0, last), bytes.vector(-1.0, 1.0)};
    if (bytes.boolean()) grip.travel = bytes.vector(-0.1, 0.1);
    if (bytes.boolean()) grip.along = bytes.number(0.0, 1.0);
    if (bytes.boolean()) grip.climb = bytes.number(-0.1, 0.1);
    if (bytes.boolean()) grip.strength = bytes.number(1e-3, 1e6);
    grips.push_back(grip);
  }
  if (bytes.below(4) == 0) {
    const double belt = bytes.number(-10.0, 10.0);
    for (ribbon::RigidCircle& circle : circles) circle.tangent_speed = belt;
    for (ribbon::RigidSegment& segment : segments) segment.tangent_speed = -belt;
  }
  for (int k = bytes.below(4); k > 0; --k) {
    const double angle = bytes.number(0.0, 2.0 * std::numbers::pi);
    supports.push_back({bytes.integer(0, last),
                        bytes.vector(-1.0, 1.0),
                        {std::cos(angle), std::sin(angle)},
                        bytes.boolean() ? bytes.number(0.0, 0.1) : 0.0,
                        bytes.boolean() ? bytes.number(-2.0, 2.0) : 0.0});
  }
}

}  // namespace fuzz
