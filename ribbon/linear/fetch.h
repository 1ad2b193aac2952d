#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace ribbon {

// Where there are many cords, the memory of each is far from the processor when its turn comes, and to wait for it
// takes longer than to solve a short rope. So a loop over cords fetches the memory of the next ones while it works.
// That changes nothing but the speed.

/// Starts to fetch the cache line of an address. There need be nothing at that address.
inline void fetch_line(const void* address) {
#if defined(__GNUC__)
  __builtin_prefetch(address);
#else
  (void)address;
#endif
}

/// Starts to fetch so many bytes from an address on.
inline void fetch_bytes(const void* address, std::size_t bytes) {
  constexpr std::size_t cache_line = 64;  // bytes
  const auto* const first = static_cast<const std::byte*>(address);
  for (std::size_t at = 0; at < bytes; at += cache_line) fetch_line(first + at);
}

/// Starts to fetch a list, or the start of a long one: the processor follows by itself.
template <typename T>
void fetch_list(const std::vector<T>& list) {
  constexpr std::size_t max_bytes = 1024;
  fetch_bytes(list.data(), std::min(list.size() * sizeof(T), max_bytes));
}

}  // namespace ribbon
