#include "engine/fixture_ids.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace engine {

void FixtureIds::begin_tick() {
  known_.erase(std::remove_if(known_.begin(), known_.end(), [](const Known& known) { return !known.seen; }),
               known_.end());
  for (Known& known : known_) known.seen = known.exists = false;
}

std::vector<FixtureIds::Known>::const_iterator FixtureIds::place(const b2Fixture& fixture) const {
  return std::lower_bound(known_.begin(), known_.end(), &fixture, [](const Known& known, const b2Fixture* wanted) {
    return std::less<>()(known.fixture, wanted);
  });
}

const FixtureIds::Known* FixtureIds::find(const b2Fixture& fixture) const {
  const auto found = place(fixture);
  return found != known_.end() && found->fixture == &fixture ? &*found : nullptr;
}

std::uint64_t FixtureIds::of(const b2Fixture& fixture) {
  const auto found = known_.begin() + (place(fixture) - known_.cbegin());
  if (found != known_.end() && found->fixture == &fixture) {
    found->seen = found->exists = true;
    return found->id;
  }
  known_.insert(found, {&fixture, next_, true});
  return next_++;
}

void FixtureIds::forget(const b2Fixture& fixture) {
  if (find(fixture) != nullptr) known_.erase(place(fixture));
}

bool FixtureIds::misses_some() const {
  return std::any_of(known_.begin(), known_.end(), [](const Known& known) { return !known.seen; });
}

std::uint64_t FixtureIds::find_missed(const b2Fixture& fixture) {
  const auto found = known_.begin() + (place(fixture) - known_.cbegin());
  if (found == known_.end() || found->fixture != &fixture || found->seen) return 0;
  found->exists = true;
  return found->id;
}

void FixtureIds::restore(std::vector<Known> known, std::uint64_t next) {
  std::sort(known.begin(), known.end(),
            [](const Known& a, const Known& b) { return std::less<>()(a.fixture, b.fixture); });
  known_ = std::move(known);
  next_ = next;
}

const b2Fixture* FixtureIds::fixture(std::uint64_t id) const {
  const auto place = std::find_if(known_.begin(), known_.end(), [id](const Known& known) { return known.id == id; });
  return place != known_.end() && place->exists ? place->fixture : nullptr;
}

}  // namespace engine
