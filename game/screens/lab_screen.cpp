#include "game/screens/lab_screen.h"

#include "engine/window/sdl_window.h"
#include "game/lab_view/head.h"
#include "game/lab_view/world_view.h"
#include "game/simulation/buttons.h"
#include "game/words/words.h"

namespace game {

LabScreen::LabScreen(Session& session, std::string_view scene)
    : session_(&session),
      desk_(scene.empty() ? lab::scenes().front() : lab::scene_named(scene), engine::now_ns,
            session.workers.parallel_for()) {}

std::string LabScreen::title() const {
  return words::filled(words::screen_lab, {{"scene", lab::words_of(experiment().scene()).title}});
}

Next LabScreen::update(const Frame& frame) {
  if (frame.menu.back) return Next::back();
  const lab::Layout layout = lab::layout_of(frame.canvas, frame.text_scale);
  const engine::WindowInput& input = frame.input;
  const lab::ConsoleRequest request = desk_.console().update({.down = frame.menu.down,
                                                              .right = frame.menu.right,
                                                              .accept = frame.menu.accept,
                                                              .mouse = input.mouse,
                                                              .pressed = input.pressed(engine::MouseButton::left),
                                                              .held = input.held(engine::MouseButton::left)},
                                                             experiment(), layout);
  if (!desk_.act(request)) return Next::back();
  read_keys(input);
  const engine::TickInput pointer = pointer_of(input, layout);
  desk_.run(frame.elapsed_ns, pointer);
  return Next::stay();
}

void LabScreen::read_keys(const engine::WindowInput& input) {
  const auto pressed = [&](Action action) { return session_->settings.bindings.pressed(action, input); };
  if (pressed(Action::pause)) desk_.press(lab::Button::pause);
  if (pressed(Action::step)) desk_.press(lab::Button::step);
  if (pressed(Action::slow_motion)) desk_.press(lab::Button::slow);
  if (pressed(Action::restart)) desk_.press(lab::Button::restart);
}

/// Returns the pointer for the ticks of a frame. A drag begins in the world, and goes on wherever the pointer is.
engine::TickInput LabScreen::pointer_of(const engine::WindowInput& input, const lab::Layout& layout) {
  if (input.pressed(engine::MouseButton::left)) drags_ = !desk_.console().takes_mouse(input.mouse, layout);
  if (!input.held(engine::MouseButton::left)) {
    drags_ = false;
    desk_.let_go();
  }
  engine::TickInput pointer;
  engine::set_pointer(pointer, lab::to_world(experiment().scene(), layout.world, input.mouse));
  if (drags_) pointer.buttons |= button_drag;
  return pointer;
}

void LabScreen::draw(engine::Canvas& canvas, double text_scale) {
  desk_.draw(canvas, text_scale, !session_->notice.text().empty(), session_->uses_pad);
}

}  // namespace game
