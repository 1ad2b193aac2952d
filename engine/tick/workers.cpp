#include "engine/tick/workers.h"

#include <algorithm>

namespace engine {
namespace {

constexpr int waiting_turns = 200;  // of the caller, before it sleeps: to wake it up takes longer than most last tasks

/// Returns the first task of a worker's share.
int first_of(int worker, int workers, int count) {
  return static_cast<int>(static_cast<std::int64_t>(count) * worker / workers);
}

}  // namespace

Workers::Workers() : Workers(static_cast<int>(std::thread::hardware_concurrency())) {}

Workers::Workers(int count) : shares_(static_cast<std::size_t>(std::max(count, 1))) {
  for (std::size_t k = 1; k < shares_.size(); ++k) threads_.emplace_back([this, k] { serve(k); });
}

Workers::~Workers() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  has_work_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

ribbon::ParallelFor Workers::parallel_for() {
  const auto run = [](void* self, int count, Task task, void* things) {
    static_cast<Workers*>(self)->run(count, task, things);
  };
  return {run, this, static_cast<int>(threads_.size()) + 1};
}

void Workers::run(int count, Task task, void* things) {
  {
    const std::lock_guard lock(mutex_);
    task_ = task;
    things_ = things;
    const int workers = static_cast<int>(shares_.size());
    for (int k = 0; k < workers; ++k) {
      Share& share = shares_[static_cast<std::size_t>(k)];
      share.next = first_of(k, workers, count);
      share.end = first_of(k + 1, workers, count);
    }
    ++call_;
    open_ = true;
  }
  has_work_.notify_all();
  work(0);
  {
    const std::lock_guard lock(mutex_);
    open_ = false;  // all indices are taken: a thread that wakes up now must not join
  }
  wait_for_helpers();
}

void Workers::wait_for_helpers() {
  for (int turn = 0; turn < waiting_turns; ++turn) {
    if (helpers_ == 0) return;
    std::this_thread::yield();
  }
  std::unique_lock lock(mutex_);
  is_left_.wait(lock, [this] { return helpers_ == 0; });
}

/// Runs tasks of the current call until all indices are taken: those of its own share first.
void Workers::work(std::size_t worker) {
  for (std::size_t k = 0; k < shares_.size(); ++k) {
    Share& share = shares_[(worker + k) % shares_.size()];
    for (int index = share.next++; index < share.end; index = share.next++) task_(things_, index);
  }
}

/// The loop of each thread: waits for a call, helps with it once, and ends when the object is destroyed.
void Workers::serve(std::size_t worker) {
  std::uint64_t done = 0;
  std::unique_lock lock(mutex_);
  for (;;) {
    has_work_.wait(lock, [&] { return ends_ || (open_ && call_ != done); });
    if (ends_) return;
    done = call_;
    ++helpers_;
    lock.unlock();
    work(worker);
    lock.lock();
    if (--helpers_ == 0) is_left_.notify_one();
  }
}

}  // namespace engine
