#pragma once

#include <cstddef>
#include <vector>

namespace ribbon {

/// Reserves memory for that many elements. Where it takes some, it takes half as much again: what grows by a few
/// elements each time seldom allocates.
template <typename T>
void reserve_more(std::vector<T>& elements, std::size_t count) {
  if (elements.capacity() < count) elements.reserve(count + count / 2);
}

}  // namespace ribbon
