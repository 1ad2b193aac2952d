#include "engine/fixture_ids.h"

#include <algorithm>
#include <functional>

namespace engine {

void FixtureIds::begin_tick() {
  known_.erase(std::remove_if(known_.begin(), known_.end(), [](const Known& known) { return !known.seen; }),
               known_.end());
  for (Known& known : known_) known.seen = false;
}

std::uint64_t FixtureIds::of(const b2Fixture& fixture) {
  const auto place = std::lower_bound(
      known_.begin(), known_.end(), &fixture,
      [](const Known& known, const b2Fixture* wanted) { return std::less<>()(known.fixture, wanted); });
  if (place != known_.end() && place->fixture == &fixture) {
    place->seen = true;
    return place->id;
  }
  known_.insert(place, {&fixture, next_, true});
  return next_++;
}

const b2Fixture* FixtureIds::fixture(std::uint64_t id) const {
  const auto place = std::find_if(known_.begin(), known_.end(), [id](const Known& known) { return known.id == id; });
  return place != known_.end() && place->seen ? place->fixture : nullptr;
}

}  // namespace engine
