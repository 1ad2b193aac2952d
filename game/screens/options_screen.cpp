#include "game/screens/options_screen.h"

#include <algorithm>
#include <array>
#include <functional>

#include "game/screens/card.h"
#include "game/screens/controls_screen.h"
#include "game/screens/style.h"
#include "game/words/words.h"

namespace game {
namespace {

struct Option {
  const char* label;
  std::function<std::string(const Settings&)> value;
  std::function<void(Settings&, int step)> change;
};

Option choice(const char* label, bool Settings::*which, const char* off, const char* on) {
  return {label, [=](const Settings& settings) { return settings.*which ? on : off; },
          [=](Settings& settings, int) { settings.*which = !(settings.*which); }};
}

std::string per_cent(int value) { return words::filled(words::per_cent, {{"number", std::to_string(value)}}); }

/// The options in order. The menu has one line before them, for the keys, and one after them, to go back.
const std::vector<Option>& options() {
  static const std::vector<Option> all = {
      choice(words::catch_a_rope, &Settings::toggle_grab, words::hold_the_key, words::press_once),
      {words::game_speed, [](const Settings& settings) { return per_cent(settings.speed); },
       [](Settings& settings, int step) {
         settings.speed = std::clamp(settings.speed + 10 * step, Settings::min_speed, 100);
       }},
      choice(words::longer_reach, &Settings::long_reach, words::off, words::from_next_level),
      choice(words::after_a_fall, &Settings::no_fall, words::back_to_checkpoint, words::back_to_foothold),
      choice(words::ghost_of_best, &Settings::ghost, words::hidden, words::shown),
      choice(words::motion, &Settings::reduced_motion, words::full_motion, words::reduced_motion),
      choice(words::colours, &Settings::colour_safe, words::normal_colours, words::high_contrast),
      choice(words::rope_strain, &Settings::strain_tint, words::hidden, words::coloured),
      {words::volume, [](const Settings& settings) { return per_cent(settings.sound.volume); },
       [](Settings& settings, int step) {
         settings.sound.volume = std::clamp(settings.sound.volume + 10 * step, 0, 100);
       }},
      {words::music_volume, [](const Settings& settings) { return per_cent(settings.sound.music); },
       [](Settings& settings, int step) {
         settings.sound.music = std::clamp(settings.sound.music + 10 * step, 0, 100);
       }},
      {words::sound, [](const Settings& settings) { return settings.sound.muted ? words::off : words::on; },
       [](Settings& settings, int) { settings.sound.muted = !settings.sound.muted; }},
      choice(words::keys_shown, &Settings::help, words::hidden, words::shown),
      choice(words::full_screen, &Settings::fullscreen, words::off, words::on),
  };
  return all;
}

const Card options_card{
    .headline = words::options, .lines = {words::options_note}, .width = 660.0, .text_size = 18.0, .line_size = 16.0};

}  // namespace

OptionsScreen::OptionsScreen(Session& session) : session_(&session) { fill_menu(); }

void OptionsScreen::fill_menu() {
  std::vector<MenuItem> items = {{words::keys_and_buttons_more}};
  for (const Option& option : options()) items.push_back({option.label, option.value(session_->settings), true});
  items.push_back({words::back});
  menu_.set_items(std::move(items));
}

Next OptionsScreen::update(const Frame& frame) {
  if (frame.menu.back) return Next::back();
  const auto rows = static_cast<int>(menu_.items().size());
  const auto choice = menu_.update(frame.menu, menu_place(frame.canvas, frame.text_scale, options_card, rows));
  if (choice && choice->item == 0) return Next::open(std::make_unique<ControlsScreen>(*session_));
  if (choice && choice->item == rows - 1) return Next::back();
  if (choice) options()[static_cast<std::size_t>(choice->item - 1)].change(session_->settings, choice->step);
  fill_menu();
  return Next::stay();
}

void OptionsScreen::draw(engine::Canvas& canvas, double text_scale) {
  draw_shade(canvas);
  const auto rows = static_cast<int>(menu_.items().size());
  draw_card(canvas, text_scale, options_card, rows);
  menu_.draw(canvas, menu_place(canvas, text_scale, options_card, rows));
  draw_keys_line(canvas, text_scale, menu_keys(session_->uses_pad));
}

}  // namespace game
