#pragma once

#include <cstddef>

namespace test_support {

/// Returns an index of the library, which is an int, as one of a standard container.
constexpr std::size_t slot(int index) { return static_cast<std::size_t>(index); }

}  // namespace test_support
