#pragma once

#include <box2d/box2d.h>

#include <functional>
#include <vector>

#include "ribbon/box2d/contact_listener.h"
#include "ribbon/box2d/coupled_cord.h"
#include "ribbon/box2d/fixture_ids.h"
#include "ribbon/box2d/near_finder.h"
#include "ribbon/box2d/velocity_carry.h"
#include "ribbon/parallel_for.h"

namespace ribbon::box2d {

/// Finds the surroundings of each cord in a tick: the circles and edges that it may touch. Between ticks it stores
/// memory, and the queries of resting cords.
class Gatherer {
 public:
  /// Reserves memory for so many fixtures near a cord and for so many cords.
  void reserve(std::size_t fixtures, std::size_t cords);
  /// Finds and numbers the fixtures that each enabled cord may touch. Makes resting cords active if they or the
  /// conditions changed, or something came near.
  void find_fixtures(b2World& world, const StepConditions& conditions, CordTable& cords, FixtureIds& fixtures,
                     const ParallelFor& parallel_for);
  /// Makes the resting cords active that were changed since the last step.
  static void activate_changed(CordTable& cords);
  /// Returns whether a cord, which was stepped last, may rest: it sleeps, has no grip, touch or cord_contact, and
  /// nothing was found near where it is now.
  static bool may_rest(const CoupledCord& cord, const StepConditions& conditions);
  /// Turns the fixtures of a cord into circles and edges, ordered by fixture number. Costs nothing if there is none.
  /// `index_of` returns the index of a body in the step. The listener, if there is one, decides which fixtures.
  static void add_shapes_of(CoupledCord& cord, const StepConditions& conditions,
                            const std::function<int(b2Body&)>& index_of, ContactListener* listener);

 private:
  void load_resting_queries(CordTable& cords);
  void number_new_fixtures(const b2World& world, CordTable& cords, FixtureIds& fixtures);
  void number_in_order(const b2World& world, FixtureIds& fixtures);
  void number_fixtures_of(const b2Body& body, FixtureIds& fixtures) const;

  NearFinder near_finder_;
  std::vector<NearQuery> queries_;  // of resting cords, which stay from tick to tick, and behind them of enabled ones
  std::size_t resting_count_ = 0;
  std::uint64_t resting_version_ = 0;
  StepConditions conditions_;  // of the last tick
  // Fixtures without a number yet, and their bodies, sorted by address for lookup only.
  std::vector<const b2Fixture*> new_fixtures_;
  std::vector<const b2Body*> new_bodies_;
};

}  // namespace ribbon::box2d
