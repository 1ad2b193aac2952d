#pragma once

#include <box2d/b2_fixture.h>

#include <cstdint>
#include <limits>
#include <string_view>

#include "ribbon/vec2.h"

// What a Coupling is asked with, and answers with.

namespace engine {

/// A cord's place in its coupling, in the order of adding.
using CordIndex = int;

/// The two ways to move a cord.
enum class Solver : unsigned char {
  thesis,  ///< ribbon::ThesisCord
  direct,  ///< ribbon::Cord
};
/// "thesis" or "direct".
std::string_view solver_name(Solver solver);

/// How the points of a cord lie, whichever solver moves them: point (i, j) has the index i·rows + j.
struct CordShape {
  int columns = 0;         ///< along the cord
  int rows = 0;            ///< across it
  double thickness = 0.0;  ///< m, across it at rest, as it is drawn
  bool braced = false;     ///< bars join neighbours across the corner as well
};

/// A place on a cord.
struct CordPoint {
  CordIndex cord = 0;     ///< which one
  int point = 0;          ///< its point, by index
  double distance = 0.0;  ///< m, from where it was looked for
  double along = 0.0;     ///< share of the way from there to the point of the next column, below 1
};

/// A grip's number, never used twice.
using GripId = int;

/// How a body holds a cord of the direct solver.
struct GripDef {
  CordIndex cord = 0;             ///< which one
  double arc = 0.0;               ///< m at rest along the cord from its first point, 0 … its length
  int row = 0;                    ///< of a ribbon
  b2Vec2 local_hand{0.0F, 0.0F};  ///< in the body's own frame
  /// N, along the cord, above which the grip slips; of a body that is pushed.
  double strength = std::numeric_limits<double>::infinity();
  bool lets_go = false;  ///< above its strength, in any direction, it lets go instead
};

/// What has become of a grip.
struct GripState {
  CordIndex cord = 0;  ///< which one
  double arc = 0.0;    ///< m at rest along the cord
  ribbon::Vec2 place;  ///< m, of the cord there
  ribbon::Vec2 pull;   ///< N, on the body in the last tick; of one that is pushed
  bool slips = false;  ///< in the last tick
};

/// A cord and a fixture that began or ceased to touch in the last tick.
struct TouchEvent {
  CordIndex cord = 0;   ///< which one
  bool begins = false;  ///< or ceased
  /// Null if it was destroyed before the last gather, or since by Coupling::destroy. Destroyed otherwise since, it
  /// dangles: Coupling::fixture finds it by number in its world, or not.
  const b2Fixture* fixture = nullptr;
  double impulse = 0.0;      ///< N·s, normal, in the tick
  ribbon::Vec2 point;        ///< m, where most of it is
  ribbon::Vec2 normal;       ///< away from the cord's link, or from the edge to its point
  std::uint64_t number = 0;  ///< the fixture's; 0 if that is null
};

}  // namespace engine
