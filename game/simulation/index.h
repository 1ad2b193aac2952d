#pragma once

#include <cstddef>

namespace game {

/// Returns a non-negative int as an index into an array.
constexpr std::size_t at(int index) { return static_cast<std::size_t>(index); }

}  // namespace game
