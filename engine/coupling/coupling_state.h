#pragma once

#include <box2d/b2_math.h>

#include <cstdint>
#include <limits>
#include <variant>
#include <vector>

#include "ribbon/cord.h"
#include "ribbon/thesis/thesis_cord.h"
#include "ribbon/vec2.h"

namespace engine {

class Hasher;

/// What a cord remembers of a fixture that touches it.
struct FixtureTouch {
  std::uint64_t fixture = 0;  ///< its number: FixtureIds
  double impulse = 0.0;       ///< N·s, in the tick, normal
  double most = 0.0;          ///< N·s, of one contact
  ribbon::Vec2 point;         ///< m, where that is
  ribbon::Vec2 normal;        ///< away from the cord's link, or from the edge to its point

  bool operator==(const FixtureTouch&) const = default;
};

/// What is remembered of a grip, but for its body.
struct GripMemory {
  int id = 0;                                                  ///< the grip's number
  int cord = 0;                                                ///< which one it holds
  int point = 0;                                               ///< of it, by index
  b2Vec2 local_hand{0.0F, 0.0F};                               ///< at the start of the tick
  b2Vec2 next_hand{0.0F, 0.0F};                                ///< and at its end
  double along = 0.0;                                          ///< share of the way to the next column's point
  double strength = std::numeric_limits<double>::infinity();   ///< N, along the cord, above which it slips
  bool lets_go = false;                                        ///< in place of slipping
  double most_pull = std::numeric_limits<double>::infinity();  ///< N, above which it does
  double climb_to = -1.0;                                      ///< columns, where it is climbing, or nowhere
  double climb_speed = 0.0;                                    ///< columns a second
  ribbon::Vec2 pull{};                                         ///< N, on the body in the last tick
  bool slips = false;                                          ///< in the last tick
  bool held_up = false;  ///< Box2D has kept the body from where its cord led it, and the hand is not back there yet

  bool operator==(const GripMemory&) const = default;
};

/// What is remembered of a body that cords move on a curve.
struct LedMemory {
  static constexpr double most_ahead = 1e9;  ///< m/s or rad/s, as of a body that a cord can meet

  ribbon::Vec2 ahead;          ///< m/s, the momentary velocity less Box2D's
  double ahead_turning = 0.0;  ///< rad/s, the same of the rotation
  ribbon::Vec2 position;       ///< m, of the centre of mass, where it was led to
  ribbon::Vec2 velocity;       ///< m/s, which Box2D leaves it with if it meets nothing
  double turning = 0.0;        ///< rad/s, the same of the rotation
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
  /// A cord, and what the coupling knows of it.
  struct Cord {
    std::variant<ribbon::ThesisCord::State, ribbon::Cord::State> state;  ///< of its solver
    bool enabled = true;                                                 ///< or switched off
    ribbon::CordReport direct_report;    ///< of the last step, of one of the direct solver
    ribbon::CordReport direct_total;     ///< and since it was added
    double direct_error = 0.0;           ///< m
    ribbon::StepReport report;           ///< of the last step, of one of the thesis's
    ribbon::StepReport total;            ///< and since it was added
    std::vector<FixtureTouch> touching;  ///< by fixture, in the last tick
    bool operator==(const Cord&) const = default;
  };
  /// A grip, and whose.
  struct Grip {
    int body = 0;       ///< by place
    GripMemory memory;  ///< all else
    bool operator==(const Grip&) const = default;
  };
  /// A body that cords moved.
  struct Led {
    int body = 0;      ///< by place
    LedMemory memory;  ///< how they moved it
    bool operator==(const Led&) const = default;
  };
  /// A fixture that has a number.
  struct Fixture {
    int body = 0;          ///< by place
    int place = 0;         ///< among the body's
    std::uint64_t id = 0;  ///< its number
    bool seen = false;     ///< in the last tick
    bool operator==(const Fixture&) const = default;
  };
  /// A TouchEvent of the last tick.
  struct Event {
    int cord = 0;               ///< which one
    bool begins = false;        ///< or ceased
    std::uint64_t fixture = 0;  ///< its number, 0 for one that is no more
    double impulse = 0.0;       ///< N·s, normal
    ribbon::Vec2 point;         ///< m, where most of it is
    ribbon::Vec2 normal;        ///< away from the cord's link, or from the edge to its point
    bool operator==(const Event&) const = default;
  };

  int bodies = 0;                  ///< of the world
  std::vector<Cord> cords;         ///< in the order of adding
  std::vector<Grip> grips;         ///< in the order in which they were taken
  int next_grip = 1;               ///< the number that the next grip gets
  std::vector<Led> led;            ///< by body
  std::vector<Fixture> fixtures;   ///< by number
  std::uint64_t next_fixture = 1;  ///< the number that the next one gets
  std::vector<Event> events;       ///< of the last tick, by cord and fixture

  bool operator==(const CouplingState&) const = default;
};

/// Adds every number of the state, so that two that differ in a bit have different hashes.
void add_to(Hasher& hasher, const CouplingState& state);
/// A cord's part of it.
void add_to(Hasher& hasher, const ribbon::ThesisCord::State& state);
/// The same of one of the direct solver.
void add_to(Hasher& hasher, const ribbon::Cord::State& state);

}  // namespace engine
