#pragma once

#include <algorithm>
#include <atomic>
#include <cassert>

namespace ribbon {

/// The user's way to use several cores: a function that does things side by side, and what it needs for that. The
/// library has no threads of its own, and without one all is done by the caller. Whatever the order in which things are
/// done, and however many workers there are, the results have the same bits.
struct ParallelFor {
  /// Does the index-th of some things.
  using Task = void (*)(void* things, int index);
  /// Calls task(things, index) once for each index of 0 … count − 1, from any threads, in any order and at the same
  /// time, and returns when all of these calls have returned: else builds with assertions stop there. The tasks throw
  /// nothing, allocate only when there is more to do than ever before, and do not wait.
  void (*run)(void* context, int count, Task task, void* things) = nullptr;
  void* context = nullptr;  ///< handed to `run`
  int workers = 1;          ///< how many calls may be done at the same time, which decides how work is divided; above 0

  /// Into how many parts work is divided that has `count` things of about one size, at least `least` a part.
  int parts(int count, int least) const {
    if (run == nullptr || workers <= 1) return 1;
    return std::clamp(count / least, 1, parts_a_worker * workers);
  }

  /// Does function(index) for each index of 0 … count − 1.
  template <typename Function>
  void operator()(int count, Function&& function) const {
    if (run == nullptr || count <= 1) {
      for (int index = 0; index < count; ++index) function(index);
      return;
    }
    struct Things {
      Function* function;
      std::atomic<int> done;
    } things{&function, 0};
    run(
        context, count,
        [](void* all, int index) {
          auto& these = *static_cast<Things*>(all);
          (*these.function)(index);
          these.done.fetch_add(1, std::memory_order_relaxed);
        },
        &things);
    assert(things.done == count && "the parallel-for did not do each thing once before it returned");
  }

 private:
  static constexpr int parts_a_worker = 8;  // more: each costs a call; fewer: the last one keeps the others waiting
};

/// Throws DefinitionError for fewer workers than one.
void check(const ParallelFor& parallel_for);

}  // namespace ribbon
