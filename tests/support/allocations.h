#pragma once

namespace test_support {

/// Counts calls of operator new in this program since its construction.
class AllocationCount {
 public:
  AllocationCount();
  long so_far() const;
  /// Returns the number of blocks allocated since then that are not yet freed.
  long held() const;

 private:
  long start_;
  long held_at_start_;
};

}  // namespace test_support
