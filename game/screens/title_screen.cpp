#include "game/screens/title_screen.h"

#include <exception>
#include <utility>

#include "game/screens/card.h"
#include "game/screens/help.h"
#include "game/screens/lab_screen.h"
#include "game/screens/level_screen.h"
#include "game/screens/options_screen.h"
#include "game/screens/style.h"
#include "game/words/words.h"

namespace game {
namespace {

enum TitleItem { play, open_lab, options, quit };

const Card title_card{
    .headline = words::game_title, .lines = {words::tagline}, .width = 340.0, .text_size = 28.0, .column = true};

}  // namespace

TitleScreen::TitleScreen(Session& session) : session_(&session) {
  menu_.set_items({{words::play}, {words::open_lab}, {words::options}, {words::quit}});
  RunOptions shown;
  shown.replay = assets_folder() + "/replays/" + default_level + ".replay";
  try {
    run_.emplace(shown);
    view_.emplace(run_->simulation());
  } catch (const std::exception&) {  // without the recording, only the sky is drawn
    run_.reset();
  }
}

Next TitleScreen::update(const Frame& frame) {
  show_run(frame.elapsed_ns);
  const auto rows = static_cast<int>(menu_.items().size());
  const auto choice = menu_.update(frame.menu, menu_place(frame.canvas, frame.text_scale, title_card, rows));
  if (!choice) return Next::stay();
  switch (choice->item) {
    case play: return Next::open(std::make_unique<LevelScreen>(*session_));
    case open_lab: return Next::open(std::make_unique<LabScreen>(*session_, ""));
    case options: return Next::open(std::make_unique<OptionsScreen>(*session_));
    case quit:
    default: return Next::quit();
  }
}

/// Runs the recording in a loop.
void TitleScreen::show_run(std::int64_t elapsed_ns) {
  if (!run_) return;
  for (int ticks = clock_.advance(elapsed_ns); ticks > 0; --ticks) {
    if (run_->is_over()) run_->seek(0);
    run_->tick({});
  }
}

/// Draws the run beside the menu, so that its player is never behind it.
void TitleScreen::draw_below(engine::Canvas& canvas, double text_scale) {
  if (!view_) return canvas.clear(style::sky_top, style::sky_bottom);
  ViewOptions options;
  options.hud = false;
  options.colour_safe = session_->settings.colour_safe;
  options.reduced_motion = session_->settings.reduced_motion;
  options.signs = signs_in_words(run_->level(), session_->settings, session_->uses_pad);
  const double menu = card_place(canvas, text_scale, title_card, static_cast<int>(menu_.items().size())).size.x;
  options.free = {{menu, 0.0}, {canvas.width() - menu, 1.0 * canvas.height()}};
  view_->draw(canvas, clock_.alpha(), options);
}

void TitleScreen::draw(engine::Canvas& canvas, double text_scale) {
  draw_below(canvas, text_scale);
  const auto rows = static_cast<int>(menu_.items().size());
  draw_card(canvas, text_scale, title_card, rows);
  menu_.draw(canvas, menu_place(canvas, text_scale, title_card, rows));
  const double width = card_place(canvas, text_scale, title_card, rows).size.x;
  draw_keys_line(canvas, text_scale, session_->uses_pad ? words::title_buttons : words::title_keys, width);
}

Next to_title(Session& session) {
  std::vector<std::unique_ptr<Screen>> screens;
  screens.push_back(std::make_unique<TitleScreen>(session));
  return Next::replace_all(std::move(screens));
}

}  // namespace game
