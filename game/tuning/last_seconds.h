#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "engine/tick/input.h"
#include "game/simulation/level.h"
#include "game/simulation/meter.h"
#include "game/simulation/simulation.h"
#include "ribbon/cord_def.h"

namespace game {

/// A named accuracy for all cords of a run.
struct Preset {
  const char* name;
  ribbon::Accuracy accuracy;
};
/// Returns the presets of ribbon::Accuracy, the cheapest first.
std::span<const Preset> presets();

/// The last ten seconds of a run once more, beside the same with another accuracy of its cords.
///
/// Both are runs with the same inputs. In the second one the cords of the direct solver, and lines that are thrown,
/// have the other accuracy from ten seconds before the end on.
class LastSeconds {
 public:
  static constexpr int max_ticks = 10 * ticks_per_second;

  /// `inputs`: of all ticks since the start of a run of the level.
  LastSeconds(Level level, std::vector<engine::TickInput> inputs, const ribbon::Accuracy& accuracy);
  LastSeconds(const LastSeconds&) = delete;
  LastSeconds& operator=(const LastSeconds&) = delete;

  /// Runs up to so many of the ticks before the last seconds. Returns whether the last seconds may begin.
  bool approach(int ticks);
  /// The share of those ticks that has been run, 0 … 1.
  double progress() const;

  /// Runs a tick of both. Precondition: approach() has returned true, and not is_over().
  void tick();
  bool is_over() const { return next_ == inputs_.size(); }
  /// Goes back to the start of the run: approach() must be called again. The last seconds are then the same.
  void rewind();

  /// The run as it was played, and the one with the other accuracy.
  const Simulation& played() const { return *played_; }
  const Simulation& other() const { return *other_; }
  const Meter& played_meter() const { return played_meter_; }
  const Meter& other_meter() const { return other_meter_; }

  /// Where the runs differ most: a point of a cord, or a player, that both have.
  struct Gap {
    ribbon::Vec2 played, other;  ///< m
    double size() const { return length(other - played); }
    int tick = 0;  ///< of the last seconds, from 1
  };
  /// After the last tick; nothing before the first one.
  const std::optional<Gap>& gap() const { return gap_; }
  /// The largest one up to now.
  const std::optional<Gap>& largest_gap() const { return largest_gap_; }

 private:
  void make_runs();
  void set_accuracy();
  void find_gap();

  const Level level_;
  const std::vector<engine::TickInput> inputs_;
  const ribbon::Accuracy accuracy_;
  const std::size_t first_;  // tick of the last seconds
  std::size_t next_ = 0;     // tick of both runs
  std::optional<Simulation> played_, other_;
  Meter played_meter_, other_meter_;
  std::optional<Gap> gap_, largest_gap_;
};

}  // namespace game
