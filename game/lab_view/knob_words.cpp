#include "game/lab_view/knob_words.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "game/lab_view/numbers.h"
#include "game/words/lab_words.h"
#include "game/words/panel_words.h"
#include "game/words/words.h"

namespace game::lab {
namespace {

std::string filled_with(const char* text, double number) {
  return words::filled(text, {{"number", short_text(number)}});
}

const char* preset_name(double value) {
  constexpr std::array names = {words::panel::fast, words::panel::balanced, words::panel::accurate};
  return names[static_cast<std::size_t>(std::clamp(value, 0.0, 2.0))];
}

}  // namespace

const char* name_of(Knob knob) {
  switch (knob) {
    case Knob::load_ratio: return words::lab::load_ratio;
    case Knob::weight_ratio: return words::lab::weight_ratio;
    case Knob::start_angle: return words::lab::start_angle;
    case Knob::turns: return words::lab::turns;
    case Knob::count: return words::lab::count;
    case Knob::load_share: return words::lab::load_share;
    case Knob::may_sleep: return words::lab::may_sleep;
    case Knob::chain_substeps: return words::lab::chain_substeps;
    case Knob::preset: return words::lab::preset;
    case Knob::substeps: return words::lab::substeps;
    case Knob::tolerance: return words::lab::tolerance;
    case Knob::stretch: return words::lab::stretch;
    case Knob::bending: return words::lab::bending;
    case Knob::friction: return words::lab::friction;
    case Knob::spring_share: return words::lab::spring_share;
    case Knob::iterations: return words::lab::iterations;
    case Knob::bar_damping: return words::lab::bar_damping;
    case Knob::area: return words::lab::area;
    case Knob::self_collision: return words::lab::self_collision;
    case Knob::air_drag: return words::lab::air_drag;
  }
  return "";
}

std::string value_in_words(Knob knob, double value) {
  switch (knob) {
    case Knob::load_ratio:
    case Knob::weight_ratio: return filled_with(words::lab::ratio_value, value);
    case Knob::start_angle: return filled_with(words::lab::degrees_value, value);
    case Knob::load_share: return filled_with(words::lab::times_value, value);
    case Knob::may_sleep:
    case Knob::self_collision: return value != 0.0 ? words::on : words::off;
    case Knob::preset: return preset_name(value);
    case Knob::tolerance: return length_text(value);
    case Knob::stretch:
      return std::isinf(value) ? words::lab::inextensible : filled_with(words::lab::newtons_value, value);
    case Knob::bending: return filled_with(words::lab::stiffness_value, value);
    case Knob::air_drag: return filled_with(words::lab::rate_value, value);
    case Knob::turns:
    case Knob::count:
    case Knob::chain_substeps:
    case Knob::substeps:
    case Knob::friction:
    case Knob::spring_share:
    case Knob::iterations:
    case Knob::bar_damping:
    case Knob::area: return short_text(value);
  }
  return "";
}

}  // namespace game::lab
