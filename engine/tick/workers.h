#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

#include "ribbon/parallel_for.h"

namespace engine {

/// A pool of threads that run tasks in parallel. The calling thread is one of the workers.
///
/// Each worker begins with its own share of the tasks: the same ones in each call with as many tasks. What they work on
/// is then likely in the cache of its core. It goes on with tasks of the other shares.
class Workers {
 public:
  /// One worker per core.
  Workers();
  /// `count` workers, including the calling thread; values below 1 count as 1.
  explicit Workers(int count);
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;
  /// Ends the threads. No task may be running.
  ~Workers();

  /// For ribbon::DirectSolver::use and Coupling::use. The pool must outlive what uses it. Only one thread at a time may
  /// call it, and no task may.
  ribbon::ParallelFor parallel_for();

 private:
  using Task = ribbon::ParallelFor::Task;
  /// The tasks that a worker begins with.
  struct alignas(64) Share {  // a cache line, because several threads write to it
    std::atomic<int> next{0};
    int end = 0;
  };

  void run(int count, Task task, void* things);
  void work(std::size_t worker);
  void serve(std::size_t worker);
  void wait_for_helpers();

  std::mutex mutex_;
  std::condition_variable has_work_;
  std::condition_variable is_left_;
  // Guarded by the mutex:
  std::uint64_t call_ = 0;  // counts the calls
  bool open_ = false;       // threads may join the current call
  bool ends_ = false;
  std::atomic<int> helpers_{0};  // threads that work on the current call; changed under the mutex only
  // Of the current call:
  Task task_ = nullptr;
  void* things_ = nullptr;
  std::vector<Share> shares_;  // by worker
  std::vector<std::thread> threads_;
};

}  // namespace engine
