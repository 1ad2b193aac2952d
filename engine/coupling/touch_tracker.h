#pragma once

#include <span>
#include <vector>

#include "ribbon/box2d/coupled_cord.h"
#include "ribbon/box2d/coupling_state.h"
#include "ribbon/box2d/coupling_types.h"
#include "ribbon/box2d/fixture_ids.h"

namespace ribbon::box2d {

/// Finds out which contacts between cords of the direct solver and fixtures began or ended in a step.
class TouchTracker {
 public:
  void reserve(std::size_t events) {
    events_.reserve(events);
    ending_.reserve(events);
  }
  /// Compares the contacts of each cord after a step with those before it.
  void find_events(CordTable& cords, const FixtureIds& fixtures);
  /// Makes the contacts of a cord that is removed end in the next step.
  void end_all(const CoupledCord& cord);
  /// Removes a fixture from the events.
  void forget(const b2Fixture& fixture);

  /// Returns the events of the last step, by cord; of each cord the ends first, and both by fixture number.
  std::span<const TouchEvent> events() const { return events_; }
  /// Returns the contacts of removed cords that end in the next step, by cord and fixture number.
  std::span<const EndingTouch> ending() const { return ending_; }
  /// Replaces the ending contacts, and removes all events.
  void restore(std::span<const EndingTouch> ending);
  /// Adds an event that was saved.
  void restore(const TouchEvent& event) { events_.push_back(event); }

 private:
  void report_missing(CordId cord, bool begins, std::span<const FixtureTouch> all, std::span<const FixtureTouch> in,
                      const FixtureIds& fixtures);
  void report(CordId cord, bool begins, const FixtureTouch& touch, const FixtureIds& fixtures);

  std::vector<TouchEvent> events_;
  std::vector<EndingTouch> ending_;
};

}  // namespace ribbon::box2d
