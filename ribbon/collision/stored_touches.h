#pragma once

#include <span>
#include <vector>

#include "ribbon/system/cord_parts.h"
#include "ribbon/touch.h"

namespace ribbon {

/// The contacts that a cord has stored in the last step, listed by its features. Each pair that is found looks for its
/// own, and most have none.
class StoredTouches {
 public:
  /// Lists the contacts of a cord, which must not change until the next call.
  void list(const CordParts& cord);
  /// Returns the first contact at the same place as another one, null if there is none.
  const Touch* find(const Touch& place) const;

 private:
  std::span<const Touch> touches_;
  std::vector<int> first_;  // by feature: index of its first contact, −1 if it has none
  std::vector<int> next_;   // by contact: index of the next one of its feature, −1 for the last
};

}  // namespace ribbon
