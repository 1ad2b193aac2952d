#pragma once

#include <box2d/b2_math.h>

#include <cstdint>
#include <limits>
#include <variant>
#include <vector>

#include "ribbon/cord.h"
#include "ribbon/thesis_cord.h"
#include "ribbon/vec2.h"

namespace engine {

class Hasher;

/// What a cord remembers of a fixture that touches it.
struct FixtureTouch {
  std::uint64_t fixture = 0;  ///< its number: FixtureIds
  double impulse = 0.0;       ///< N·s, in the tick, normal
  double most = 0.0;          ///< N·s, of one contact
  ribbon::Vec2 point;         ///< m, where that is
  ribbon::Vec2 normal;

  bool operator==(const FixtureTouch&) const = default;
};

/// What is remembered of a grip, but for its body.
struct GripMemory {
  int id = 0;
  int cord = 0;
  int point = 0;
  b2Vec2 local_hand{0.0F, 0.0F};  ///< at the start of the tick
  b2Vec2 next_hand{0.0F, 0.0F};   ///< and at its end
  double along = 0.0;             ///< share of the way to the next column's point
  double strength = std::numeric_limits<double>::infinity();
  bool lets_go = false;
  double most_pull = std::numeric_limits<double>::infinity();  ///< N, above which it does
  double climb_to = -1.0;                                      ///< columns, where it is climbing, or nowhere
  double climb_speed = 0.0;                                    ///< columns a second
  ribbon::Vec2 pull{};
  bool slips = false;

  bool operator==(const GripMemory&) const = default;
};

/// What is remembered of a body that cords move on a curve.
struct LedMemory {
  ribbon::Vec2 ahead;          ///< m/s, the momentary velocity less Box2D's
  double ahead_turning = 0.0;  ///< rad/s, the same of the rotation
  ribbon::Vec2 position;       ///< m, of the centre of mass, where it was led to
  ribbon::Vec2 velocity;       ///< m/s, which Box2D leaves it with if it meets nothing
  ribbon::Vec2 start;          ///< m, of the centre of mass, from where,
  double dt = 0.0;             ///< s, and in what time
  ribbon::Vec2 pushed;         ///< m/s, by which it was more, in the tick before this one
  ribbon::Vec2 expected_push;  ///< m/s, by which it was taken to be more, in the last

  bool operator==(const LedMemory&) const = default;
};

/// A coupling between two ticks: all that a later tick of it depends on but for the definitions of its cords and the
/// world, and all that it tells of the last one. Bodies and fixtures are named by their place: the n-th that was made
/// of those that are there, from 0, of its world or its body.
struct CouplingState {
  struct Cord {
    std::variant<ribbon::ThesisCord::State, ribbon::Cord::State> state;
    ribbon::CordReport direct_report;
    ribbon::CordReport direct_total;
    double direct_error = 0.0;  ///< m
    ribbon::StepReport report;
    ribbon::StepReport total;
    std::vector<FixtureTouch> touching;  ///< by fixture, in the last tick
    bool operator==(const Cord&) const = default;
  };
  struct Grip {
    int body = 0;
    GripMemory memory;
    bool operator==(const Grip&) const = default;
  };
  struct Led {
    int body = 0;
    LedMemory memory;
    bool operator==(const Led&) const = default;
  };
  struct Fixture {
    int body = 0;
    int place = 0;  ///< among the body's
    std::uint64_t id = 0;
    bool seen = false;  ///< in the last tick
    bool operator==(const Fixture&) const = default;
  };
  struct Event {
    int cord = 0;
    bool begins = false;
    std::uint64_t fixture = 0;  ///< its number, 0 for one that is no more
    double impulse = 0.0;
    ribbon::Vec2 point;
    ribbon::Vec2 normal;
    bool operator==(const Event&) const = default;
  };

  int bodies = 0;  ///< of the world
  std::vector<Cord> cords;
  std::vector<Grip> grips;  ///< in the order in which they were taken
  int next_grip = 1;
  std::vector<Led> led;           ///< by body
  std::vector<Fixture> fixtures;  ///< by number
  std::uint64_t next_fixture = 1;
  std::vector<Event> events;

  bool operator==(const CouplingState&) const = default;
};

/// Adds every number of the state, so that two that differ in a bit have different hashes.
void add_to(Hasher& hasher, const CouplingState& state);
/// A cord's part of it.
void add_to(Hasher& hasher, const ribbon::ThesisCord::State& state);
void add_to(Hasher& hasher, const ribbon::Cord::State& state);

}  // namespace engine
