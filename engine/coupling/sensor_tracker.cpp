#include "ribbon/box2d/sensor_tracker.h"

#include <box2d/b2_distance.h>

#include <algorithm>
#include <array>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/slot.h"

namespace ribbon::box2d {
namespace {

/// Tests parts of a cord against a part of a fixture, in coordinates relative to its body, so that single precision is
/// fine enough.
class OverlapTest {
 public:
  OverlapTest(const b2Fixture& fixture, int child, double radius)
      : origin_(to_double(fixture.GetBody()->GetTransform().p)), radius_(radius) {
    input_.proxyA.Set(fixture.GetShape(), child);
    input_.transformA = fixture.GetBody()->GetTransform();
    input_.transformA.p.SetZero();
    input_.transformB.SetIdentity();
    input_.useRadii = true;
    b2AABB box;
    fixture.GetShape()->ComputeAABB(&box, input_.transformA, child);
    box_ = widened({to_double(box.lowerBound), to_double(box.upperBound)}, static_cast<double>(b2_linearSlop));
  }

  /// Returns whether the hull of some points, 2 or 4, comes within the radius of the cord.
  template <std::size_t Count>
  bool meets(const std::array<Vec2, Count>& points) {
    Box box{points[0] - origin_, points[0] - origin_};
    for (const Vec2 point : points) box = joined(box, {point - origin_, point - origin_});
    if (!overlap(widened(box, radius_), box_)) return false;
    std::array<b2Vec2, Count> hull;
    std::transform(points.begin(), points.end(), hull.begin(), [this](Vec2 x) { return to_float(x - origin_); });
    input_.proxyB.Set(hull.data(), static_cast<int>(Count), static_cast<float>(radius_));
    b2SimplexCache cache{};
    b2DistanceOutput output{};
    b2Distance(&output, &cache, &input_);
    return !(output.distance > 0.0F);
  }

 private:
  Vec2 origin_;
  double radius_;
  Box box_;  // m, of the part of the fixture
  b2DistanceInput input_{};
};

}  // namespace

bool overlaps(const CoupledCord& cord, const b2Fixture& fixture, int child) {
  OverlapTest test(fixture, child, cord.is_direct() ? cord.direct().def().radius : 0.0);
  const CordShape shape = cord.shape();
  const auto x = cord.positions();
  const auto at = [&](int column, int row) { return x[slot(column * shape.rows + row)]; };
  for (int i = 0; i + 1 < shape.columns; ++i) {
    if (shape.rows == 1 && test.meets(std::array{at(i, 0), at(i + 1, 0)})) return true;
    for (int j = 0; j + 1 < shape.rows; ++j) {
      if (test.meets(std::array{at(i, j), at(i, j + 1), at(i + 1, j), at(i + 1, j + 1)})) return true;
    }
  }
  return false;
}

void SensorTracker::find_events(CordTable& cords, const FixtureIds& fixtures, ContactListener* listener) {
  events_.clear();
  const bool any_ending = !ending_.empty();
  for (const SensorMemory& ending : ending_) report(ending.cord, false, ending.fixture, fixtures);
  ending_.clear();
  for (CoupledCord& cord : cords.active()) {
    if (!cord.near_sensors.empty() || !cord.sensing.empty()) compare(cord, fixtures, listener);
  }
  if (any_ending) {
    std::stable_sort(events_.begin(), events_.end(),
                     [](const SensorEvent& a, const SensorEvent& b) { return a.cord < b.cord; });
  }
  if (listener == nullptr) return;
  for (const SensorEvent& event : events_) listener->sensor_event(event);
}

/// The parts of a fixture follow each other in the list of what is near.
void SensorTracker::compare(CoupledCord& cord, const FixtureIds& fixtures, ContactListener* listener) {
  cord.sensing_before.swap(cord.sensing);
  cord.sensing.clear();
  std::uint64_t refused = 0;
  for (std::size_t k = 0; cord.enabled && k < cord.near_sensors.size(); ++k) {
    const NearShape& near = cord.near_sensors[k];
    const bool is_first = k == 0 || cord.near_sensors[k - 1].number != near.number;
    if (is_first && listener != nullptr && !listener->should_meet_sensor(cord.id, *near.fixture)) refused = near.number;
    if (near.number == refused || (!cord.sensing.empty() && cord.sensing.back() == near.number)) continue;
    if (overlaps(cord, *near.fixture, near.child)) cord.sensing.push_back(near.number);
  }
  const auto report_missing = [&](bool begins, const std::vector<std::uint64_t>& all,
                                  const std::vector<std::uint64_t>& in) {
    for (const std::uint64_t number : all) {
      if (!std::binary_search(in.begin(), in.end(), number)) report(cord.id, begins, number, fixtures);
    }
  };
  report_missing(false, cord.sensing_before, cord.sensing);
  report_missing(true, cord.sensing, cord.sensing_before);
}

void SensorTracker::report(CordId cord, bool begins, std::uint64_t number, const FixtureIds& fixtures) {
  const b2Fixture* const fixture = fixtures.fixture(number);
  events_.push_back({cord, begins, fixture, fixture != nullptr ? number : 0});
}

void SensorTracker::end_all(const CoupledCord& cord) {
  const auto after = std::upper_bound(ending_.begin(), ending_.end(), cord.id,
                                      [](CordId id, const SensorMemory& ending) { return id < ending.cord; });
  std::vector<SensorMemory> ending;
  for (const std::uint64_t number : cord.sensing) ending.push_back({cord.id, false, number});
  ending_.insert(after, ending.begin(), ending.end());
}

void SensorTracker::forget(const b2Fixture& fixture) {
  for (SensorEvent& event : events_) {
    if (event.fixture != &fixture) continue;
    event.fixture = nullptr;
    event.number = 0;
  }
}

void SensorTracker::restore(std::span<const SensorMemory> ending) {
  events_.clear();
  ending_.assign(ending.begin(), ending.end());
}

}  // namespace ribbon::box2d
