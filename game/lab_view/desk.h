#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "engine/draw/canvas.h"
#include "engine/tick/input.h"
#include "engine/tick/tick.h"
#include "game/lab/experiment.h"
#include "game/lab/history.h"
#include "game/lab_view/console.h"
#include "game/lab_view/picture.h"
#include "game/lab_view/tick_cost.h"
#include "ribbon/parallel_for.h"

namespace game::lab {

/// An experiment with what belongs to its screen: console, history, cost, and whether it is paused or slowed. It needs
/// no window.
class Desk {
 public:
  /// Returns the nanoseconds of some clock, for the costs that are shown.
  using Clock = std::int64_t (*)();

  /// `parallel_for`: for the cords of all scenes.
  Desk(const Scene& scene, Clock clock, const ribbon::ParallelFor& parallel_for = {});

  const Experiment& experiment() const { return *experiment_; }
  Console& console() { return console_; }
  const ConsoleState& state() const { return state_; }

  void open(const Scene& scene);
  /// Does what the console asks for. Returns false for the button that leaves the lab.
  bool act(const ConsoleRequest& request);
  bool press(Button button);
  /// Lets `elapsed_ns` nanoseconds of real time pass: runs the ticks that are due, or the one that a step wants.
  void run(std::int64_t elapsed_ns, const engine::TickInput& input);
  void tick(const engine::TickInput& input = {});
  /// Ends a drag now, since the next tick may be far.
  void let_go() { experiment_->let_go(); }

  /// Returns what it draws: what is between the last two ticks while they run, else the last one.
  Picture picture() const;
  /// Draws everything. `has_notice`: a notice covers the strip at the top.
  void draw(engine::Canvas& canvas, double text_scale, bool has_notice = false, bool uses_pad = false);

 private:
  void restart();
  void turn(const ConsoleRequest::Turn& turn);

  Clock clock_;
  ribbon::ParallelFor parallel_for_;
  std::unique_ptr<Experiment> experiment_;
  Console console_;
  History history_;
  std::array<TickCost, 2> costs_;  // of the benches
  ConsoleState state_;
  engine::FixedTick ticker_{Bench::ticks_per_second, 2};
  Picture before_;  // the last tick
  bool wants_step_ = false;
  bool stands_still_ = true;  // the last tick is shown as it is, until the next one
};

}  // namespace game::lab
