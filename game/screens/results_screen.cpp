#include "game/screens/results_screen.h"

#include <algorithm>
#include <cstdio>
#include <exception>

#include "game/screens/level_facts.h"
#include "game/screens/level_screen.h"
#include "game/screens/play_screen.h"
#include "game/view/hud.h"

namespace game {
namespace {

enum Meaning { next_level, again, watch, levels, quit };

/// Returns the name of the next level; empty after the last one.
std::string level_after(const std::string& name) {
  const std::vector<Level> levels = levels_in_order();
  const auto found = std::find_if(levels.begin(), levels.end(), [&](const Level& level) { return level.name == name; });
  return found == levels.end() || found + 1 == levels.end() ? "" : (found + 1)->name;
}

}  // namespace

ResultsScreen::ResultsScreen(Session& session, PlayScreen& play) : session_(&session), play_(&play) {
  const Level& level = play.run().level();
  const Best run{*play.simulation().goal_ticks(), play.is_assisted(), play.race().splits()};
  const auto before = session.records.best(level_key(level));
  std::string error;
  const bool is_best = session.records.offer(level_key(level), run, play.own_recording(), error);
  if (!error.empty()) session.notice.show(error);
  fill_card(run, before, is_best);
  fill_menu();
}

void ResultsScreen::fill_card(const Best& run, const std::optional<Best>& before, bool is_best) {
  const Level& level = play_->run().level();
  const Medal medal = medal_of(level, run);
  card_.headline = seconds_in_words(run.ticks) + (medal == Medal::none ? "" : "   " + medal_title(medal) + "!");
  card_.lines = {"You made it through “" + level_title(level) + "”"};
  if (const std::size_t coins = level.rules.coins.size(); coins > 0)
    card_.lines.push_back("Coins: " + std::to_string(play_->simulation().coins()) + " of " + std::to_string(coins));
  if (is_best) card_.lines.emplace_back(before ? "Your best time so far!" : "You made it for the first time!");
  if (before) card_.lines.push_back((is_best ? "Before it was " : "Your best is ") + best_in_words(level, before));
  for (std::string& line : splits_in_words(run.splits, play_->race().reference())) {
    card_.lines.push_back(std::move(line));
  }
  if (run.assisted) card_.lines.emplace_back("Well done, with some help: no medal for this time");
  const double wanted[] = {level.medals.bronze, level.medals.silver, level.medals.gold};
  if (run.assisted || medal == Medal::gold) return;
  const auto better = static_cast<int>(medal) + 1;
  const double seconds = wanted[better - 1];
  if (seconds <= 0.0) return;
  card_.lines.push_back(medal_title(static_cast<Medal>(better)) + " is for " + seconds_in_words(ticks_in(seconds)));
}

void ResultsScreen::fill_menu() {
  std::vector<MenuItem> items;
  const auto add = [&](int meaning, const char* label) {
    meanings_.push_back(meaning);
    items.push_back({label});
  };
  if (!play_->is_direct()) next_ = level_after(play_->run().level().name);
  if (!next_.empty()) add(next_level, "Next level");
  add(again, "Retry");
  if (!play_->own_recording().empty()) add(watch, "Watch this run");
  if (!play_->is_direct()) add(levels, "Levels");
  if (play_->is_direct()) add(quit, "Quit");
  menu_.set_items(std::move(items));
}

Next ResultsScreen::update(const Frame& frame) {
  if (session_->settings.bindings.pressed(Action::restart, frame.input)) return choose(again);
  if (frame.menu.back) return choose(play_->is_direct() ? again : levels);
  const MenuPlace place = menu_place(frame.canvas, frame.text_scale, card_, static_cast<int>(menu_.items().size()));
  const auto choice = menu_.update(frame.menu, place);
  return choice ? choose(meanings_[static_cast<std::size_t>(choice->item)]) : Next::stay();
}

Next ResultsScreen::watch_recording() {
  RunOptions options;
  options.level = play_->options().level.value_or(play_->run().level().name);
  options.replay = play_->own_recording();
  options.verify = true;
  try {
    return Next::open(std::make_unique<PlayScreen>(*session_, options, false));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "ropeswing: %s\n", error.what());
    session_->notice.show("The recording of this run cannot be read");
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
  draw_shade(canvas);
  const auto rows = static_cast<int>(menu_.items().size());
  draw_card(canvas, text_scale, card_, rows);
  menu_.draw(canvas, menu_place(canvas, text_scale, card_, rows));
  draw_menu_keys(canvas, text_scale, session_->uses_pad);
}

}  // namespace game
