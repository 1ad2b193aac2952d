#pragma once

#include <algorithm>
#include <atomic>
#include <cassert>

namespace ribbon {

/// A user's function that runs tasks in parallel, and its context. The library creates no threads: without such a
/// function the calling thread does all work. The results have the same bits for any number of workers and any order of
/// tasks.
struct ParallelFor {
  /// Runs one task. `data` is passed through from `run`.
  using Task = void (*)(void* data, int index);
  /// Calls task(data, index) exactly once for each index 0 … count − 1, from any threads and in any order, and
  /// returns after all calls have returned. Builds with assertions check this. Tasks do not throw, do not wait, and
  /// allocate only when there is more work than ever before.
  void (*run)(void* context, int count, Task task, void* data) = nullptr;
  void* context = nullptr;  ///< passed to `run`
  int workers = 1;          ///< number of tasks that run at the same time, 1 or more; determines how work is divided

  /// Returns the number of parts for `count` items of similar size, with at least `min_items` items per part.
  int parts(int count, int min_items) const {
    if (run == nullptr || workers <= 1) return 1;
    return std::clamp(count / min_items, 1, parts_per_worker * workers);
  }

  /// Calls function(index) for each index 0 … count − 1.
  template <typename Function>
  void operator()(int count, Function&& function) const {
    if (run == nullptr || count <= 1) {
      for (int index = 0; index < count; ++index) function(index);
      return;
    }
    struct Call {
      Function* function;
      std::atomic<int> done;
    } call{&function, 0};
    run(
        context, count,
        [](void* passed, int index) {
          auto& current = *static_cast<Call*>(passed);
          (*current.function)(index);
          current.done.fetch_add(1, std::memory_order_relaxed);
        },
        &call);
    assert(call.done == count && "the parallel-for did not run each task once before it returned");
  }

 private:
  static constexpr int parts_per_worker = 8;  // more: each part costs a call; fewer: workers wait for the last part
};

/// Throws DefinitionError for less than one worker.
void check(const ParallelFor& parallel_for);

}  // namespace ribbon
