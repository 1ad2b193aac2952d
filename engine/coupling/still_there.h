#pragma once

#include <box2d/b2_body.h>
#include <box2d/b2_fixture.h>

namespace engine {

/// Tells a body or fixture that is still there from one that was made since at the same address. Box2D puts a new body
/// at the head of its world's list, a new fixture at the head of its body's, and moves none: what is behind one in the
/// list was made before it, and only goes when it is destroyed. So `then`, what was behind this one when it was looked
/// at last, is behind it still or is gone; where it comes later in the list, or there was nothing, this is
/// another one, made at the same address.
///
/// Not recognised is what takes the place of one that had nothing newer before it in the list, and of one that goes
/// together with the next, if that is made anew after it. O(1), unless what was behind it is gone. `then` is compared
/// and never looked through.
template <typename Item>
bool is_still_there(const Item& item, const Item* then) {
  const Item* behind = item.GetNext();
  if (behind == then) return true;
  if (then == nullptr) return false;
  while (behind != nullptr && behind != then) behind = behind->GetNext();
  return behind == nullptr;
}

/// A body as it was looked at last.
struct SeenBody {
  const b2Body* body = nullptr;    ///< its address
  const b2Body* behind = nullptr;  ///< that of the next in the world's list

  SeenBody() = default;  ///< none
  /// As it is now.
  explicit SeenBody(const b2Body& seen) : body(&seen), behind(seen.GetNext()) {}
  /// Whether a body that there is is this one.
  bool is(const b2Body& other) const { return body == &other && is_still_there(other, behind); }
};

/// A fixture as it was looked at last.
struct SeenFixture {
  const b2Fixture* fixture = nullptr;  ///< its address
  const b2Fixture* behind = nullptr;   ///< that of the next of its body
  SeenBody owner;                      ///< its body

  SeenFixture() = default;  ///< none
  /// As it is now.
  explicit SeenFixture(const b2Fixture& seen) : fixture(&seen), behind(seen.GetNext()), owner(*seen.GetBody()) {}
  /// Whether a fixture that there is is this one.
  bool is(const b2Fixture& other) const {
    return fixture == &other && owner.is(*other.GetBody()) && is_still_there(other, behind);
  }
};

}  // namespace engine
