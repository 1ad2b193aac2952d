#pragma once

#include <box2d/b2_fixture.h>
#include <box2d/b2_math.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <variant>
#include <vector>

#include "ribbon/box2d/coupling_types.h"
#include "ribbon/cord.h"
#include "ribbon/thesis/thesis_cord.h"
#include "ribbon/vec2.h"

namespace ribbon::box2d {

class Hasher;

/// Contact of a cord with a fixture.
struct FixtureTouch {
  std::uint64_t fixture = 0;  ///< number of the fixture
  double impulse = 0.0;       ///< N·s, normal impulse in the tick
  double most = 0.0;          ///< N·s, largest impulse at one contact point
  Vec2 point;                 ///< m, that contact point
  Vec2 normal;  ///< unit vector, from the cord's link to the fixture, or from the edge to the cord's point

  bool operator==(const FixtureTouch&) const = default;
};

/// State of a grip, except its body.
struct GripMemory {
  GripId id = 0;                    ///< its id
  CordId cord = 0;                  ///< the cord
  int point = 0;                    ///< index of the held point, or of the one before the place
  b2Vec2 local_anchor{0.0F, 0.0F};  ///< m, anchor at the start of the tick
  b2Vec2 next_anchor{0.0F, 0.0F};   ///< m, anchor at the end of the tick
  double along = 0.0;               ///< position between the point and that of the next column, 0 … below 1
  double strength = std::numeric_limits<double>::infinity();   ///< N, force along the cord above which it slips
  bool lets_go = false;                                        ///< it is released instead of slipping
  double most_pull = std::numeric_limits<double>::infinity();  ///< N, force above which it is released
  double climb_to = -1.0;                                      ///< columns, goal of the climb; −1 for none
  double climb_speed = 0.0;                                    ///< columns per second
  Vec2 pull{};                                                 ///< N, force on the body in the last tick
  bool slips = false;                                          ///< it slipped in the last tick
  bool blocked = false;  ///< the body is beside the cord, because Box2D pushed it or it slipped, and is on its way back

  bool operator==(const GripMemory&) const = default;
};

/// A point of a cord that is tied.
struct TiePlace {
  CordId cord = 0;  ///< the cord
  int point = 0;    ///< index of the point

  bool operator==(const TiePlace&) const = default;
};

/// A tie of two cords.
struct TieMemory {
  TieId id = 0;                                                     ///< its id
  TiePlace place;                                                   ///< the first cord
  TiePlace other;                                                   ///< the other one
  double breaking_force = std::numeric_limits<double>::infinity();  ///< N, see TieDef

  bool operator==(const TieMemory&) const = default;
};

/// A pulley, except its body.
struct PulleyMemory {
  PulleyId id = 0;                  ///< its id
  CordId cord = 0;                  ///< the cord
  int index = 0;                    ///< index into the pulleys of the cord
  b2Vec2 local_anchor{0.0F, 0.0F};  ///< m, of the axle, in the frame of the body

  bool operator==(const PulleyMemory&) const = default;
};

/// What is carried from tick to tick for a body that the direct solver moves: see VelocityCarry.
struct CarryState {
  static constexpr double max_carry = 1e9;  ///< m/s or rad/s, limit of the carry

  Vec2 carry;                     ///< m/s, momentary velocity minus Box2D's
  double angular_carry = 0.0;     ///< rad/s, the same for the angular velocity
  Vec2 position;                  ///< m, computed position of the centre of mass
  Vec2 velocity;                  ///< m/s, after a world.Step in which its supports alone push it
  double angular_velocity = 0.0;  ///< rad/s, the same for the rotation
  Vec2 start;                     ///< m, position before the world.Step
  Vec2 start_velocity;            ///< m/s, momentary velocity before that step
  double dt = 0.0;                ///< s, duration of that step
  Vec2 contact_delta_v;           ///< m/s, steady part of Box2D's push in the step before the last
  Vec2 expected_delta_v;          ///< m/s, change of velocity that the solver expected in the last step
  Vec2 support_delta_v;           ///< m/s, by the forces of its supports at the end of that step

  bool operator==(const CarryState&) const = default;
};

/// What a cord of the direct solver was added with. Coupling::restore uses it to add a cord that is gone again.
struct CordOrigin {
  std::shared_ptr<const CordDef> def;  ///< its definition; null for the thesis's solver
  b2Filter filter;                     ///< its filter
  std::uintptr_t user_data = 0;        ///< see CordView; not compared, because it may be a pointer

  /// Returns whether definitions and filters are the same.
  bool operator==(const CordOrigin& other) const;
};

/// A contact of a removed cord, which ends in the next step.
struct EndingTouch {
  CordId cord = 0;     ///< id that the cord had
  FixtureTouch touch;  ///< the contact

  bool operator==(const EndingTouch&) const = default;
};

/// A SensorEvent of the last tick, or the overlap of a removed cord with a sensor, which ends in the next step.
struct SensorMemory {
  CordId cord = 0;            ///< the cord
  bool begins = false;        ///< the overlap began; else it ended
  std::uint64_t fixture = 0;  ///< number of the sensor; 0 if it was destroyed

  bool operator==(const SensorMemory&) const = default;
};

/// State of a coupling between two ticks: everything that later ticks depend on, except the world, and the results of
/// the last tick. Bodies and fixtures are identified by the order of their creation among those that exist, from 0.
struct CouplingState {
  /// State of a cord.
  struct Cord {
    CordId id = 0;                                               ///< its id
    std::variant<ThesisCord::State, ribbon::Cord::State> state;  ///< of its solver
    bool enabled = true;                                         ///< see CordView
    IslandReport island_report;                                  ///< see CordView
    IslandReport island_total;                                   ///< see CordView
    double error = 0.0;                                          ///< m, see CordView
    StepReport thesis_report;                                    ///< see CordView
    StepReport thesis_total;                                     ///< see CordView
    std::vector<FixtureTouch> touching;                          ///< by fixture number, in the last tick
    CordOrigin origin;                                           ///< what it was added with
    std::vector<std::uint64_t> sensing;                          ///< numbers of the sensors that it overlapped
    bool operator==(const Cord&) const = default;
  };
  /// A grip and its body.
  struct Grip {
    int body = 0;       ///< place of the body
    GripMemory memory;  ///< the rest
    bool operator==(const Grip&) const = default;
  };
  /// A pulley and its body.
  struct Pulley {
    int body = 0;         ///< place of the body
    PulleyMemory memory;  ///< the rest
    bool operator==(const Pulley&) const = default;
  };
  /// A body that the direct solver moved.
  struct Carry {
    int body = 0;       ///< place of the body
    CarryState memory;  ///< the rest
    bool operator==(const Carry&) const = default;
  };
  /// A fixture and its number.
  struct Fixture {
    int body = 0;          ///< place of the body
    int place = 0;         ///< place among the fixtures of the body
    std::uint64_t id = 0;  ///< number of the fixture
    bool seen = false;     ///< it was near a cord in the last tick
    bool operator==(const Fixture&) const = default;
  };
  /// A TouchEvent of the last tick.
  struct Event {
    CordId cord = 0;            ///< the cord
    bool begins = false;        ///< contact began; else it ended
    std::uint64_t fixture = 0;  ///< number of the fixture; 0 if it was destroyed
    double impulse = 0.0;       ///< N·s, normal impulse
    Vec2 point;                 ///< m, where the impulse is largest
    Vec2 normal;                ///< unit vector; see TouchEvent
    bool operator==(const Event&) const = default;
  };

  int bodies = 0;                            ///< number of bodies of the world
  CordId next_cord = 0;                      ///< id of the next cord
  std::vector<Cord> cords;                   ///< by id
  std::vector<Grip> grips;                   ///< by id
  GripId next_grip = 1;                      ///< id of the next grip
  std::vector<TieMemory> ties;               ///< by id
  TieId next_tie = 1;                        ///< id of the next tie
  std::vector<Pulley> pulleys;               ///< by id
  PulleyId next_pulley = 1;                  ///< id of the next pulley
  std::vector<Carry> carries;                ///< by body
  std::vector<Fixture> fixtures;             ///< by number
  std::uint64_t next_fixture = 1;            ///< number of the next fixture
  std::vector<Event> events;                 ///< of the last tick, by cord and fixture
  std::vector<EndingTouch> ending;           ///< contacts of cords that are gone, by cord and fixture
  std::vector<CutEvent> cuts;                ///< see StepView::cut_events
  std::size_t old_cuts = 0;                  ///< how many of them are of the last tick
  std::vector<SensorMemory> sensor_events;   ///< of the last tick, by cord and fixture
  std::vector<SensorMemory> ending_sensors;  ///< overlaps of cords that are gone, by cord and fixture
  double medium_time = 0.0;                  ///< s, see StepView::medium_time

  bool operator==(const CouplingState&) const = default;
};

/// Adds all values of a state to a hash.
void add_to(Hasher& hasher, const CouplingState& state);
/// Adds all values of a cord's state to a hash.
void add_to(Hasher& hasher, const ThesisCord::State& state);
/// Adds all values of a cord's state to a hash.
void add_to(Hasher& hasher, const ribbon::Cord::State& state);

}  // namespace ribbon::box2d
