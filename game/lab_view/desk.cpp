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

/// Returns the factor of slow motion behind this one: full speed, 1/2, 1/4, 1/10.
int slower(int factor) { return factor == 4 ? 10 : factor == 10 ? 1 : 2 * factor; }

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
  stands_still_ = true;
  history_.forget();
  for (TickCost& cost : costs_) cost.forget();
}

bool Desk::act(const ConsoleRequest& request) {
  if (request.scene) open(scenes()[*request.scene]);
  if (request.turn) turn(*request.turn);
  return !request.button || press(*request.button);
}

/// Some knobs begin the scene anew.
void Desk::turn(const ConsoleRequest::Turn& turn) {
  const int ticks = experiment_->ticks();
  experiment_->set(turn.knob, turn.value);
  stands_still_ = stands_still_ || experiment_->ticks() < ticks;
}

bool Desk::press(Button button) {
  switch (button) {
    case Button::pause: state_.paused = !state_.paused; return true;
    case Button::step: state_.paused = wants_step_ = true; return true;
    case Button::slow: state_.slowed = slower(state_.slowed); return true;
    case Button::restart: restart(); return true;
    case Button::back: return false;
  }
  return true;
}

/// A pause lets the picture move on to the last tick, so that it neither jumps there nor shows another state than the
/// figures.
void Desk::run(std::int64_t elapsed_ns, const engine::TickInput& input) {
  const int due = ticker_.advance(elapsed_ns / state_.slowed);
  if (std::exchange(wants_step_, false)) {
    tick(input);
    stands_still_ = true;
  } else if (due > 0) {
    stands_still_ = state_.paused;
    for (int ticks = state_.paused ? 0 : due; ticks > 0; --ticks) tick(input);
  }
}

void Desk::tick(const engine::TickInput& input) {
  take_picture(before_, *experiment_);
  Stopwatch watch(costs_, clock_);
  experiment_->tick(input, &watch);
  history_.add(*experiment_);
}

Picture Desk::picture() const {
  Picture now;
  take_picture(now, *experiment_);
  return stands_still_ ? now : between(before_, now, ticker_.alpha());
}

void Desk::draw(engine::Canvas& canvas, double text_scale, bool has_notice, bool uses_pad) {
  const Layout layout = layout_of(canvas, text_scale);
  state_.has_notice = has_notice;
  state_.uses_pad = uses_pad;
  set_view(canvas, experiment_->scene(), layout.world);
  draw_world(canvas, *experiment_, picture(), layout);
  draw_head(canvas, *experiment_, figures_of(*experiment_, costs_), layout, has_notice);
  draw_plots(canvas, history_, experiment_->benches().size(), layout);
  console_.draw(canvas, *experiment_, state_, layout);
}

}  // namespace game::lab
