#include "engine/coupling_roster.h"

#include <algorithm>

namespace engine {
namespace {

/// The first item of a list from which on all were recorded, in the recorded order.
template <typename Item>
const Item* first_of_kept(std::span<const Item* const> recorded, const Item* newest) {
  const Item* first = newest;
  auto next = recorded.begin();  // behind the last item's
  for (const Item* item = newest; item != nullptr; item = item->GetNext()) {
    auto place = std::find(next, recorded.end(), item);
    if (place == recorded.end()) {
      place = std::find(recorded.begin(), next, item);
      const bool is_recorded = place != next;
      first = is_recorded ? item : item->GetNext();
      next = is_recorded ? place + 1 : recorded.begin();
    } else {
      next = place + 1;
    }
  }
  return first;
}

template <typename Item>
bool is_in_list(const Item* item, const Item* wanted) {
  while (item != nullptr && item != wanted) item = item->GetNext();
  return item != nullptr;
}

}  // namespace

void WorldRoster::reserve(std::size_t bodies) {
  bodies_.reserve(bodies);
  first_fixtures_.reserve(bodies + 1);
  fixtures_.reserve(bodies);
}

void WorldRoster::record(const b2World& world) {
  bodies_.clear();
  first_fixtures_.clear();
  fixtures_.clear();
  for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
    bodies_.push_back(body);
    first_fixtures_.push_back(fixtures_.size());
    for (const b2Fixture* f = body->GetFixtureList(); f != nullptr; f = f->GetNext()) fixtures_.push_back(f);
  }
  first_fixtures_.push_back(fixtures_.size());
}

const b2Body* WorldRoster::first_kept(const b2World& world) const {
  return first_of_kept<b2Body>(bodies_, world.GetBodyList());
}

bool WorldRoster::keeps(const b2World& world, const b2Body* body) const { return is_in_list(first_kept(world), body); }

bool WorldRoster::keeps(const b2Body& body, const b2Fixture* fixture) const {
  const auto place = std::find(bodies_.begin(), bodies_.end(), &body);
  if (place == bodies_.end()) return false;
  const auto k = static_cast<std::size_t>(place - bodies_.begin());
  const auto recorded = std::span(fixtures_).subspan(first_fixtures_[k], first_fixtures_[k + 1] - first_fixtures_[k]);
  return is_in_list(first_of_kept<b2Fixture>(recorded, body.GetFixtureList()), fixture);
}

}  // namespace engine
