#pragma once

#include <box2d/b2_fixture.h>
#include <box2d/b2_world.h>
#include <box2d/b2_world_callbacks.h>

#include <cstddef>
#include <span>

namespace ribbon::box2d {

/// A contact of a world.
struct PresentContact {
  b2Fixture* a = nullptr;
  b2Fixture* b = nullptr;
  bool is_saved = false;  // otherwise it is younger than all that are
  std::size_t place = 0;  // among the saved ones, or in the list of the world
  bool operator==(const PresentContact&) const = default;
};

/// Returns whether a contact belongs in front of another one.
bool is_younger(const PresentContact& a, const PresentContact& b);

/// Creates contacts again in an order, which determines the order in which Box2D solves them. Box2D puts a new contact
/// in front of its lists and never moves it. So the oldest contact that is out of order and all younger ones are
/// destroyed, and then let in by a filter, one pair of fixtures after the other.
class ContactOrder : public b2ContactFilter {
 public:
  /// `wanted` has the youngest contact first; the first `waiting` are created again, the others stay.
  ContactOrder(b2World& world, std::span<const PresentContact> wanted, std::size_t waiting);
  ContactOrder(const ContactOrder&) = delete;
  ContactOrder& operator=(const ContactOrder&) = delete;
  ~ContactOrder() override;

  /// Does it. All bodies sleep afterwards, and the new contacts are not updated yet. O(contacts) for each new one.
  void create_again();
  bool ShouldCollide(b2Fixture* a, b2Fixture* b) override;

 private:
  void step();

  b2World& world_;
  b2ContactFilter* filter_;  // of the world
  std::span<const PresentContact> wanted_;
  std::size_t waiting_;  // how many are not let in yet
};

}  // namespace ribbon::box2d
