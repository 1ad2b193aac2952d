#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ribbon/box2d/contact_listener.h"
#include "ribbon/box2d/coupled_cord.h"
#include "ribbon/box2d/coupling_state.h"
#include "ribbon/box2d/coupling_types.h"
#include "ribbon/box2d/fixture_ids.h"

namespace ribbon::box2d {

/// Returns whether a cord overlaps a part of a fixture where both are now. A rope is its links with their thickness. Of
/// a ribbon the inside counts too: it is the hulls of its cells. O(points).
bool overlaps(const CoupledCord& cord, const b2Fixture& fixture, int child);

/// Finds out which overlaps between cords and sensors began or ended. Without a sensor near a cord it does nothing.
class SensorTracker {
 public:
  /// Compares the overlaps of each cord, where it is now, with those of the last step. `listener` may be null.
  void find_events(CordTable& cords, const FixtureIds& fixtures, ContactListener* listener);
  /// Makes the overlaps of a cord that is removed end in the next step.
  void end_all(const CoupledCord& cord);
  /// Removes a fixture from the events.
  void forget(const b2Fixture& fixture);

  /// Returns the events of the last step, by cord; of each cord the ends first, and both by fixture number.
  std::span<const SensorEvent> events() const { return events_; }
  /// Returns the overlaps of removed cords that end in the next step, by cord and fixture number.
  std::span<const SensorMemory> ending() const { return ending_; }
  /// Replaces the ending overlaps, and removes all events.
  void restore(std::span<const SensorMemory> ending);
  /// Adds an event that was saved.
  void restore(const SensorEvent& event) { events_.push_back(event); }

 private:
  void report(CordId cord, bool begins, std::uint64_t number, const FixtureIds& fixtures);
  void compare(CoupledCord& cord, const FixtureIds& fixtures, ContactListener* listener);

  std::vector<SensorEvent> events_;
  std::vector<SensorMemory> ending_;
};

}  // namespace ribbon::box2d
