#pragma once

namespace test_support {

/// Counts calls of operator new in this program from its making on.
class AllocationCount {
 public:
  AllocationCount();
  long so_far() const;

 private:
  long start_;
};

}  // namespace test_support
