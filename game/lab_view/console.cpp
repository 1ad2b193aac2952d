#include "game/lab_view/console.h"

#include <algorithm>
#include <string>

#include "game/lab/figures.h"
#include "game/lab_view/head.h"
#include "game/lab_view/knob_words.h"
#include "game/lab_view/look.h"
#include "game/words/lab_words.h"
#include "game/words/words.h"

namespace game::lab {
namespace {

using engine::Align;
using engine::Canvas;
using ribbon::Vec2;

// Units of text.
constexpr double console_margin = 10.0;
constexpr double console_text_size = 14.5;
constexpr double console_title_size = 22.0;
constexpr double scene_height = 33.0;
constexpr double knob_height = 44.0;
constexpr double bar_height = 10.0;
constexpr double button_height = 36.0;
constexpr double button_gap = 8.0;
constexpr int buttons_in_row = 3;
constexpr double keys_size = 12.0;

bool contains(const Rectangle& place, Vec2 at) {
  const Vec2 off = at - place.corner;
  return off.x >= 0.0 && off.y >= 0.0 && off.x < place.size.x && off.y < place.size.y;
}

std::string label_of(Button button, const ConsoleState& state) {
  switch (button) {
    case Button::pause: return state.paused ? words::lab::go_on : words::lab::pause;
    case Button::step: return words::lab::step;
    case Button::slow:
      return state.slowed == 1 ? words::lab::full_speed
                               : words::filled(words::lab::slow, {{"factor", std::to_string(state.slowed)}});
    case Button::restart: return words::lab::restart;
    case Button::back: return words::lab::back;
  }
  return "";
}

/// Returns the value of a knob where the mouse is on its bar.
double value_under(Vec2 mouse, const KnobRange& range, const Rectangle& bar) {
  return range.value_at((mouse.x - bar.corner.x) / bar.size.x);
}

/// Returns the value of a knob, and of the substeps also how many cords do not take them.
std::string shown_value(Knob knob, const Experiment& experiment) {
  std::string text = value_in_words(knob, experiment.values()[knob]);
  const int others = knob == Knob::substeps ? cords_in_one_step(*experiment.benches().front()) : 0;
  if (others == 0) return text;
  return words::filled(words::lab::substeps_value, {{"number", text}, {"cords", std::to_string(others)}});
}

}  // namespace

Rectangle Console::scene_place(std::size_t scene, const Layout& layout) {
  const double height = scene_height * layout.unit;
  return {{layout.list.corner.x, top_strip * layout.unit + static_cast<double>(scene) * height},
          {layout.list.size.x, height}};
}

Rectangle Console::knob_place(std::size_t knob, const Layout& layout) {
  const double height = knob_height * layout.unit;
  return {{layout.panel.corner.x, top_strip * layout.unit + static_cast<double>(knob) * height},
          {layout.panel.size.x, height}};
}

Rectangle Console::bar_place(std::size_t knob, const Layout& layout) {
  const Rectangle place = knob_place(knob, layout);
  const double side = console_margin * layout.unit;
  const double height = bar_height * layout.unit;
  return {place.corner + Vec2{side, place.size.y - height - 6.0 * layout.unit}, {place.size.x - 2.0 * side, height}};
}

Rectangle Console::button_place(Button button, const Layout& layout) {
  const int number = static_cast<int>(button);
  const int row = number / buttons_in_row;
  const int in_row = row == 0 ? buttons_in_row : button_count - buttons_in_row;
  const double gap = button_gap * layout.unit;
  const double side = console_margin * layout.unit;
  const double width = (layout.panel.size.x - 2.0 * side - (in_row - 1) * gap) / in_row;
  const double height = button_height * layout.unit;
  const double top = layout.panel.size.y - side - 2.0 * height - gap;
  return {{layout.panel.corner.x + side + (number % buttons_in_row) * (width + gap), top + row * (height + gap)},
          {width, height}};
}

void Console::begin(std::size_t scene) {
  focus_ = scene;
  slider_.reset();
}

bool Console::takes_mouse(Vec2 mouse, const Layout& layout) const {
  return slider_.has_value() || !contains(layout.world, mouse);
}

ConsoleRequest Console::update(const ConsoleInput& input, const Experiment& experiment, const Layout& layout) {
  if (!input.held && !input.pressed) slider_.reset();
  const std::size_t lines = scenes().size() + experiment.scene().knobs.size() + std::size_t{button_count};
  focus_ = std::min(focus_, lines - 1);
  if (input.down != 0) {
    const auto count = static_cast<int>(lines);
    focus_ = static_cast<std::size_t>(((static_cast<int>(focus_) + input.down) % count + count) % count);
  }
  if (input.pressed || slider_) return use_mouse(input, experiment, layout);
  return use_keys(input, experiment);
}

ConsoleRequest Console::use_mouse(const ConsoleInput& input, const Experiment& experiment, const Layout& layout) {
  ConsoleRequest request;
  const std::vector<KnobRange>& knobs = experiment.scene().knobs;
  for (std::size_t k = 0; input.pressed && k < scenes().size(); ++k) {
    if (!contains(scene_place(k, layout), input.mouse)) continue;
    request.scene = focus_ = k;
  }
  for (std::size_t k = 0; input.pressed && k < knobs.size(); ++k) {
    if (!contains(knob_place(k, layout), input.mouse)) continue;
    focus_ = scenes().size() + k;
    const KnobRange& range = knobs[k];
    if (range.scale == KnobRange::Scale::choice) {
      request.turn = {range.knob, range.stepped(experiment.values()[range.knob], 1)};
    } else {
      slider_ = k;
    }
  }
  for (int k = 0; input.pressed && k < button_count; ++k) {
    if (!contains(button_place(static_cast<Button>(k), layout), input.mouse)) continue;
    request.button = static_cast<Button>(k);
  }
  if (slider_) {
    const KnobRange& range = knobs[*slider_];
    request.turn = {range.knob, value_under(input.mouse, range, bar_place(*slider_, layout))};
  }
  return request;
}

ConsoleRequest Console::use_keys(const ConsoleInput& input, const Experiment& experiment) {
  ConsoleRequest request;
  const std::vector<KnobRange>& knobs = experiment.scene().knobs;
  if (focus_ < scenes().size()) {
    if (input.accept || input.right > 0) request.scene = focus_;
  } else if (focus_ < scenes().size() + knobs.size()) {
    const KnobRange& range = knobs[focus_ - scenes().size()];
    const int steps = input.right != 0 ? input.right : input.accept ? 1 : 0;
    if (steps != 0) request.turn = {range.knob, range.stepped(experiment.values()[range.knob], steps)};
  } else if (input.accept) {
    request.button = static_cast<Button>(focus_ - scenes().size() - knobs.size());
  }
  return request;
}

void Console::draw(Canvas& canvas, const Experiment& experiment, const ConsoleState& state,
                   const Layout& layout) const {
  canvas.panel(layout.list.corner, layout.list.size, 0.0, look::side);
  canvas.panel(layout.panel.corner, layout.panel.size, 0.0, look::side);
  draw_scenes(canvas, experiment, layout);
  if (!state.has_notice) {
    const double size = console_title_size * layout.unit;
    const double y = 0.5 * (top_strip * layout.unit - canvas.line_height(size));
    canvas.text(layout.list.corner + Vec2{console_margin * layout.unit, y}, words::lab::title, size, look::white);
  }
  for (std::size_t k = 0; k < experiment.scene().knobs.size(); ++k) draw_knob(canvas, experiment, k, layout);
  for (int k = 0; k < button_count; ++k) draw_button(canvas, static_cast<Button>(k), state, experiment, layout);
  const double size = keys_size * layout.unit;
  canvas.text({layout.list.corner.x + console_margin * layout.unit,
               layout.list.size.y - canvas.line_height(size) - 6.0 * layout.unit},
              state.uses_pad ? words::lab::buttons : words::lab::keys, size, look::faint);
}

void Console::draw_scenes(Canvas& canvas, const Experiment& experiment, const Layout& layout) const {
  const double size = console_text_size * layout.unit;
  for (std::size_t k = 0; k < scenes().size(); ++k) {
    const Rectangle place = scene_place(k, layout);
    const bool runs = &scenes()[k] == &experiment.scene();
    const Vec2 inset{4.0 * layout.unit, 2.0 * layout.unit};
    if (runs) canvas.panel(place.corner + inset, place.size - 2.0 * inset, 5.0 * layout.unit, look::button);
    if (focus_ == k)
      canvas.panel(place.corner + inset, {3.0 * layout.unit, place.size.y - 2.0 * inset.y}, 0.0, look::gold);
    canvas.text(place.corner + Vec2{14.0 * layout.unit, 0.5 * (place.size.y - canvas.line_height(size))},
                words_of(scenes()[k]).title, size, runs ? look::white : look::faint);
  }
}

void Console::draw_knob(Canvas& canvas, const Experiment& experiment, std::size_t knob, const Layout& layout) const {
  const KnobRange& range = experiment.scene().knobs[knob];
  const double value = experiment.values()[range.knob];
  const Rectangle place = knob_place(knob, layout);
  const Rectangle bar = bar_place(knob, layout);
  const double unit = layout.unit;
  const double size = console_text_size * unit;
  const bool focused = focus_ == scenes().size() + knob;
  if (focused)
    canvas.panel(place.corner + Vec2{2.0 * unit, 2.0 * unit}, {3.0 * unit, place.size.y - 4.0 * unit}, 0.0, look::gold);
  const double y = bar.corner.y - canvas.line_height(size) - 1.0 * unit;
  canvas.text({bar.corner.x, y}, name_of(range.knob), size, focused ? look::white : look::faint);
  canvas.text({bar.corner.x + bar.size.x, y}, shown_value(range.knob, experiment), size, look::white, Align::right);
  canvas.panel(bar.corner, bar.size, 0.5 * bar.size.y, look::field);
  const double share = range.position_of(value);
  const double at = bar.corner.x + share * bar.size.x;
  if (range.scale != KnobRange::Scale::choice)
    canvas.panel(bar.corner, {std::max(at - bar.corner.x, bar.size.y), bar.size.y}, 0.5 * bar.size.y, look::focus);
  engine::Mesh handle;
  add_disc(handle,
           {std::clamp(at, bar.corner.x + 0.5 * bar.size.y, bar.corner.x + bar.size.x - 0.5 * bar.size.y),
            bar.corner.y + 0.5 * bar.size.y},
           0.75 * bar.size.y);
  canvas.mesh(handle, focused ? look::gold : look::white);
}

void Console::draw_button(Canvas& canvas, Button button, const ConsoleState& state, const Experiment& experiment,
                          const Layout& layout) const {
  const Rectangle place = button_place(button, layout);
  const bool focused = focus_ == scenes().size() + experiment.scene().knobs.size() + static_cast<std::size_t>(button);
  const bool is_on = (button == Button::pause && state.paused) || (button == Button::slow && state.slowed > 1);
  canvas.panel(place.corner, place.size, 6.0 * layout.unit, focused || is_on ? look::focus : look::button);
  const double size = console_text_size * layout.unit;
  canvas.text(place.corner + Vec2{0.5 * place.size.x, 0.5 * (place.size.y - canvas.line_height(size))},
              label_of(button, state), size, focused ? look::gold : look::white, Align::center);
}

}  // namespace game::lab
