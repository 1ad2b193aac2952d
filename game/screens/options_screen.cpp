#include "game/screens/options_screen.h"

#include <algorithm>
#include <array>
#include <functional>

#include "game/screens/card.h"
#include "game/screens/controls_screen.h"
#include "game/screens/style.h"

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

std::string per_cent(int value) { return std::to_string(value) + " %"; }

/// The options in order. The menu has one line before them, for the keys, and one after them, to go back.
const std::vector<Option>& options() {
  static const std::vector<Option> all = {
      choice("Catch a rope", &Settings::toggle_grab, "hold the key", "press once"),
      {"Game speed", [](const Settings& settings) { return per_cent(settings.speed); },
       [](Settings& settings, int step) {
         settings.speed = std::clamp(settings.speed + 10 * step, Settings::min_speed, 100);
       }},
      choice("Longer reach", &Settings::long_reach, "off", "on, from the next level"),
      choice("After a fall", &Settings::no_fall, "back to start or checkpoint", "back to the last foothold"),
      choice("Ghost of the best run", &Settings::ghost, "hidden", "shown"),
      choice("Motion", &Settings::reduced_motion, "full", "reduced: no shake"),
      choice("Colours", &Settings::colour_safe, "normal", "high contrast"),
      choice("Rope strain", &Settings::strain_tint, "hidden", "coloured"),
      {"Sound volume", [](const Settings& settings) { return per_cent(settings.sound.volume); },
       [](Settings& settings, int step) {
         settings.sound.volume = std::clamp(settings.sound.volume + 10 * step, 0, 100);
       }},
      {"Music volume", [](const Settings& settings) { return per_cent(settings.sound.music); },
       [](Settings& settings, int step) {
         settings.sound.music = std::clamp(settings.sound.music + 10 * step, 0, 100);
       }},
      {"Sound", [](const Settings& settings) { return settings.sound.muted ? "off" : "on"; },
       [](Settings& settings, int) { settings.sound.muted = !settings.sound.muted; }},
      choice("Keys in the corner", &Settings::help, "hidden", "shown"),
      choice("Full screen", &Settings::fullscreen, "off", "on"),
  };
  return all;
}

const Card card{.headline = "Options",
                .lines = {"With lower speed, a longer reach or without falls, times count but earn no medal."},
                .width = 660.0,
                .text_size = 18.0,
                .line_size = 16.0};

}  // namespace

OptionsScreen::OptionsScreen(Session& session) : session_(&session) { fill_menu(); }

void OptionsScreen::fill_menu() {
  std::vector<MenuItem> items = {{"Keys and buttons …"}};
  for (const Option& option : options()) items.push_back({option.label, option.value(session_->settings), true});
  items.push_back({"Back"});
  menu_.set_items(std::move(items));
}

Next OptionsScreen::update(const Frame& frame) {
  if (frame.menu.back) return Next::back();
  const auto rows = static_cast<int>(menu_.items().size());
  const auto choice = menu_.update(frame.menu, menu_place(frame.canvas, frame.text_scale, card, rows));
  if (choice && choice->item == 0) return Next::open(std::make_unique<ControlsScreen>(*session_));
  if (choice && choice->item == rows - 1) return Next::back();
  if (choice) options()[static_cast<std::size_t>(choice->item - 1)].change(session_->settings, choice->step);
  fill_menu();
  return Next::stay();
}

void OptionsScreen::draw(engine::Canvas& canvas, double text_scale) {
  draw_shade(canvas);
  const auto rows = static_cast<int>(menu_.items().size());
  draw_card(canvas, text_scale, card, rows);
  menu_.draw(canvas, menu_place(canvas, text_scale, card, rows));
  draw_menu_keys(canvas, text_scale, session_->uses_pad);
}

}  // namespace game
