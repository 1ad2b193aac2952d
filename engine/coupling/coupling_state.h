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

/// Contact of a cord with a fixture.
struct FixtureTouch {
  std::uint64_t fixture = 0;  ///< number of the fixture
  double impulse = 0.0;       ///< N·s, normal impulse in the tick
  double most = 0.0;          ///< N·s, largest impulse at one contact point
  ribbon::Vec2 point;         ///< m, that contact point
  ribbon::Vec2 normal;  ///< unit vector, from the cord's link to the fixture, or from the edge to the cord's point

  bool operator==(const FixtureTouch&) const = default;
};

/// State of a grip, except its body.
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

/// State of a body whose motion the solver determines.
struct LedMemory {
  static constexpr double most_ahead = 1e9;  ///< m/s or rad/s, upper bound

  ribbon::Vec2 ahead;          ///< m/s, momentary velocity minus Box2D's
  double ahead_turning = 0.0;  ///< rad/s, the same for the angular velocity
  ribbon::Vec2 position;       ///< m, computed position of the centre of mass
  ribbon::Vec2 velocity;       ///< m/s, which Box2D leaves it with if it meets nothing
  double turning = 0.0;        ///< rad/s, the same of the rotation
  ribbon::Vec2 start;          ///< m, of the centre of mass, from where,
  double dt = 0.0;             ///< s, and in what time
  ribbon::Vec2 pushed;         ///< m/s, by which it was more, in the tick before this one
  ribbon::Vec2 expected_push;  ///< m/s, by which it was taken to be more, in the last

  bool operator==(const LedMemory&) const = default;
};

/// State of a coupling between two ticks: everything that later ticks depend on, except the definitions of the cords
/// and the world, and the results of the last tick. Bodies and fixtures are identified by the order of their creation
/// among those that exist, from 0.
struct CouplingState {
  /// State of a cord.
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
  /// A grip and its body.
  struct Grip {
    int body = 0;       ///< by place
    GripMemory memory;  ///< all else
    bool operator==(const Grip&) const = default;
  };
  /// A body whose motion the solver determined.
  struct Led {
    int body = 0;      ///< by place
    LedMemory memory;  ///< how they moved it
    bool operator==(const Led&) const = default;
  };
  /// A fixture and its number.
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

/// Adds all values of a state to a hash.
void add_to(Hasher& hasher, const CouplingState& state);
/// Adds all values of a cord's state to a hash.
void add_to(Hasher& hasher, const ribbon::ThesisCord::State& state);
/// Adds all values of a cord's state to a hash.
void add_to(Hasher& hasher, const ribbon::Cord::State& state);

}  // namespace engine
