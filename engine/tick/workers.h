#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

#include "ribbon/parallel_for.h"

namespace engine {

/// Threads that wait for things to do side by side. One of them is the caller's.
class Workers {
 public:
  /// One a core.
  Workers();
  /// So many, the caller among them; at least that one.
  explicit Workers(int count);
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;
  /// Ends the threads. Nothing is being done then.
  ~Workers();

  /// For ribbon::DirectSolver::use and Coupling::use. They outlive what uses them; one thread at a time calls it, and
  /// no task does.
  ribbon::ParallelFor parallel_for();

 private:
  using Task = ribbon::ParallelFor::Task;

  void run(int count, Task task, void* things);
  void work();
  void serve();

  std::mutex mutex_;
  std::condition_variable has_work_;
  std::condition_variable is_left_;
  // Under the mutex: a number for each call, whether it still takes helpers, and how many it has.
  std::uint64_t call_ = 0;
  bool open_ = false;
  bool ends_ = false;
  int helpers_ = 0;
  // Of the call that is open:
  int count_ = 0;
  Task task_ = nullptr;
  void* things_ = nullptr;
  std::atomic<int> next_{0};
  std::vector<std::thread> threads_;
};

}  // namespace engine
