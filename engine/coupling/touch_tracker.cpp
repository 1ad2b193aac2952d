#include "ribbon/box2d/touch_tracker.h"

#include <algorithm>
#include <utility>

#include "ribbon/box2d/fixture_shapes.h"

namespace ribbon::box2d {
namespace {

/// Adds the contacts of a cord, one entry per fixture, by its number.
void add_touches(const Cord& cord, std::vector<FixtureTouch>& touching) {
  for (const Touch& touch : cord.touches()) {
    const std::uint64_t fixture = fixture_of(touch.other);
    if (fixture == 0 || !(touch.force > 0.0 || touch.impulse > 0.0)) continue;
    const auto place = std::lower_bound(touching.begin(), touching.end(), fixture,
                                        [](const FixtureTouch& a, std::uint64_t b) { return a.fixture < b; });
    if (place == touching.end() || place->fixture != fixture) {
      touching.insert(place, {fixture, touch.impulse, touch.impulse, touch.point, touch.normal});
      continue;
    }
    place->impulse += touch.impulse;
    if (touch.impulse <= place->most) continue;
    place->most = touch.impulse;
    place->point = touch.point;
    place->normal = touch.normal;
  }
}

/// Returns whether a cord may have contacts with a force. One that sleeps keeps those that it had, and its report is
/// empty.
bool may_touch(const CoupledCord& cord) { return cord.report.contacts > 0 || cord.island_report == IslandReport{}; }

bool contains(std::span<const FixtureTouch> touches, std::uint64_t fixture) {
  return std::any_of(touches.begin(), touches.end(),
                     [fixture](const FixtureTouch& touch) { return touch.fixture == fixture; });
}

}  // namespace

void TouchTracker::find_events(CordTable& cords, const FixtureIds& fixtures) {
  events_.clear();
  for (const EndingTouch& ending : ending_) report(ending.cord, false, ending.touch, fixtures);
  ending_.clear();
  visit_fetched(cords.active(), CordMemory::reports, [&](CoupledCord& cord) {
    if (!cord.is_direct()) return;
    cord.touching_before.swap(cord.touching);
    cord.touching.clear();
    if (cord.enabled && may_touch(cord)) add_touches(cord.direct(), cord.touching);
    report_missing(cord.id, false, cord.touching_before, cord.touching, fixtures);
    report_missing(cord.id, true, cord.touching, cord.touching_before, fixtures);
  });
  if (events_.empty()) return;
  const auto by_cord = [](const TouchEvent& a, const TouchEvent& b) { return a.cord < b.cord; };
  if (!std::is_sorted(events_.begin(), events_.end(), by_cord)) {
    std::stable_sort(events_.begin(), events_.end(), by_cord);
  }
}

void TouchTracker::report_missing(CordId cord, bool begins, std::span<const FixtureTouch> all,
                                  std::span<const FixtureTouch> in, const FixtureIds& fixtures) {
  for (const FixtureTouch& touch : all) {
    if (!contains(in, touch.fixture)) report(cord, begins, touch, fixtures);
  }
}

void TouchTracker::report(CordId cord, bool begins, const FixtureTouch& touch, const FixtureIds& fixtures) {
  const b2Fixture* const fixture = fixtures.fixture(touch.fixture);
  events_.push_back({cord, begins, fixture, begins ? touch.impulse : 0.0, touch.point, touch.normal,
                     fixture != nullptr ? touch.fixture : 0});
}

void TouchTracker::end_all(const CoupledCord& cord) {
  const auto after = std::upper_bound(ending_.begin(), ending_.end(), cord.id,
                                      [](CordId id, const EndingTouch& ending) { return id < ending.cord; });
  std::vector<EndingTouch> ending;
  for (const FixtureTouch& touch : cord.touching) ending.push_back({cord.id, touch});
  ending_.insert(after, ending.begin(), ending.end());
}

void TouchTracker::forget(const b2Fixture& fixture) {
  for (TouchEvent& event : events_) {
    if (event.fixture != &fixture) continue;
    event.fixture = nullptr;
    event.number = 0;
  }
}

void TouchTracker::restore(std::span<const EndingTouch> ending) {
  events_.clear();
  ending_.assign(ending.begin(), ending.end());
}

}  // namespace ribbon::box2d
