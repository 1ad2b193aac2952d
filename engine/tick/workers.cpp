#include "engine/tick/workers.h"

namespace engine {

Workers::Workers() : Workers(static_cast<int>(std::thread::hardware_concurrency())) {}

Workers::Workers(int count) {
  for (int k = 1; k < count; ++k) threads_.emplace_back([this] { serve(); });
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
    count_ = count;
    task_ = task;
    things_ = things;
    next_ = 0;
    ++call_;
    open_ = true;
  }
  has_work_.notify_all();
  work();
  std::unique_lock lock(mutex_);
  open_ = false;  // all indices are taken: a thread that wakes up now must not join
  is_left_.wait(lock, [this] { return helpers_ == 0; });
}

/// Runs tasks of the current call until all indices are taken.
void Workers::work() {
  for (int index = next_++; index < count_; index = next_++) task_(things_, index);
}

/// The loop of each thread: waits for a call, helps with it once, and ends when the object is destroyed.
void Workers::serve() {
  std::uint64_t done = 0;
  std::unique_lock lock(mutex_);
  for (;;) {
    has_work_.wait(lock, [&] { return ends_ || (open_ && call_ != done); });
    if (ends_) return;
    done = call_;
    ++helpers_;
    lock.unlock();
    work();
    lock.lock();
    if (--helpers_ == 0) is_left_.notify_one();
  }
}

}  // namespace engine
