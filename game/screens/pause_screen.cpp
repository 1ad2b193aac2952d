#include "game/screens/pause_screen.h"

#include "game/screens/card.h"
#include "game/screens/play_screen.h"
#include "game/screens/title_screen.h"

namespace game {
namespace {

enum Item { go_on, again, leave_it };

const Card card{.headline = "Paused", .lines = {}};

}  // namespace

PauseScreen::PauseScreen(Session& session, PlayScreen& play) : session_(&session), play_(&play) {
  menu_.set_items({{"Go on"}, {"Start again"}, {play.is_direct() ? "Leave the game" : "Back to the title"}});
}

Next PauseScreen::update(const Frame& frame) {
  const Bindings& bindings = session_->settings.bindings;
  if (bindings.pressed(Action::step, frame.input)) {
    play_->step();
    return Next::back();
  }
  if (frame.menu.back || bindings.pressed(Action::pause, frame.input)) return Next::back();
  const MenuPlace place = menu_place(frame.canvas, frame.text_scale, card, static_cast<int>(menu_.items().size()));
  const auto choice = menu_.update(frame.menu, place);
  if (!choice) return Next::stay();
  switch (choice->item) {
    case again: play_->restart(); return Next::back();
    case leave_it: return play_->is_direct() ? Next::quit() : to_title(*session_);
    case go_on:
    default: return Next::back();
  }
}

void PauseScreen::draw(engine::Canvas& canvas, double text_scale) {
  draw_shade(canvas);
  const auto rows = static_cast<int>(menu_.items().size());
  draw_card(canvas, text_scale, card, rows);
  menu_.draw(canvas, menu_place(canvas, text_scale, card, rows));
  draw_menu_keys(canvas, text_scale, session_->uses_pad);
}

}  // namespace game
