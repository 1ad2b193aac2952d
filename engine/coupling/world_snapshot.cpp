#include "ribbon/box2d/world_snapshot.h"

#include <box2d/b2_body.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "ribbon/box2d/address_table.h"
#include "ribbon/box2d/contact_order.h"
#include "ribbon/definition.h"

namespace ribbon::box2d {
namespace {

struct BodyState {
  b2Vec2 position;
  float angle = 0.0F;
  b2Vec2 velocity;
  float angular_velocity = 0.0F;
  b2BodyType type = b2_staticBody;
  bool enabled = true;
  bool awake = true;
  int fixtures = 0;
};

/// Names a contact: the number of its first fixture along the lists of the world, its child, and those of the second.
using ContactKey = std::array<int, 4>;

struct ContactState {
  ContactKey key{};
  bool touching = false;
  bool enabled = true;
  b2Manifold manifold;
  float friction = 0.0F;
  float restitution = 0.0F;
  float restitution_threshold = 0.0F;
  float tangent_speed = 0.0F;
};

/// A key, and the place of the saved contact.
using ContactPlace = std::pair<ContactKey, std::size_t>;

int fixture_count(const b2Body& body) {
  int count = 0;
  for (const b2Fixture* f = body.GetFixtureList(); f != nullptr; f = f->GetNext()) ++count;
  return count;
}

BodyState state_of(const b2Body& body) {
  return {body.GetPosition(), body.GetAngle(),  body.GetLinearVelocity(), body.GetAngularVelocity(),
          body.GetType(),     body.IsEnabled(), body.IsAwake(),           fixture_count(body)};
}

ContactState state_of(const b2Contact& contact, const ContactKey& key) {
  return {key,
          contact.IsTouching(),
          contact.IsEnabled(),
          *contact.GetManifold(),
          contact.GetFriction(),
          contact.GetRestitution(),
          contact.GetRestitutionThreshold(),
          contact.GetTangentSpeed()};
}

void put_back(b2Contact& contact, const ContactState& state) {
  *contact.GetManifold() = state.manifold;
  contact.SetFriction(state.friction);
  contact.SetRestitution(state.restitution);
  contact.SetRestitutionThreshold(state.restitution_threshold);
  contact.SetTangentSpeed(state.tangent_speed);
  contact.SetEnabled(state.enabled);
}

/// A contact that the saved state does not have starts without impulses.
void clear_impulses(b2Contact& contact) {
  for (b2ManifoldPoint& point : contact.GetManifold()->points) point.normalImpulse = point.tangentImpulse = 0.0F;
}

/// While it exists, the listener of a world is not called.
class Silence {
 public:
  explicit Silence(b2World& world) : world_(world), listener_(world.GetContactManager().m_contactListener) {
    world.SetContactListener(nullptr);
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;
  ~Silence() { world_.SetContactListener(listener_); }

 private:
  b2World& world_;
  b2ContactListener* listener_;
};

/// Moves a body to its saved place. Wakes it if anything differs, so that its contacts are updated. A body that is
/// there is not touched, because b2Body::SetTransform rounds its centre of mass and wakes its broad phase.
void place(b2Body& body, const BodyState& state) {
  bool differs = body.IsAwake() != state.awake;
  if (body.GetType() != state.type) {
    body.SetType(state.type);
    differs = true;
  }
  if (!(body.GetPosition() == state.position) || body.GetAngle() != state.angle) {
    body.SetTransform(state.position, state.angle);
    differs = true;
  }
  if (body.IsEnabled() != state.enabled) {
    body.SetEnabled(state.enabled);
    differs = true;
  }
  if (differs) body.SetAwake(true);
}

/// SetAwake restarts the rest time, in both cases.
void set_motion(b2Body& body, const BodyState& state) {
  if (state.type == b2_staticBody) return;
  if (state.awake || body.IsAwake()) body.SetAwake(state.awake);
  if (!state.awake) return;
  body.SetLinearVelocity(state.velocity);
  body.SetAngularVelocity(state.angular_velocity);
}

/// Calls `visit` with each body and its state.
template <typename Visit>
void for_each_body(b2World& world, const std::vector<BodyState>& states, Visit visit) {
  auto state = states.begin();
  for (b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) visit(*body, *state++);
}

void check_unlocked(const b2World& world) {
  if (world.IsLocked()) throw CallError("world is locked; accepted is one that is not inside its Step");
}

}  // namespace

struct WorldSnapshot::Parts {
  std::vector<BodyState> bodies;       // the newest first, as in the world
  std::vector<ContactState> contacts;  // the newest first, as in the world
  // Memory:
  AddressTable fixtures;             // numbers of those whose bodies have contacts
  std::vector<ContactPlace> places;  // of the contacts, by key
  std::vector<PresentContact> present, wanted;
  std::vector<const b2Body*> wrong;  // whose contacts have wrong flags

  void number_fixtures(const b2World& world);
  ContactKey key_of(const b2Contact& contact) const;
  void check(const b2World& world) const;
  void index_contacts(const b2World& world);
  const ContactState* find(const b2Contact& contact) const;
  void put_order_back(b2World& world);
  void correct_touches(b2World& world);
  void put_contacts_back(b2World& world);
};

void WorldSnapshot::Parts::number_fixtures(const b2World& world) {
  fixtures.clear();
  int number = 0;
  for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
    const bool is_wanted = body->GetContactList() != nullptr;
    for (const b2Fixture* f = body->GetFixtureList(); f != nullptr; f = f->GetNext(), ++number) {
      if (is_wanted) fixtures.set(f, number);
    }
  }
}

ContactKey WorldSnapshot::Parts::key_of(const b2Contact& contact) const {
  return {fixtures.find(contact.GetFixtureA()), contact.GetChildIndexA(), fixtures.find(contact.GetFixtureB()),
          contact.GetChildIndexB()};
}

void WorldSnapshot::Parts::check(const b2World& world) const {
  check_unlocked(world);
  if (static_cast<int>(bodies.size()) != world.GetBodyCount()) {
    throw DefinitionError("snapshot is of a world of " + std::to_string(bodies.size()) +
                          " bodies; accepted is one of " + std::to_string(world.GetBodyCount()));
  }
  auto state = bodies.begin();
  for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext(), ++state) {
    const int count = fixture_count(*body);
    if (state->fixtures == count) continue;
    throw DefinitionError("snapshot has a body of " + std::to_string(state->fixtures) +
                          " fixtures; accepted is one of " + std::to_string(count));
  }
}

void WorldSnapshot::Parts::index_contacts(const b2World& world) {
  number_fixtures(world);
  places.clear();
  for (std::size_t k = 0; k < contacts.size(); ++k) places.emplace_back(contacts[k].key, k);
  std::sort(places.begin(), places.end());
}

const ContactState* WorldSnapshot::Parts::find(const b2Contact& contact) const {
  const ContactKey key = key_of(contact);
  const auto found = std::lower_bound(places.begin(), places.end(), ContactPlace{key, 0});
  return found != places.end() && found->first == key ? &contacts[found->second] : nullptr;
}

void WorldSnapshot::Parts::put_order_back(b2World& world) {
  present.clear();
  for (b2Contact* contact = world.GetContactList(); contact != nullptr; contact = contact->GetNext()) {
    const ContactState* const found = find(*contact);
    const std::size_t at = found != nullptr ? static_cast<std::size_t>(found - contacts.data()) : present.size();
    present.push_back({contact->GetFixtureA(), contact->GetFixtureB(), found != nullptr, at});
  }
  wanted = present;
  std::sort(wanted.begin(), wanted.end(), is_younger);
  std::size_t waiting = wanted.size();
  while (waiting > 0 && wanted[waiting - 1] == present[waiting - 1]) --waiting;
  if (waiting == 0) return;
  ContactOrder(world, wanted, waiting).create_again();
  for (b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
    if (body->GetContactList() != nullptr) body->SetAwake(true);
  }
  world.Step(0.0F, 0, 0);  // updates the new contacts
}

/// A contact that Box2D updated within the step, because a body would have passed through another, has the flag of the
/// end of the step. Its bodies are moved there.
void WorldSnapshot::Parts::correct_touches(b2World& world) {
  wrong.clear();
  for (b2Contact* contact = world.GetContactList(); contact != nullptr; contact = contact->GetNext()) {
    const ContactState* const found = find(*contact);
    if (found == nullptr || found->touching == contact->IsTouching()) continue;
    wrong.push_back(contact->GetFixtureA()->GetBody());
    wrong.push_back(contact->GetFixtureB()->GetBody());
  }
  if (wrong.empty()) return;
  for_each_body(world, bodies, [this](b2Body& body, const BodyState& state) {
    if (std::find(wrong.begin(), wrong.end(), &body) == wrong.end()) return;
    place(body, state);
    body.SetAwake(true);
  });
  world.Step(0.0F, 0, 0);
}

void WorldSnapshot::Parts::put_contacts_back(b2World& world) {
  for (b2Contact* contact = world.GetContactList(); contact != nullptr; contact = contact->GetNext()) {
    if (const ContactState* const found = find(*contact)) {
      put_back(*contact, *found);
    } else {
      clear_impulses(*contact);
    }
  }
}

WorldSnapshot::WorldSnapshot() : parts_(std::make_unique<Parts>()) {}
WorldSnapshot::WorldSnapshot(WorldSnapshot&& other) noexcept = default;
WorldSnapshot& WorldSnapshot::operator=(WorldSnapshot&& other) noexcept = default;
WorldSnapshot::~WorldSnapshot() = default;

void WorldSnapshot::save(const b2World& world) {
  check_unlocked(world);
  Parts& parts = *parts_;
  parts.bodies.clear();
  for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
    parts.bodies.push_back(state_of(*body));
  }
  parts.number_fixtures(world);
  parts.contacts.clear();
  for (const b2Contact* contact = world.GetContactList(); contact != nullptr; contact = contact->GetNext()) {
    parts.contacts.push_back(state_of(*contact, parts.key_of(*contact)));
  }
}

void WorldSnapshot::restore(b2World& world, const WorldSnapshot* before) {
  Parts& parts = *parts_;
  parts.check(world);
  if (before != nullptr) before->parts_->check(world);

  const Silence silence(world);
  for_each_body(world, before != nullptr ? before->parts_->bodies : parts.bodies, place);
  world.Step(0.0F, 0, 0);  // creates, destroys and updates contacts
  parts.index_contacts(world);
  parts.put_order_back(world);
  if (before != nullptr) {
    parts.correct_touches(world);
    for_each_body(world, parts.bodies, place);
  }
  parts.put_contacts_back(world);
  for_each_body(world, parts.bodies, set_motion);
}

}  // namespace ribbon::box2d
