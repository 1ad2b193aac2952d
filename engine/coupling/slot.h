#pragma once

#include <cstddef>

namespace ribbon::box2d {

/// Returns the index of a point or a cord, which is not negative, as an index into an array.
constexpr std::size_t slot(int index) { return static_cast<std::size_t>(index); }

}  // namespace ribbon::box2d
