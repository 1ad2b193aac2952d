#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ribbon::box2d {

/// Maps addresses to indices. It cannot be iterated, so results do not depend on the order of addresses. It keeps its
/// memory when cleared.
class AddressTable {
 public:
  /// Returns the index of an address, or −1.
  int find(const void* address) const {
    if (slots_.empty()) return -1;
    for (std::size_t k = first_slot(address);; k = (k + 1) & (slots_.size() - 1)) {
      if (slots_[k].address == address) return slots_[k].place;
      if (slots_[k].address == nullptr) return -1;
    }
  }
  /// Sets the index of an address, which is not null.
  void set(const void* address, int place) {
    if (2 * (count_ + 1) > slots_.size()) grow();
    put(address, place);
  }
  /// Removes all addresses.
  void clear() {
    if (count_ > 0) std::fill(slots_.begin(), slots_.end(), Slot{});
    count_ = 0;
  }
  /// Reserves memory for so many addresses.
  void reserve(std::size_t count) {
    while (2 * (count + 1) > slots_.size()) grow();
  }

 private:
  struct Slot {
    const void* address = nullptr;
    int place = -1;
  };
  static constexpr std::size_t least_slots = 16;  // a power of two, as they all are

  std::size_t first_slot(const void* address) const {
    const auto bits = static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(address));
    return static_cast<std::size_t>((bits * 0x9e3779b97f4a7c15U) >> 32U) & (slots_.size() - 1);
  }
  void put(const void* address, int place) {
    std::size_t k = first_slot(address);
    while (slots_[k].address != nullptr && slots_[k].address != address) k = (k + 1) & (slots_.size() - 1);
    count_ += slots_[k].address == nullptr;
    slots_[k] = {address, place};
  }
  void grow() {
    std::vector<Slot> before(std::max(least_slots, 2 * slots_.size()));
    before.swap(slots_);
    count_ = 0;
    for (const Slot& slot : before) {
      if (slot.address != nullptr) put(slot.address, slot.place);
    }
  }

  std::vector<Slot> slots_;
  std::size_t count_ = 0;
};

}  // namespace ribbon::box2d
