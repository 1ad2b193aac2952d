// Who began and ceased to touch a cord.

#include <algorithm>

#include "ribbon/box2d/coupling.h"
#include "ribbon/box2d/coupling_shapes.h"

namespace engine {

/// One entry a fixture, by its number.
void Coupling::add_touches(const ribbon::Cord& cord, std::vector<FixtureTouch>& touching) {
  for (const ribbon::Touch& touch : cord.touches()) {
    const std::uint64_t fixture = fixture_of(touch.other);
    if (fixture == 0) continue;
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

void Coupling::find_touch_events() {
  touch_events_.clear();
  for (CordIndex c = 0; c < size(); ++c) {
    if (solver(c) != Solver::direct) continue;
    CoupledCord& coupled = cords_[at(c)];
    coupled.touched.swap(coupled.touching);
    coupled.touching.clear();
    if (coupled.enabled) add_touches(cord(c), coupled.touching);
    const auto tell_missing = [&](const std::vector<FixtureTouch>& all, const std::vector<FixtureTouch>& in,
                                  bool begins) {
      for (const FixtureTouch& touch : all) {
        const bool is_there = std::any_of(in.begin(), in.end(),
                                          [&](const FixtureTouch& other) { return other.fixture == touch.fixture; });
        if (is_there) continue;
        const b2Fixture* const fixture = fixture_ids_.fixture(touch.fixture);
        touch_events_.push_back({c, begins, fixture, begins ? touch.impulse : 0.0, touch.point, touch.normal,
                                 fixture != nullptr ? touch.fixture : 0});
      }
    };
    tell_missing(coupled.touched, coupled.touching, false);
    tell_missing(coupled.touching, coupled.touched, true);
  }
}

}  // namespace engine
