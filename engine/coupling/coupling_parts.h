#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "ribbon/box2d/body_finder.h"
#include "ribbon/box2d/contact_listener.h"
#include "ribbon/box2d/coupled_cord.h"
#include "ribbon/box2d/cut_log.h"
#include "ribbon/box2d/fixture_ids.h"
#include "ribbon/box2d/gatherer.h"
#include "ribbon/box2d/grip_table.h"
#include "ribbon/box2d/pulley_table.h"
#include "ribbon/box2d/sensor_tracker.h"
#include "ribbon/box2d/spare_cords.h"
#include "ribbon/box2d/step_watcher.h"
#include "ribbon/box2d/supports.h"
#include "ribbon/box2d/tick_bodies.h"
#include "ribbon/box2d/tie_table.h"
#include "ribbon/box2d/touch_tracker.h"
#include "ribbon/box2d/velocity_carry.h"
#include "ribbon/cut.h"
#include "ribbon/direct_solver.h"
#include "ribbon/error_probe.h"
#include "ribbon/parallel_for.h"

namespace ribbon::box2d {

/// What has been done of a tick.
enum class TickPhase : unsigned char { between_ticks, gathered, stepped };

/// Memory of Coupling::restore.
struct RestoreMemory {
  std::vector<b2Body*> bodies;              // of the world, in the order of creation
  std::vector<std::pair<int, int>> places;  // of fixtures: their body's, and among those of the body
};

/// A body of which supports are gathered.
struct SupportedBody {
  int index = 0;  // of the body in the tick
  int depth = 0;  // 0 near the cord, and one more for each body that presses on the one before
};

/// Where the path of a blade cuts a cord.
struct BladeCut {
  CordId cord = 0;
  CutPlace where;
};

/// What a Coupling and its handles work on.
struct CouplingParts {
  // The state between two ticks:
  CordTable cords;
  GripTable grips;
  TieTable ties;
  PulleyTable pulleys;
  VelocityCarry carry;
  FixtureIds fixtures;
  TouchTracker touches;
  SensorTracker sensors;
  CutLog cuts;
  double medium_time = 0.0;  // s
  // Of this tick:
  TickPhase phase = TickPhase::between_ticks;
  bool may_have_left_bodies = false;  // a cord was disabled or removed, and bodies that touched it may sleep
  StepConditions conditions;
  int islands = 0;  // of the last step, with those of resting cords
  TickBodies bodies;
  // Tools and memory:
  BodyFinder finder;
  Gatherer gatherer;
  DirectSolver solver;
  std::vector<IslandCord> island_cords;
  std::vector<CordReport> reports;
  SpareCords spares;
  std::vector<b2Fixture*> near_fixtures;                  // memory of append_supports
  std::vector<FoundSupport> found_supports;               // of a body
  std::vector<SupportedBody> supported;                   // of a cord
  std::vector<BladeCut> blade_cuts;                       // by cord, of each the last place first
  std::vector<TouchImpulse> impulses;                     // of a fixture, for the listener
  std::vector<std::pair<CordId, int>> overloaded;         // cords and their links
  std::vector<std::pair<double, TieId>> overloaded_ties;  // with the factor of the overload
  std::vector<CordId> relieved;                           // whose ties came undone in this tick
  RestoreMemory restore_memory;
  std::optional<ErrorProbe> probe;
  StepWatcher* watcher = nullptr;
  ContactListener* listener = nullptr;
  const Medium* medium = nullptr;
  ParallelFor parallel_for;

  /// Adds a cord and reserves memory for its bodies.
  CordId add(std::unique_ptr<CoupledCord> cord);
  /// Reserves memory for so many more cords of that many points.
  void reserve(std::size_t new_cords, int points);
  /// Removes the cord with that id, which exists. What it holds or touches is released.
  void remove(CordId cord);
  /// Sets the world of the coupling. In another world than before, only the bodies that hold cords are known.
  void enter(const b2World& world);
  /// Forgets what is stored for the address of a body that is a new one.
  void forget_predecessor(const b2Body& body);
  /// Returns the force on the body of a grip in the last step, N.
  Vec2 pull(const BodyGrip& grip) const;
  /// Releases a grip. Returns false if there is none with that id.
  bool release(GripId grip);
  /// Unties a tie. Returns false if there is none with that id.
  bool untie(TieId tie);
  /// Takes a cord off a wheel. Returns false if there is no pulley with that id.
  bool remove_pulley(PulleyId pulley);
  /// Releases all grips and ties of a cord that is about to be disabled, replaced or removed, and wakes the cords that
  /// touch it.
  void detach(CordId cord);
};

/// Throws CallError for a cord that has pulleys already.
void check_without_pulleys(const CoupledCord& cord);
/// Throws CallError if a body holds the cord, or it is tied, where it would be on a wheel.
void check_nothing_held(const CouplingParts& parts, const CoupledCord& cord, const PulleyDef& def);
/// Throws CallError inside world.Step and between gather and apply, for a call named `what`.
void check_between_ticks(const CouplingParts& parts, const char* what);

/// Returns the id by which the direct solver knows a cord. The ids of fixtures are far below.
inline std::uint64_t solver_id(CordId cord) { return (std::uint64_t{1} << 63U) + static_cast<std::uint64_t>(cord); }

}  // namespace ribbon::box2d
