#include "game/screens/lab_screen.h"

#include <utility>

#include "engine/window/sdl_window.h"
#include "game/lab_view/head.h"
#include "game/lab_view/plot.h"
#include "game/lab_view/world_view.h"
#include "game/simulation/buttons.h"
#include "game/words/lab_words.h"
#include "game/words/words.h"

namespace game {
namespace {

/// Measures the ticks of the benches by the clock on the wall.
class Stopwatch : public lab::BenchWatch {
 public:
  explicit Stopwatch(std::array<lab::TickCost, 2>& costs) : costs_(&costs) {}
  void begins(std::size_t) override { start_ns_ = engine::now_ns(); }
  void ends(std::size_t bench) override { (*costs_)[bench].add(engine::now_ns() - start_ns_); }

 private:
  std::array<lab::TickCost, 2>* costs_;
  std::int64_t start_ns_ = 0;
};

}  // namespace

LabScreen::LabScreen(Session& session, std::string_view scene) : session_(&session) { open(lab::scene_named(scene)); }

void LabScreen::open(const lab::Scene& scene) {
  experiment_ = std::make_unique<lab::Experiment>(scene);
  experiment_->use(session_->workers.parallel_for());
  restart();
}

void LabScreen::restart() {
  experiment_->restart();
  history_.forget();
  for (lab::TickCost& cost : costs_) cost.forget();
  drags_ = false;
}

std::string LabScreen::title() const {
  return words::filled(words::screen_lab, {{"scene", lab::words_of(experiment_->scene()).title}});
}

Next LabScreen::update(const Frame& frame) {
  if (frame.menu.back) return Next::back();
  const lab::Layout layout = lab::layout_of(frame.canvas, frame.text_scale);
  const engine::WindowInput& input = frame.input;
  const lab::ConsoleRequest request = console_.update({.down = frame.menu.down,
                                                       .right = frame.menu.right,
                                                       .accept = frame.menu.accept,
                                                       .mouse = input.mouse,
                                                       .mouse_moved = input.mouse_moved,
                                                       .pressed = input.pressed(engine::MouseButton::left),
                                                       .held = input.held(engine::MouseButton::left)},
                                                      *experiment_, layout);
  if (!act(request)) return Next::back();
  read_keys(frame);
  const engine::TickInput pointer = take_pointer(frame);
  const int due = clock_.advance(frame.elapsed_ns / slowed_);
  const int ticks = paused_ ? (std::exchange(wants_step_, false) ? 1 : 0) : due;
  for (int k = 0; k < ticks; ++k) run_tick(pointer);
  return Next::stay();
}

/// Returns false for the button that leaves the lab.
bool LabScreen::act(const lab::ConsoleRequest& request) {
  if (request.scene) open(lab::scenes()[*request.scene]);
  if (request.turn) {
    const int before = experiment_->ticks();
    experiment_->set(request.turn->knob, request.turn->value);
    if (experiment_->ticks() < before) drags_ = false;  // it began again
  }
  return !request.button || press(*request.button);
}

bool LabScreen::press(lab::Button button) {
  switch (button) {
    case lab::Button::pause: paused_ = !paused_; return true;
    case lab::Button::step: paused_ = wants_step_ = true; return true;
    case lab::Button::slow: slowed_ = slowed_ == 4 ? 1 : 2 * slowed_; return true;
    case lab::Button::restart: restart(); return true;
    case lab::Button::back: return false;
  }
  return true;
}

void LabScreen::read_keys(const Frame& frame) {
  const auto pressed = [&](Action action) { return session_->settings.bindings.pressed(action, frame.input); };
  if (pressed(Action::pause)) press(lab::Button::pause);
  if (pressed(Action::step)) press(lab::Button::step);
  if (pressed(Action::slow_motion)) press(lab::Button::slow);
  if (pressed(Action::restart)) press(lab::Button::restart);
}

/// Returns the pointer for the ticks of a frame. A drag begins in the world, and goes on wherever the pointer is.
engine::TickInput LabScreen::take_pointer(const Frame& frame) {
  const lab::Layout layout = lab::layout_of(frame.canvas, frame.text_scale);
  const engine::WindowInput& input = frame.input;
  if (input.pressed(engine::MouseButton::left)) drags_ = !console_.takes_mouse(input.mouse, layout);
  if (!input.held(engine::MouseButton::left)) drags_ = false;
  engine::TickInput pointer;
  engine::set_pointer(pointer, lab::to_world(experiment_->scene(), layout.world, input.mouse));
  if (drags_) pointer.buttons |= button_drag;
  return pointer;
}

void LabScreen::run_tick(const engine::TickInput& input) {
  Stopwatch watch(costs_);
  experiment_->tick(input, &watch);
  history_.add(*experiment_);
}

void LabScreen::draw(engine::Canvas& canvas, double text_scale) {
  const lab::Layout layout = lab::layout_of(canvas, text_scale);
  const bool has_notice = !session_->notice.text().empty();
  lab::set_view(canvas, experiment_->scene(), layout.world);
  lab::draw_world(canvas, *experiment_, layout);
  lab::draw_head(canvas, *experiment_, lab::figures_of(*experiment_, costs_), layout, has_notice);
  lab::draw_plots(canvas, history_, experiment_->benches().size(), layout);
  console_.draw(canvas, *experiment_, {paused_, slowed_, has_notice, session_->uses_pad}, layout);
}

}  // namespace game
