// Which of the bodies and fixtures that cords know are still there.

#include <algorithm>

#include "engine/coupling.h"

namespace engine {

/// Drops what is known of bodies and fixtures that are gone, also where others are at their addresses, and records the
/// world as it is.
void Coupling::drop_what_is_gone_from(const b2World& world) {
  const b2Body* const first = roster_.first_kept(world);
  const auto is_gone = [first](const Holder& holder) {
    for (const b2Body* body = first; body != nullptr; body = body->GetNext()) {
      if (body == holder.body) return false;
    }
    return true;
  };
  holders_.erase(std::remove_if(holders_.begin(), holders_.end(), is_gone), holders_.end());
  for (LedBody& led : led_) led.led = false;
  for (const b2Body* body = first; body != nullptr; body = body->GetNext()) {
    if (LedBody* found = led(*body)) found->led = true;
  }
  led_.erase(std::remove_if(led_.begin(), led_.end(), [](const LedBody& led) { return !led.led; }), led_.end());
  drop_new_fixtures_of(world, first);
  roster_.record(world);
  world_ = &world;
}

/// A fixture that is new has no number yet; `first` is the first body that is not.
void Coupling::drop_new_fixtures_of(const b2World& world, const b2Body* first) {
  bool is_kept = false;
  for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
    is_kept = is_kept || body == first;
    for (const b2Fixture* fixture = body->GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext()) {
      if (fixture_ids_.find(*fixture) == nullptr || (is_kept && roster_.keeps(*body, fixture))) continue;
      fixture_ids_.forget(*fixture);
    }
  }
}

/// Whether a body that holds or is led is still in its world. Does not look through the pointer.
bool Coupling::is_there(const b2Body* body) const { return world_ != nullptr && roster_.keeps(*world_, body); }

/// Lets go of what a body holds, without a word to it.
void Coupling::drop(const b2Body& body) {
  const auto holds = [&body](const Holder& holder) { return holder.body == &body; };
  holders_.erase(std::remove_if(holders_.begin(), holders_.end(), holds), holders_.end());
  if (led(body) != nullptr) led_.erase(led_place(body));
}

void Coupling::forget(const b2Body& body) {
  drop(body);
  for (GatheredBody& gathered : gathered_) {
    if (gathered.body == &body) gathered.body = nullptr;
  }
  for (const b2Fixture* f = body.GetFixtureList(); f != nullptr; f = f->GetNext()) forget(*f);
}

void Coupling::forget(const b2Fixture& fixture) {
  fixture_ids_.forget(fixture);
  for (TouchEvent& event : touch_events_) {
    if (event.fixture != &fixture) continue;
    event.fixture = nullptr;
    event.number = 0;
  }
}

void Coupling::destroy(b2World& world, b2Body& body) {
  forget(body);
  world.DestroyBody(&body);
}

const b2Fixture* Coupling::fixture(std::uint64_t number, const b2World& world) const {
  const b2Fixture* const known = fixture_ids_.fixture(number);
  if (known == nullptr) return nullptr;
  for (const b2Body* body = roster_.first_kept(world); body != nullptr; body = body->GetNext()) {
    for (const b2Fixture* f = body->GetFixtureList(); f != nullptr; f = f->GetNext()) {
      if (f == known) return roster_.keeps(*body, f) ? f : nullptr;
    }
  }
  return nullptr;
}

}  // namespace engine
