#pragma once

#include <box2d/b2_fixture.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>

#include "ribbon/pulley.h"
#include "ribbon/vec2.h"

// Parameters and results of Coupling.

namespace ribbon::box2d {

/// Id of a cord in its coupling: 0, 1, 2 … in the order of adding. Ids are never reused, except that Coupling::restore
/// goes back to the next id of the state.
using CordId = int;

/// The two solvers.
enum class Solver : unsigned char {
  thesis,  ///< ribbon::ThesisCord
  direct,  ///< ribbon::Cord
};
/// Returns "thesis" or "direct".
std::string_view solver_name(Solver solver);

/// Layout of the points of a cord, for both solvers: point (i, j) has index i·rows + j.
struct CordShape {
  int columns = 0;         ///< number of points along the cord
  int rows = 0;            ///< number of points across it
  double thickness = 0.0;  ///< m, rest thickness for drawing
  bool braced = false;     ///< diagonal neighbours are connected by bars too
};

/// A place on a cord.
struct CordPoint {
  CordId cord = 0;        ///< the cord
  int point = 0;          ///< index of the point
  double distance = 0.0;  ///< m, from the position of the query
  double along = 0.0;     ///< position between this point and the one in the next column, 0 … below 1
};

/// Id of a grip in its coupling: 1, 2, 3 … Ids are never reused, except as those of cords.
using GripId = int;

/// Defines how a body holds a cord.
struct GripDef {
  CordId cord = 0;                  ///< the cord
  double arc = 0.0;                 ///< m of rest length from the first point, 0 … length of the cord
  int row = 0;                      ///< row of a ribbon
  b2Vec2 local_anchor{0.0F, 0.0F};  ///< m, anchor in the body's frame
  /// N, force along the cord above which the grip slips. It stops at an end that is pinned or that another grip holds
  /// without slipping, and is released where it slips off any other end. Infinite for the thesis's solver.
  double strength = std::numeric_limits<double>::infinity();
  bool lets_go = false;  ///< the grip is released above its strength, in any direction, instead of slipping
  /// Index of a point to hold, in place of `arc` and `row`. A cord of the thesis's solver is held at points only.
  std::optional<int> point{};
};

/// State of a grip.
struct GripState {
  CordId cord = 0;   ///< the cord
  double arc = 0.0;  ///< m of rest length from the first point
  Vec2 place;        ///< m, position on the cord
  /// N, force of the cord on the body in the last tick. Static and kinematic bodies that hold the same point share the
  /// force equally. It is 0 if a pin holds the point too, and for a cord of the thesis's solver. Of a body that is not
  /// dynamic it is 0 after restore, until the next tick.
  Vec2 pull;
  bool slips = false;  ///< the grip slipped in the last tick
  int point = 0;       ///< index of the point that it holds, or of the one before its place
  double along = 0.0;  ///< position between this point and the one in the next column, 0 … below 1
};

/// Id of a tie in its coupling: 1, 2, 3 … Ids are never reused, except as those of cords.
using TieId = int;

/// Defines a tie: a point of a cord and one of another cord, which move as one.
struct TieDef {
  CordId cord = 0;        ///< a cord of the direct solver
  int point = 0;          ///< index of its point
  CordId other_cord = 0;  ///< another one
  int other_point = 0;    ///< index of its point
  /// N, above 0: force between the two cords above which the tie comes undone. In a tick a tie comes undone only if no
  /// other tie of the same cords is overloaded by a larger factor.
  double breaking_force = std::numeric_limits<double>::infinity();
};

/// State of a tie.
struct TieState {
  CordId cord = 0;        ///< the first cord; after a cut, the piece with the point
  int point = 0;          ///< index of its point
  CordId other_cord = 0;  ///< the other cord
  int other_point = 0;    ///< index of its point
  Vec2 place;             ///< m, position of the first cord's point
  double gap = 0.0;       ///< m, distance of the two points: 0, unless they were tied while apart and have not met yet
  /// N, force of the other cord on the first one in the last tick, without contacts at the points. It is 0 if both
  /// points are pinned or held by bodies too. If the point has other ties, it is the force of the other cord on all
  /// cords that are tied there. After restore it is right from the next tick on.
  Vec2 pull;
};

/// Id of a pulley in its coupling: 1, 2, 3 … Ids are never reused, except as those of cords.
using PulleyId = int;

/// State of a pulley.
struct PulleyState {
  CordId cord = 0;       ///< the cord; after a cut, the piece that runs around the wheel
  Vec2 center;           ///< m, of the wheel
  double angle = 0.0;    ///< rad, by which the wheel has turned in the frame of its body's centre, counterclockwise
  double turning = 0.0;  ///< rad/s, of the wheel
  double speed = 0.0;    ///< m/s, of the cord in the groove, towards its last point
  double arc = 0.0;      ///< rad, angle of contact
  double tension_before = 0.0;  ///< N, of the cord before the wheel
  double tension_after = 0.0;   ///< N, of the cord behind it
  bool slips = false;           ///< the cord slipped in the last tick
  PulleyDef def;                ///< as it was defined, with the points that are before and behind the wheel now
};

/// A cut through a cord. Its pieces are new cords with ids of their own, and the id of the cord is gone.
struct CutEvent {
  CordId cord = 0;                 ///< the cord that was cut
  double arc = 0.0;                ///< m of rest length from its first point; 0 for a cut along a row
  std::optional<CordId> first{};   ///< piece from its first point on; nothing if less than two columns were left
  std::optional<CordId> second{};  ///< piece up to its last point; the same
  bool broke = false;              ///< a link broke under its tension; else the cord was cut by a call
  double tension = 0.0;            ///< N, of the link that broke; 0 otherwise
  int row = 0;                     ///< of a ribbon, along which it was cut; 0 for a cut across

  bool operator==(const CutEvent&) const = default;
};

/// A part of a fixture that a cord may touch: one edge of a chain, or the whole of any other shape.
struct NearShape {
  b2Fixture* fixture;        ///< belongs to an enabled body
  int child;                 ///< index of the child shape
  double travel;             ///< m, upper bound of its displacement in the tick
  std::uint64_t number = 0;  ///< number of the fixture
};

/// The begin or end of contact between a cord and a fixture in the last tick.
struct TouchEvent {
  CordId cord = 0;      ///< the cord
  bool begins = false;  ///< contact began; else it ended
  /// The fixture, or null if it was destroyed before the last gather or with Coupling::destroy. If it may have been
  /// destroyed otherwise since then, use Coupling::fixture with its number and world.
  const b2Fixture* fixture = nullptr;
  double impulse = 0.0;      ///< N·s, normal impulse in the tick
  Vec2 point;                ///< m, where the impulse is largest
  Vec2 normal;               ///< unit vector, from the cord's link to the fixture, or from the edge to the cord's point
  std::uint64_t number = 0;  ///< number of the fixture; 0 if it is null
};

/// What a cord gave to a fixture at one contact point in a tick.
struct TouchImpulse {
  Vec2 point;                    ///< m, contact point
  Vec2 normal;                   ///< unit vector, from the cord to the fixture
  double normal_impulse = 0.0;   ///< N·s, part of `impulse` along the normal
  double tangent_impulse = 0.0;  ///< N·s, part along the normal turned by 90° counter-clockwise: friction
  Vec2 impulse;                  ///< N·s, whole impulse on the fixture's body, with friction and restitution
};

/// The begin or end of an overlap between a cord and a sensor in the last tick.
struct SensorEvent {
  CordId cord = 0;                     ///< the cord
  bool begins = false;                 ///< the overlap began; else it ended
  const b2Fixture* fixture = nullptr;  ///< the sensor, or null; see TouchEvent
  std::uint64_t number = 0;            ///< number of the fixture; 0 if it is null
};

}  // namespace ribbon::box2d
