#include "game/screens/level_screen.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <utility>

#include "game/screens/card.h"
#include "game/screens/help.h"
#include "game/screens/level_facts.h"
#include "game/screens/play_screen.h"
#include "game/screens/style.h"
#include "game/screens/title_screen.h"
#include "game/view/hud.h"
#include "game/view/text_box.h"

namespace game {
namespace {

using engine::Align;
using ribbon::Vec2;

constexpr double side_margin = 16.0;   // units of text
constexpr double keys_height = 36.0;   // at the bottom
constexpr double facts_height = 66.0;  // above the keys
constexpr double facts_size = 17.0;    // of their text

/// Returns the part of the canvas for the cards: between the strip for notices and the facts.
GridPlace grid_place(const engine::Canvas& canvas, double text_scale) {
  const double top = notice_strip * text_scale;
  const double bottom = (keys_height + facts_height) * text_scale;
  return {{side_margin * text_scale, top},
          {canvas.width() - 2.0 * side_margin * text_scale, canvas.height() - top - bottom},
          text_scale};
}

/// Returns the title for a card of the list.
std::string title_in_list(const Level& level) {
  return level.players() == 2 ? words::filled(words::level_for_two, {{"level", level_title(level)}})
                              : level_title(level);
}

}  // namespace

LevelScreen::LevelScreen(Session& session) : session_(&session), levels_(levels_in_order()) {
  fill_grid();
  const auto last = std::find_if(levels_.begin(), levels_.end(),
                                 [&](const Level& level) { return level.name == session.last_level; });
  if (last != levels_.end()) grid_.set_focus(static_cast<int>(last - levels_.begin()));
}

void LevelScreen::shown() { fill_grid(); }

void LevelScreen::fill_grid() {
  std::vector<PictureCard> cards;
  for (const Level& level : levels_) {
    PictureCard card{title_in_list(level), "", Medal::none,
                     session_->level_pictures.of(level, session_->settings.colour_safe)};
    if (const auto best = session_->records.best(level_key(level))) {
      card.time = seconds_in_words(best->ticks);
      card.medal = medal_of(level, *best);
    }
    cards.push_back(std::move(card));
  }
  grid_.set_cards(std::move(cards));
}

Next LevelScreen::update(const Frame& frame) {
  if (frame.menu.back) return Next::back();
  if (levels_.empty()) return Next::stay();
  const GridPlace place = grid_place(frame.canvas, frame.text_scale);
  const auto choice = grid_.update(frame.menu, place);
  if (choice) return start_level(*session_, focused().name);
  if (frame.elapsed_ns > 0) make_a_picture(place);
  return Next::stay();
}

/// Draws one of the missing pictures, a visible one first: more in one frame would be felt.
void LevelScreen::make_a_picture(const GridPlace& place) {
  const Level* missing = nullptr;
  for (int k = 0; k < grid_.size(); ++k) {
    const Level& level = levels_[static_cast<std::size_t>(k)];
    if (session_->level_pictures.has_tried(level, session_->settings.colour_safe)) continue;
    if (missing == nullptr) missing = &level;
    if (!grid_.shows(k, place)) continue;
    missing = &level;
    break;
  }
  if (missing == nullptr) return;
  const Settings& settings = session_->settings;
  session_->level_pictures.make(*missing, signs_in_words(*missing, settings, session_->uses_pad), settings.colour_safe);
  fill_grid();
}

/// Draws the limits of the medals, each beside its medal, to the left of `right`.
void LevelScreen::draw_medal_limits(engine::Canvas& canvas, Vec2 right, double size) const {
  const Medals& medals = focused().medals;
  const double radius = 0.5 * size;
  for (const auto& [medal, seconds] : {std::pair{Medal::bronze, medals.bronze}, std::pair{Medal::silver, medals.silver},
                                       std::pair{Medal::gold, medals.gold}}) {
    if (seconds <= 0.0) continue;
    const std::string limit = seconds_in_words(ticks_in(seconds));
    canvas.text(right, limit, size, style::white, Align::right);
    right.x -= canvas.text_width(limit, size) + 1.5 * radius;
    draw_medal(canvas, right + Vec2{0.0, 0.5 * canvas.line_height(size)}, radius, medal);
    right.x -= radius + 1.2 * size;
  }
}

void LevelScreen::draw_facts(engine::Canvas& canvas, double text_scale) const {
  const Level& level = focused();
  const double size = facts_size * text_scale;
  const double margin = side_margin * text_scale;
  const double top = canvas.height() - (keys_height + facts_height) * text_scale;
  const Vec2 box{canvas.width() - 2.0 * margin, (facts_height - 6.0) * text_scale};
  canvas.panel({margin, top}, box, 9.0 * text_scale, style::card);
  const Vec2 first{2.0 * margin, top + 0.5 * (box.y - 2.0 * canvas.line_height(size))};
  const std::string hint = hint_in_words(level.hint, session_->settings, session_->uses_pad);
  for (const std::string& line : wrapped(canvas, hint, size, box.x - 2.0 * margin, 1)) {
    canvas.text(first, line, size, style::white);
  }
  const auto best = session_->records.best(level_key(level));
  const std::string record = best ? words::filled(words::your_best, {{"best", best_in_words(level, best)}})
                                  : std::string(words::not_completed);
  const Vec2 second = first + Vec2{0.0, canvas.line_height(size)};
  canvas.text(second, record, size, style::faint);
  draw_medal_limits(canvas, {canvas.width() - 2.0 * margin, second.y}, size);
}

/// Says what is missing, where, and what helps.
void LevelScreen::draw_no_levels(engine::Canvas& canvas, double text_scale) const {
  const Card card{.headline = words::levels,
                  .lines = {words::no_levels, assets_folder() + "/levels", words::no_levels_advice},
                  .width = 500.0};
  draw_card(canvas, text_scale, card, 0);
}

void LevelScreen::draw(engine::Canvas& canvas, double text_scale) {
  canvas.clear(style::night_top, style::night_bottom);
  if (levels_.empty()) {
    draw_no_levels(canvas, text_scale);
  } else {
    if (session_->notice.text().empty()) {
      const double size = 27.0 * text_scale;
      canvas.text({0.5 * canvas.width(), 0.5 * (notice_strip * text_scale - canvas.line_height(size))}, words::levels,
                  size, style::gold, Align::center);
    }
    grid_.draw(canvas, grid_place(canvas, text_scale));
    draw_facts(canvas, text_scale);
  }
  draw_keys_line(canvas, text_scale, session_->uses_pad ? words::grid_buttons : words::grid_keys);
}

Next to_levels(Session& session) {
  std::vector<std::unique_ptr<Screen>> screens;
  screens.push_back(std::make_unique<TitleScreen>(session));
  screens.push_back(std::make_unique<LevelScreen>(session));
  return Next::replace_all(std::move(screens));
}

Next start_level(Session& session, const std::string& name) {
  RunOptions options;
  options.level = name;
  options.assists = session.settings.assists();
  try {
    auto play = std::make_unique<PlayScreen>(session, options, false);
    Next next = to_levels(session);
    next.screens.push_back(std::move(play));
    return next;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "ropeswing: %s\n", error.what());
    session.notice.show(words::level_unreadable);
    return Next::stay();
  }
}

}  // namespace game
