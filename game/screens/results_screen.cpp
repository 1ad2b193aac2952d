#include "game/screens/results_screen.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>

#include "game/screens/card_grid.h"
#include "game/screens/level_facts.h"
#include "game/screens/level_screen.h"
#include "game/screens/play_screen.h"
#include "game/view/hud.h"
#include "game/words/words.h"

namespace game {
namespace {

using ribbon::Vec2;

constexpr double medal_radius = 22.0;  // units of text
constexpr double medal_gap = 12.0;     // between the medal and the time

enum Meaning { next_level, again, watch, levels, quit };

/// Returns the name of the next level; empty after the last one.
std::string level_after(const std::string& name) {
  const std::vector<Level> levels = levels_in_order();
  const auto found = std::find_if(levels.begin(), levels.end(), [&](const Level& level) { return level.name == name; });
  return found == levels.end() || found + 1 == levels.end() ? "" : (found + 1)->name;
}

std::string falls_in_words(int falls) {
  if (falls == 0) return words::no_falls;
  return falls == 1 ? words::one_fall : words::filled(words::some_falls, {{"count", std::to_string(falls)}});
}

/// Returns the limit of the next better medal; empty if there is none to win.
std::string next_medal_in_words(const Level& level, const Best& run) {
  const Medal medal = medal_of(level, run);
  if (run.assisted || medal == Medal::gold) return "";
  const std::array wanted = {level.medals.bronze, level.medals.silver, level.medals.gold};
  const auto better = static_cast<std::size_t>(medal) + 1;
  const double seconds = wanted[better - 1];
  if (seconds <= 0.0) return "";
  return words::filled(words::next_medal, {{"medal", medal_title(static_cast<Medal>(better))},
                                           {"time", seconds_in_words(ticks_in(seconds))}});
}

}  // namespace

ResultsScreen::ResultsScreen(Session& session, PlayScreen& play) : session_(&session), play_(&play) {
  const Level& level = play.run().level();
  const Best run{*play.simulation().goal_ticks(), play.played().is_assisted(), play.race().splits()};
  const auto before = session.records.best(level_key(level));
  std::string error;
  const bool is_best = session.records.offer(level_key(level), run, play.played().own_recording(), error);
  if (!error.empty()) session.notice.show(error);
  fill_card(run, before, is_best);
  fill_menu();
}

void ResultsScreen::fill_card(const Best& run, const std::optional<Best>& before, bool is_best) {
  const Level& level = play_->run().level();
  const Medal medal = medal_of(level, run);
  const std::string time = seconds_in_words(run.ticks);
  card_.width = 380.0;
  card_.before_headline = medal == Medal::none ? 0.0 : 2.0 * medal_radius + medal_gap;
  medal_ = medal;
  card_.headline = medal == Medal::none
                       ? time
                       : words::filled(words::time_and_medal, {{"time", time}, {"medal", medal_title(medal)}});
  card_.lines = {words::filled(words::made_it_through, {{"level", level_title(level)}})};
  if (is_best) card_.lines.emplace_back(before ? words::best_so_far : words::first_time);
  if (before) {
    card_.lines.push_back(
        words::filled(is_best ? words::best_before : words::best_is, {{"best", best_in_words(level, before)}}));
  }
  if (const std::size_t coins = level.rules.coins.size(); coins > 0) {
    const auto found = std::to_string(play_->simulation().coins());
    card_.lines.push_back(words::filled(words::coins_of, {{"found", found}, {"all", std::to_string(coins)}}));
  }
  for (std::string& line : splits_in_words(run.splits, play_->race().reference())) {
    card_.lines.push_back(std::move(line));
  }
  card_.lines.push_back(falls_in_words(play_->simulation().falls()));
  if (run.assisted) card_.lines.emplace_back(words::no_medal);
  if (const std::string next = next_medal_in_words(level, run); !next.empty()) card_.lines.push_back(next);
}

void ResultsScreen::fill_menu() {
  std::vector<MenuItem> items;
  const auto add = [&](int meaning, const char* label) {
    meanings_.push_back(meaning);
    items.push_back({label});
  };
  if (!play_->played().is_direct()) next_ = level_after(play_->run().level().name);
  if (!next_.empty()) add(next_level, words::next_level);
  add(again, words::retry);
  if (!play_->played().own_recording().empty()) add(watch, words::watch_run);
  if (!play_->played().is_direct()) add(levels, words::levels);
  if (play_->played().is_direct()) add(quit, words::quit);
  menu_.set_items(std::move(items));
}

Next ResultsScreen::update(const Frame& frame) {
  if (session_->settings.bindings.pressed(Action::restart, frame.input)) return choose(again);
  if (frame.menu.back) return choose(play_->played().is_direct() ? again : levels);
  const MenuPlace place = menu_place(frame.canvas, frame.text_scale, card_, static_cast<int>(menu_.items().size()));
  const auto choice = menu_.update(frame.menu, place);
  return choice ? choose(meanings_[static_cast<std::size_t>(choice->item)]) : Next::stay();
}

Next ResultsScreen::watch_recording() {
  RunOptions options;
  options.level = play_->played().options().level.value_or(play_->run().level().name);
  options.replay = play_->played().own_recording();
  options.verify = true;
  try {
    return Next::open(std::make_unique<PlayScreen>(*session_, options, false));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "ropeswing: %s\n", error.what());
    session_->notice.show(words::recording_unreadable);
    return Next::stay();
  }
}

Next ResultsScreen::choose(int meaning) {
  switch (meaning) {
    case next_level: return start_level(*session_, next_);
    case watch: return watch_recording();
    case levels: return to_levels(*session_);
    case quit: return Next::quit();
    case again:
    default: play_->restart(); return Next::back();
  }
}

void ResultsScreen::draw(engine::Canvas& canvas, double text_scale) {
  card_.side = play_->free_side(canvas);
  draw_shade(canvas);
  const auto rows = static_cast<int>(menu_.items().size());
  draw_card(canvas, text_scale, card_, rows);
  menu_.draw(canvas, menu_place(canvas, text_scale, card_, rows));
  if (medal_ == Medal::none) return draw_keys_line(canvas, text_scale, menu_keys(session_->uses_pad));
  const Vec2 time = headline_place(canvas, text_scale, card_, rows);
  draw_medal(canvas, time - Vec2{(medal_radius + medal_gap) * text_scale, 0.0}, medal_radius * text_scale, medal_);
  draw_keys_line(canvas, text_scale, menu_keys(session_->uses_pad));
}

}  // namespace game
