#include "ribbon/box2d/contact_order.h"

#include <box2d/b2_body.h>
#include <box2d/b2_contact_manager.h>

#include <algorithm>

namespace ribbon::box2d {

bool is_younger(const PresentContact& a, const PresentContact& b) {
  return a.is_saved != b.is_saved ? b.is_saved : a.place < b.place;
}

ContactOrder::ContactOrder(b2World& world, std::span<const PresentContact> wanted, std::size_t waiting)
    : world_(world), filter_(world.GetContactManager().m_contactFilter), wanted_(wanted), waiting_(waiting) {
  world.SetContactFilter(this);
}

ContactOrder::~ContactOrder() { world_.SetContactFilter(filter_); }

/// Refilter makes Box2D ask the filter about all contacts of a fixture, and look for new ones.
void ContactOrder::create_again() {
  for (const PresentContact& contact : wanted_.first(waiting_)) contact.a->Refilter();
  step();
  while (waiting_ > 0) {
    --waiting_;
    const PresentContact& next = wanted_[waiting_];
    (next.a->GetBody()->GetType() == b2_staticBody ? next.b : next.a)->Refilter();
    step();
  }
}

/// The filter of the world decides about new pairs only.
bool ContactOrder::ShouldCollide(b2Fixture* a, b2Fixture* b) {
  const auto is_of = [a, b](const PresentContact& contact) {
    return (contact.a == a && contact.b == b) || (contact.a == b && contact.b == a);
  };
  const auto found = std::find_if(wanted_.begin(), wanted_.end(), is_of);
  if (found != wanted_.end()) return found - wanted_.begin() >= static_cast<std::ptrdiff_t>(waiting_);
  return filter_ == nullptr || filter_->ShouldCollide(a, b);
}

/// Bodies sleep, so that no contact is updated. Box2D looks for new contacts only after a call such as SetTransform; it
/// keeps the bits of a body whose centre of mass is its origin.
void ContactOrder::step() {
  b2Body* moved = world_.GetBodyList();
  for (b2Body* body = moved; body != nullptr; body = body->GetNext()) {
    if (!(moved->GetLocalCenter() == b2Vec2_zero)) moved = body;
    if (body->IsAwake()) body->SetAwake(false);
  }
  if (moved == nullptr) return;
  moved->SetTransform(moved->GetPosition(), moved->GetAngle());
  world_.Step(0.0F, 0, 0);
}

}  // namespace ribbon::box2d
