#include "ribbon/box2d/body_finder.h"

namespace ribbon::box2d {

bool BodyFinder::enter(const b2World& world) {
  const bool is_other = world_ != &world;
  world_ = &world;
  return is_other;
}

bool BodyFinder::exists(const SeenBody& seen) const {
  if (world_ == nullptr) return false;
  if (trusts_forget_) return true;
  const b2Body* body = world_->GetBodyList();
  while (body != nullptr && body != seen.body) body = body->GetNext();
  return body != nullptr && seen.is(*body);
}

void BodyFinder::search() {
  for (const b2Body* body = world_->GetBodyList(); body != nullptr; body = body->GetNext()) {
    if (wanted_.find(body) == wanted) wanted_.set(body, found);
  }
}

b2Fixture* find_fixture(b2Body* newest, const SeenFixture& seen) {
  b2Body* body = newest;
  while (body != nullptr && body != seen.owner.body) body = body->GetNext();
  if (body == nullptr) return nullptr;
  b2Fixture* fixture = body->GetFixtureList();
  while (fixture != nullptr && fixture != seen.fixture) fixture = fixture->GetNext();
  return fixture != nullptr && seen.is(*fixture) ? fixture : nullptr;
}

}  // namespace ribbon::box2d
