#pragma once

#include <box2d/b2_body.h>
#include <box2d/b2_fixture.h>

namespace ribbon::box2d {

/// Returns whether a body or fixture is the one that was seen before, and not a new one at the same address. Box2D
/// inserts a new body at the head of the world's list, and a new fixture at the head of its body's list, and never
/// reorders them. So the successor of an item is older than the item and stays its successor until it is destroyed.
/// `then` is the successor that was seen before. If it is not directly behind the item now, it must be gone; if it is
/// still in the list behind the item, or if there was none, the item is a new one.
///
/// The function cannot detect the replacement of the newest item of a list, nor of an item that is destroyed together
/// with its successor if that is created again after it. O(1), unless the former successor is gone. `then` is compared
/// but never dereferenced.
template <typename Item>
bool is_still_there(const Item& item, const Item* then) {
  const Item* behind = item.GetNext();
  if (behind == then) return true;
  if (then == nullptr) return false;
  while (behind != nullptr && behind != then) behind = behind->GetNext();
  return behind == nullptr;
}

/// Identifies a body.
struct SeenBody {
  const b2Body* body = nullptr;    ///< its address
  const b2Body* behind = nullptr;  ///< address of its successor in the world's list

  SeenBody() = default;  ///< none
  /// As it is now.
  explicit SeenBody(const b2Body& seen) : body(&seen), behind(seen.GetNext()) {}
  /// Returns whether an existing body is the identified one.
  bool is(const b2Body& other) const { return body == &other && is_still_there(other, behind); }
};

/// Identifies a fixture.
struct SeenFixture {
  const b2Fixture* fixture = nullptr;  ///< its address
  const b2Fixture* behind = nullptr;   ///< address of its successor in the body's list
  SeenBody owner;                      ///< its body

  SeenFixture() = default;  ///< none
  /// As it is now.
  explicit SeenFixture(const b2Fixture& seen) : fixture(&seen), behind(seen.GetNext()), owner(*seen.GetBody()) {}
  /// Returns whether an existing fixture is the identified one.
  bool is(const b2Fixture& other) const {
    return fixture == &other && owner.is(*other.GetBody()) && is_still_there(other, behind);
  }
};

}  // namespace ribbon::box2d
