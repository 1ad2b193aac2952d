#include "game/settings/action.h"

#include <array>

#include "game/simulation/buttons.h"

namespace game {
namespace {

struct Row {
  Action action;
  std::string_view name;
  std::string_view title;
  std::uint16_t button;
};

constexpr std::array<Row, action_count> table = {{
    {Action::left, "left", "Run or swing left", button_left},
    {Action::right, "right", "Run or swing right", button_right},
    {Action::up, "up", "Climb up", button_up},
    {Action::down, "down", "Climb down", button_down},
    {Action::jump, "jump", "Jump, let go", button_jump},
    {Action::grab, "grab", "Catch a rope", button_grab},
    {Action::throw_line, "throw_line", "Throw a line", button_throw},
    {Action::throw_second, "throw_second", "Throw a second line", button_throw_second},
    {Action::tie, "tie", "Tie the line", button_tie},
    {Action::cut, "cut", "Cut a rope", button_cut},
    {Action::reel_in, "reel_in", "Reel in", button_reel_in},
    {Action::reel_out, "reel_out", "Reel out", button_reel_out},
    {Action::retry, "retry", "Back to the checkpoint", button_retry},
    {Action::restart, "restart", "Restart the level", button_restart},
    {Action::pause, "pause", "Pause", 0},
    {Action::step, "step", "Advance one tick", 0},
    {Action::slow_motion, "slow_motion", "Slow motion 1/2, 1/4", 0},
    {Action::help, "help", "Show or hide the keys", 0},
    {Action::debug_view, "debug_view", "Debug view, drag by mouse", 0},
    {Action::panel, "panel", "Figures and parameters", 0},
    {Action::mute, "mute", "Sound on or off", 0},
    {Action::fullscreen, "fullscreen", "Full screen", 0},
    {Action::film, "film", "Start or stop a video", 0},
    {Action::screenshot, "screenshot", "Take a screenshot", 0},
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
