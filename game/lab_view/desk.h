#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "engine/draw/canvas.h"
#include "engine/tick/input.h"
#include "game/lab/experiment.h"
#include "game/lab/history.h"
#include "game/lab_view/console.h"
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
  /// Returns how many ticks to run now if `due` have elapsed at the present speed.
  int ticks_to_run(int due);
  void tick(const engine::TickInput& input = {});

  /// Draws everything. `has_notice`: a notice covers the strip at the top.
  void draw(engine::Canvas& canvas, double text_scale, bool has_notice = false, bool uses_pad = false);

 private:
  void restart();

  Clock clock_;
  ribbon::ParallelFor parallel_for_;
  std::unique_ptr<Experiment> experiment_;
  Console console_;
  History history_;
  std::array<TickCost, 2> costs_;  // of the benches
  ConsoleState state_;
  bool wants_step_ = false;
};

}  // namespace game::lab
