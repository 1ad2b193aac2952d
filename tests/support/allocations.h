#pragma once

namespace test_support {

/// Counts calls of operator new in this program from its making on.
class AllocationCount {
 public:
  AllocationCount();
  long so_far() const;
  /// By how many blocks more are held than then: what has been given back is not counted.
  long held() const;

 private:
  long start_;
  long held_at_start_;
};

}  // namespace test_support
