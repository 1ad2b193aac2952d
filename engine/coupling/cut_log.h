#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "ribbon/box2d/coupling_types.h"

namespace ribbon::box2d {

/// The cuts of cords. The events of a tick are those of the calls before it and of the links that broke in it.
class CutLog {
 public:
  void reserve(std::size_t events) { events_.reserve(events); }
  void add(const CutEvent& event) { events_.push_back(event); }
  /// Says that the last cut was a break under this tension [N].
  void last_broke(double tension) {
    events_.back().broke = true;
    events_.back().tension = tension;
  }
  /// Begins a step: the events of the last tick are over, those of calls since then stay.
  void begin_step() {
    events_.erase(events_.begin(), events_.begin() + static_cast<std::ptrdiff_t>(old_));
    old_ = 0;
  }
  /// Ends a tick.
  void end_tick() { old_ = events_.size(); }

  /// Returns the events of the last tick, and behind them those of calls since then.
  std::span<const CutEvent> events() const { return events_; }
  /// Returns how many of the events are of the last tick.
  std::size_t old() const { return old_; }
  /// Replaces the events.
  void restore(std::span<const CutEvent> events, std::size_t old) {
    events_.assign(events.begin(), events.end());
    old_ = old;
  }

 private:
  std::vector<CutEvent> events_;
  std::size_t old_ = 0;
};

}  // namespace ribbon::box2d
