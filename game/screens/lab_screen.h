#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>

#include "engine/tick/tick.h"
#include "game/lab/experiment.h"
#include "game/lab/history.h"
#include "game/lab_view/console.h"
#include "game/lab_view/tick_cost.h"
#include "game/screens/screen.h"
#include "game/screens/session.h"
#include "game/simulation/level.h"

namespace game {

/// The lab: a scene that runs, with its sliders, buttons and plots. The mouse drags what is in it.
class LabScreen : public Screen {
 public:
  /// `scene`: its name. The session must outlive the screen. Throws std::runtime_error with the names that are accepted
  /// for another one.
  LabScreen(Session& session, std::string_view scene);

  std::string title() const override;
  Next update(const Frame& frame) override;
  void draw(engine::Canvas& canvas, double text_scale) override;
  bool takes_fingers_as_mouse() const override { return true; }

  /// Runs one tick, without input.
  void tick() { run_tick({}); }
  const lab::Experiment& experiment() const { return *experiment_; }
  bool is_paused() const { return paused_; }

 private:
  void open(const lab::Scene& scene);
  void restart();
  bool act(const lab::ConsoleRequest& request);
  bool press(lab::Button button);
  void read_keys(const Frame& frame);
  engine::TickInput take_pointer(const Frame& frame);
  void run_tick(const engine::TickInput& input);

  Session* session_;
  std::unique_ptr<lab::Experiment> experiment_;
  lab::Console console_;
  lab::History history_;
  std::array<lab::TickCost, 2> costs_;  // of the benches
  engine::FixedTick clock_{ticks_per_second, 2};
  bool paused_ = false;
  bool wants_step_ = false;
  bool drags_ = false;
  int slowed_ = 1;
};

}  // namespace game
