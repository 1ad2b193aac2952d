// Which of the bodies and fixtures that cords know are still there.

#include <algorithm>

#include "ribbon/box2d/coupling.h"
#include "ribbon/box2d/coupling_near.h"

namespace engine {
namespace {

/// The fixture that was seen, null if the world has it no more. O(bodies + fixtures of its body).
b2Fixture* find(b2Body* newest, const SeenFixture& seen) {
  b2Body* body = newest;
  while (body != nullptr && body != seen.owner.body) body = body->GetNext();
  if (body == nullptr) return nullptr;
  b2Fixture* fixture = body->GetFixtureList();
  while (fixture != nullptr && fixture != seen.fixture) fixture = fixture->GetNext();
  return fixture != nullptr && seen.is(*fixture) ? fixture : nullptr;
}

}  // namespace

/// Of another world than before nothing is known but the bodies that hold.
void Coupling::enter(const b2World& world) {
  if (world_ == &world) return;
  world_ = &world;
  led_.clear();
  fixture_ids_.forget_all();
  drop_gone_holders();
}

/// What was at the address of a body that holds nothing yet is known no more.
void Coupling::drop_if_replaced(const b2Body& body) {
  const auto is_other = [&body](const auto& known) { return known.body == &body && !known.seen.is(body); };
  if (std::any_of(holders_.begin(), holders_.end(), is_other) || std::any_of(led_.begin(), led_.end(), is_other)) {
    drop(body);
  }
}

/// Whether a body that was seen is still in its world. O(bodies), unless the user tells of destructions.
bool Coupling::world_has(const SeenBody& seen) const {
  if (world_ == nullptr) return false;
  if (trusts_forget_) return true;
  const b2Body* body = world_->GetBodyList();
  while (body != nullptr && body != seen.body) body = body->GetNext();
  return body != nullptr && seen.is(*body);
}

/// Finds which of the wanted addresses are bodies of the world. O(bodies).
void Coupling::look_for_wanted() {
  for (const b2Body* body = world_->GetBodyList(); body != nullptr; body = body->GetNext()) {
    if (wanted_.find(body) == wanted_body) wanted_.set(body, found_body);
  }
}

void Coupling::drop_gone_holders() {
  if (holders_.empty()) return;
  wanted_.clear();
  for (const Holder& holder : holders_) wanted_.set(holder.body, wanted_body);
  look_for_wanted();
  const auto is_gone = [this](const Holder& holder) {
    return wanted_.find(holder.body) != found_body || !holder.seen.is(*holder.body);
  };
  holders_.erase(std::remove_if(holders_.begin(), holders_.end(), is_gone), holders_.end());
}

/// Drops the grips of bodies that are gone, unless the user tells of that, and of those that cannot hold as they are.
void Coupling::look_at_holders() {
  if (!trusts_forget_) drop_gone_holders();
  const auto holds_nothing = [](const Holder& holder) { return !holder.body->IsEnabled() || !is_sound(*holder.body); };
  holders_.erase(std::remove_if(holders_.begin(), holders_.end(), holds_nothing), holders_.end());
  for (Holder& holder : holders_) holder.seen = SeenBody(*holder.body);
}

/// Gives those that were led, and that no cord comes near any more, what Box2D could not show of their velocity.
void Coupling::let_run_who_left() {
  wanted_.clear();
  bool any_left = false;
  for (LedBody& led : led_) {
    const int place = body_places_.find(led.seen.body);
    if (place >= 0) {
      led.left = !led.seen.is(*gathered_[at(place)].body);
      if (!led.left) led.seen = SeenBody(*led.seen.body);
      continue;
    }
    led.left = any_left = true;
    wanted_.set(led.seen.body, trusts_forget_ ? found_body : wanted_body);
  }
  if (any_left && !trusts_forget_) look_for_wanted();
  for (LedBody& led : led_) {
    if (!led.left || wanted_.find(led.seen.body) != found_body || !led.seen.is(*led.seen.body)) continue;
    if (is_sound(*led.seen.body)) add_ahead(*led.body, led);
  }
  led_.erase(std::remove_if(led_.begin(), led_.end(), [](const LedBody& led) { return led.left; }), led_.end());
}

/// Fixtures that touched a cord and are not near any more. A body that was carried by one and is asleep wakes, as where
/// a contact of Box2D ends.
void Coupling::look_for_the_missing(b2World& world) {
  if (!fixture_ids_.misses_some()) return;
  for (const CoupledCord& coupled : cords_) {
    for (const FixtureTouch& touch : coupled.touching) {
      FixtureIds::Known* const known = fixture_ids_.missed(touch.fixture);
      if (known == nullptr || known->exists) continue;
      b2Fixture* const fixture = find(world.GetBodyList(), known->seen_as);
      if (fixture == nullptr) continue;
      known->exists = true;
      if (!fixture->GetBody()->IsAwake()) fixture->GetBody()->SetAwake(true);
    }
  }
}

/// Lets go of what a body holds, without a word to it, and of what was at its address.
void Coupling::drop(const b2Body& body) {
  const auto holds = [&body](const Holder& holder) { return holder.body == &body; };
  holders_.erase(std::remove_if(holders_.begin(), holders_.end(), holds), holders_.end());
  const auto place = led_place(body);
  if (place != led_.end() && place->body == &body) led_.erase(place);
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
  const FixtureIds::Known* const known = fixture_ids_.known(number);
  if (known == nullptr || !known->exists) return nullptr;
  return find(const_cast<b2Body*>(world.GetBodyList()), known->seen_as);
}

}  // namespace engine
