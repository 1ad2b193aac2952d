#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

#include "ribbon/parallel_for.h"

namespace engine {

/// A pool of threads that run tasks in parallel. The calling thread is one of the workers.
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

  void run(int count, Task task, void* things);
  void work();
  void serve();

  std::mutex mutex_;
  std::condition_variable has_work_;
  std::condition_variable is_left_;
  // Guarded by the mutex:
  std::uint64_t call_ = 0;  // counts the calls
  bool open_ = false;       // threads may join the current call
  bool ends_ = false;
  int helpers_ = 0;  // threads that work on the current call
  // Of the current call:
  int count_ = 0;
  Task task_ = nullptr;
  void* things_ = nullptr;
  std::atomic<int> next_{0};
  std::vector<std::thread> threads_;
};

}  // namespace engine
