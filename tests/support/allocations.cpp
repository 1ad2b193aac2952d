#include "tests/support/allocations.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<long> allocations{0};
std::atomic<long> releases{0};

void release(void* memory) {
  if (memory != nullptr) ++releases;
  std::free(memory);
}

}  // namespace

// The array forms call these. So does the nothrow form, except that of AddressSanitizer, whose memory is not for
// free().
void* operator new(std::size_t size, const std::nothrow_t& /*tag*/) noexcept {
  ++allocations;
  return std::malloc(size == 0 ? 1 : size);
}
void* operator new(std::size_t size) {
  void* memory = operator new(size, std::nothrow);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

void operator delete(void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }
void operator delete(void* memory, const std::nothrow_t& /*tag*/) noexcept { release(memory); }

namespace test_support {

AllocationCount::AllocationCount() : start_(allocations), held_at_start_(allocations - releases) {}

long AllocationCount::so_far() const { return allocations - start_; }

long AllocationCount::held() const { return allocations - releases - held_at_start_; }

}  // namespace test_support
