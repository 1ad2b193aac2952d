#include "ribbon/box2d/fixture_ids.h"

#include <algorithm>
#include <utility>

namespace ribbon::box2d {

void FixtureIds::reserve(std::size_t count) {
  known_.reserve(count);
  places_.reserve(count);
}

void FixtureIds::begin_tick() {
  const auto first_gone = std::remove_if(known_.begin(), known_.end(), [](const Known& known) { return !known.seen; });
  const bool any_gone = first_gone != known_.end();
  known_.erase(first_gone, known_.end());
  if (any_gone) list_places();
  repeat_tick();
}

void FixtureIds::repeat_tick() {
  for (Known& known : known_) known.seen = known.exists = false;
}

void FixtureIds::list_places() {
  places_.clear();
  for (std::size_t k = 0; k < known_.size(); ++k) places_.set(known_[k].seen_as.fixture, static_cast<int>(k));
}

const FixtureIds::Known* FixtureIds::find(const b2Fixture& fixture) const {
  const int place = places_.find(&fixture);
  if (place < 0) return nullptr;
  const Known& known = known_[static_cast<std::size_t>(place)];
  return known.seen_as.is(fixture) ? &known : nullptr;
}

std::uint64_t FixtureIds::of(const b2Fixture& fixture) {
  const int place = places_.find(&fixture);
  if (place < 0) return 0;
  Known& known = known_[static_cast<std::size_t>(place)];
  if (!known.seen && !known.seen_as.is(fixture)) {
    forget(fixture);
    return 0;
  }
  known.seen_as = SeenFixture(fixture);
  known.seen = known.exists = true;
  return known.id;
}

std::uint64_t FixtureIds::add(const b2Fixture& fixture) {
  places_.set(&fixture, static_cast<int>(known_.size()));
  known_.push_back({SeenFixture(fixture), next_, true});
  return next_++;
}

void FixtureIds::forget(const b2Fixture& fixture) {
  const int place = places_.find(&fixture);
  if (place < 0) return;
  known_.erase(known_.begin() + place);
  list_places();
}

void FixtureIds::forget_all() {
  known_.clear();
  places_.clear();
}

void FixtureIds::clear(std::uint64_t next) {
  forget_all();
  next_ = next;
}

void FixtureIds::restore(const Known& known) {
  places_.set(known.seen_as.fixture, static_cast<int>(known_.size()));
  known_.push_back(known);
}

const FixtureIds::Known* FixtureIds::known(std::uint64_t id) const {
  const auto place = std::lower_bound(known_.begin(), known_.end(), id,
                                      [](const Known& known, std::uint64_t wanted) { return known.id < wanted; });
  return place != known_.end() && place->id == id ? &*place : nullptr;
}

bool FixtureIds::misses_some() const {
  return std::any_of(known_.begin(), known_.end(), [](const Known& known) { return !known.seen; });
}

FixtureIds::Known* FixtureIds::missed(std::uint64_t id) {
  auto* const found = const_cast<Known*>(known(id));
  return found != nullptr && !found->seen ? found : nullptr;
}

const b2Fixture* FixtureIds::fixture(std::uint64_t id) const {
  const Known* const found = known(id);
  return found != nullptr && found->exists ? found->seen_as.fixture : nullptr;
}

}  // namespace ribbon::box2d
