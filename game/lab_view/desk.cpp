#include "game/lab_view/desk.h"

#include <utility>

#include "game/lab_view/head.h"
#include "game/lab_view/plot.h"
#include "game/lab_view/world_view.h"

namespace game::lab {
namespace {

/// Measures the ticks of the benches.
class Stopwatch : public BenchWatch {
 public:
  Stopwatch(std::array<TickCost, 2>& costs, Desk::Clock clock) : costs_(&costs), clock_(clock) {}
  void begins(std::size_t) override { start_ns_ = clock_(); }
  void ends(std::size_t bench) override { (*costs_)[bench].add(clock_() - start_ns_); }

 private:
  std::array<TickCost, 2>* costs_;
  Desk::Clock clock_;
  std::int64_t start_ns_ = 0;
};

}  // namespace

Desk::Desk(const Scene& scene, Clock clock, const ribbon::ParallelFor& parallel_for)
    : clock_(clock), parallel_for_(parallel_for) {
  open(scene);
}

void Desk::open(const Scene& scene) {
  experiment_ = std::make_unique<Experiment>(scene);
  experiment_->use(parallel_for_);
  console_.begin(static_cast<std::size_t>(&scene - scenes().data()));
  restart();
}

void Desk::restart() {
  experiment_->restart();
  history_.forget();
  for (TickCost& cost : costs_) cost.forget();
}

bool Desk::act(const ConsoleRequest& request) {
  if (request.scene) open(scenes()[*request.scene]);
  if (request.turn) experiment_->set(request.turn->knob, request.turn->value);
  return !request.button || press(*request.button);
}

bool Desk::press(Button button) {
  switch (button) {
    case Button::pause: state_.paused = !state_.paused; return true;
    case Button::step: state_.paused = wants_step_ = true; return true;
    case Button::slow: state_.slowed = state_.slowed == 4 ? 1 : 2 * state_.slowed; return true;
    case Button::restart: restart(); return true;
    case Button::back: return false;
  }
  return true;
}

int Desk::ticks_to_run(int due) {
  const bool steps = std::exchange(wants_step_, false);
  return state_.paused ? static_cast<int>(steps) : due;
}

void Desk::tick(const engine::TickInput& input) {
  Stopwatch watch(costs_, clock_);
  experiment_->tick(input, &watch);
  history_.add(*experiment_);
}

void Desk::draw(engine::Canvas& canvas, double text_scale, bool has_notice, bool uses_pad) {
  const Layout layout = layout_of(canvas, text_scale);
  state_.has_notice = has_notice;
  state_.uses_pad = uses_pad;
  set_view(canvas, experiment_->scene(), layout.world);
  draw_world(canvas, *experiment_, layout);
  draw_head(canvas, *experiment_, figures_of(*experiment_, costs_), layout, has_notice);
  draw_plots(canvas, history_, experiment_->benches().size(), layout);
  console_.draw(canvas, *experiment_, state_, layout);
}

}  // namespace game::lab
