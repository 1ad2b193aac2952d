#include "game/screens/pause_screen.h"

#include "game/screens/level_facts.h"
#include "game/screens/level_screen.h"
#include "game/screens/options_screen.h"
#include "game/screens/play_screen.h"
#include "game/screens/title_screen.h"
#include "game/screens/yard_screen.h"
#include "game/words/words.h"

namespace game {
PauseScreen::PauseScreen(Session& session, PlayScreen& play) : session_(&session), play_(&play) {
  card_.headline = words::paused;
  card_.width = 300.0;
  card_.lines = {level_title(play.run().level())};
  std::vector<MenuItem> items;
  const auto add = [this, &items](Item item, const char* label) {
    choices_.push_back(item);
    items.push_back({label});
  };
  add(Item::resume, words::resume);
  if (play.played().can_build()) add(Item::build, words::place_things);
  add(Item::restart, words::restart_level);
  add(Item::options, words::options);
  if (play.played().is_direct()) {
    add(Item::quit, words::quit);
  } else {
    add(Item::levels, words::levels);
    add(Item::title, words::title_screen);
  }
  menu_.set_items(std::move(items));
}

Next PauseScreen::update(const Frame& frame) {
  if (has_built_) return Next::back();
  const Bindings& bindings = session_->settings.bindings;
  if (bindings.pressed(Action::step, frame.input)) {
    play_->step();
    return Next::back();
  }
  if (frame.menu.back || bindings.pressed(Action::pause, frame.input)) return Next::back();
  if (bindings.pressed(Action::restart, frame.input)) return choose(Item::restart);
  const auto rows = static_cast<int>(menu_.items().size());
  const auto choice = menu_.update(frame.menu, menu_place(frame.canvas, frame.text_scale, card_, rows));
  return choice ? choose(choices_[static_cast<std::size_t>(choice->item)]) : Next::stay();
}

Next PauseScreen::choose(Item item) {
  switch (item) {
    case Item::build: has_built_ = true; return Next::open(std::make_unique<YardScreen>(*session_, *play_));
    case Item::restart: play_->restart(); return Next::back();
    case Item::options: return Next::open(std::make_unique<OptionsScreen>(*session_));
    case Item::levels: return to_levels(*session_);
    case Item::quit: return Next::quit();
    case Item::title: return to_title(*session_);
    case Item::resume: break;
  }
  return Next::back();
}

void PauseScreen::draw(engine::Canvas& canvas, double text_scale) {
  card_.side = play_->free_side(canvas);
  draw_shade(canvas);
  const auto rows = static_cast<int>(menu_.items().size());
  draw_card(canvas, text_scale, card_, rows);
  menu_.draw(canvas, menu_place(canvas, text_scale, card_, rows));
  std::string keys = menu_keys(session_->uses_pad);
  if (!session_->uses_pad) {
    keys +=
        words::filled(words::menu_step, {{"key", codes_in_words(session_->settings.bindings, Action::step, false, 1)}});
  }
  draw_keys_line(canvas, text_scale, keys);
}

}  // namespace game
