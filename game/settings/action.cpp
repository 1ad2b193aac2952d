#include "game/settings/action.h"

#include <array>

#include "game/simulation/buttons.h"
#include "game/words/words.h"

namespace game {
namespace {

struct Row {
  Action action;
  std::string_view name;
  std::string_view title;
  std::uint16_t button;
};

constexpr std::array<Row, action_count> table = {{
    {Action::left, "left", words::do_left, button_left},
    {Action::right, "right", words::do_right, button_right},
    {Action::up, "up", words::do_up, button_up},
    {Action::down, "down", words::do_down, button_down},
    {Action::jump, "jump", words::do_jump, button_jump},
    {Action::grab, "grab", words::do_grab, button_grab},
    {Action::throw_line, "throw_line", words::do_throw_line, button_throw},
    {Action::throw_second, "throw_second", words::do_throw_second, button_throw_second},
    {Action::tie, "tie", words::do_tie, button_tie},
    {Action::cut, "cut", words::do_cut, button_cut},
    {Action::reel_in, "reel_in", words::do_reel_in, button_reel_in},
    {Action::reel_out, "reel_out", words::do_reel_out, button_reel_out},
    {Action::retry, "retry", words::do_retry, button_retry},
    {Action::restart, "restart", words::do_restart, button_restart},
    {Action::pause, "pause", words::do_pause, 0},
    {Action::step, "step", words::do_step, 0},
    {Action::slow_motion, "slow_motion", words::do_slow_motion, 0},
    {Action::help, "help", words::do_help, 0},
    {Action::debug_view, "debug_view", words::do_debug_view, 0},
    {Action::panel, "panel", words::do_panel, 0},
    {Action::palette, "palette", words::do_palette, 0},
    {Action::mute, "mute", words::do_mute, 0},
    {Action::fullscreen, "fullscreen", words::do_fullscreen, 0},
    {Action::film, "film", words::do_film, 0},
    {Action::screenshot, "screenshot", words::do_screenshot, 0},
}};

constexpr bool in_order() {
  for (std::size_t k = 0; k < action_count; ++k) {
    if (static_cast<std::size_t>(table[k].action) != k) return false;
  }
  return true;
}
static_assert(in_order());

constexpr std::array<Action, action_count> actions = [] {
  std::array<Action, action_count> all{};
  for (std::size_t k = 0; k < action_count; ++k) all[k] = table[k].action;
  return all;
}();

const Row& row(Action action) { return table[static_cast<std::size_t>(action)]; }

}  // namespace

std::string_view action_name(Action action) { return row(action).name; }
std::string_view action_title(Action action) { return row(action).title; }
std::uint16_t button_of(Action action) { return row(action).button; }
std::span<const Action> all_actions() { return actions; }

}  // namespace game
