#include "game/screens/controls_screen.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "game/screens/style.h"
#include "game/words/words.h"

namespace game {
namespace {

constexpr std::size_t shown_codes = 3;  // per device

}  // namespace

ControlsScreen::ControlsScreen(Session& session) : session_(&session) { fill_menu(); }

Bindings& ControlsScreen::bindings() const {
  return is_of_second_ ? session_->settings.second_bindings : session_->settings.bindings;
}

/// Returns the keys of an action, and its buttons, if it has some. The buttons of both players' gamepads are the same.
std::string ControlsScreen::codes_of(Action action) const {
  if (rebinding_ && rebinding_->action() == action) return words::waiting_for_key;
  std::string codes = codes_in_words(bindings(), action, false, shown_codes);
  const bool has_buttons =
      std::any_of(bindings().codes(action).begin(), bindings().codes(action).end(),
                  [](const auto& code) { return std::holds_alternative<engine::PadButton>(code); });
  if (!has_buttons) return codes;
  return words::filled(words::both_devices,
                       {{"keys", codes}, {"buttons", codes_in_words(bindings(), action, true, shown_codes)}});
}

/// The second player has the actions of a run only.
void ControlsScreen::fill_menu() {
  actions_.clear();
  std::vector<MenuItem> items;
  for (const Action action : all_actions()) {
    if (is_of_second_ && button_of(action) == 0) continue;
    actions_.push_back(action);
    items.push_back({std::string(action_title(action)), codes_of(action)});
  }
  items.push_back({words::keys_of, is_of_second_ ? words::second_player : words::first_player, true});
  items.push_back({words::reset_to_defaults});
  items.push_back({words::back});
  menu_.set_items(std::move(items));
}

Card ControlsScreen::card() const {
  const std::string line = rebinding_ ? rebinding_->prompt(bindings())
                                      : std::string(is_of_second_ ? words::second_keys_note : words::keys_note);
  return {.headline = words::keys_and_buttons, .lines = {line}, .width = 900.0, .text_size = 19.0, .line_size = 17.0};
}

Next ControlsScreen::update(const Frame& frame) {
  if (rebinding_) {
    if (rebinding_->take(frame.input, bindings())) rebinding_.reset();
    fill_menu();
    return Next::stay();
  }
  if (frame.menu.back) return Next::back();
  const auto choice = menu_.update(frame.menu, menu_place(frame.canvas, frame.text_scale, card(), rows()));
  return choice ? choose(*choice) : Next::stay();
}

Next ControlsScreen::choose(const MenuChoice& choice) {
  if (choice.item == rows() - 1) return Next::back();
  if (choice.item == rows() - 2) {
    session_->settings.bindings = Bindings::defaults();
    session_->settings.second_bindings = Bindings::second_defaults();
  } else if (choice.item == rows() - 3) {
    is_of_second_ = !is_of_second_;
    fill_menu();
    menu_.set_focus(rows() - 3);
  } else {
    rebinding_.emplace(actions_[static_cast<std::size_t>(choice.item)]);
  }
  fill_menu();
  return Next::stay();
}

void ControlsScreen::draw(engine::Canvas& canvas, double text_scale) {
  draw_shade(canvas);
  draw_card(canvas, text_scale, card(), rows());
  menu_.draw(canvas, menu_place(canvas, text_scale, card(), rows()));
  draw_keys_line(canvas, text_scale, menu_keys(session_->uses_pad));
}

}  // namespace game
