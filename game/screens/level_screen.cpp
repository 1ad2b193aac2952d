#include "game/screens/level_screen.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <utility>

#include "game/hud.h"
#include "game/level_facts.h"
#include "game/screens/play_screen.h"
#include "game/screens/style.h"
#include "game/screens/title_screen.h"

namespace game {
namespace {

using engine::Align;
using ribbon::Vec2;

const Card card{.headline = "Levels", .lines = {}, .width = 420.0, .side = 1.0};

}  // namespace

LevelScreen::LevelScreen(Session& session) : session_(&session) {
  for (const std::string& name : level_names()) entries_.push_back({name});
  fill_menu();
  const auto last = std::find_if(entries_.begin(), entries_.end(),
                                 [&](const Entry& entry) { return entry.name == session.last_level; });
  if (last != entries_.end()) menu_.set_focus(static_cast<int>(last - entries_.begin()));
}

void LevelScreen::shown() { fill_menu(); }

/// That of the focus first.
void LevelScreen::read_one_more() {
  const auto unread = [](const Entry& entry) { return !entry.level && !entry.broken; };
  auto one = entries_.begin() + menu_.focus();
  if (!unread(*one)) one = std::find_if(entries_.begin(), entries_.end(), unread);
  if (one == entries_.end()) return;
  try {
    one->level = std::make_unique<Level>(load_level(one->name));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "ropeswing: %s\n", error.what());
    one->broken = true;
  }
  fill_menu();
}

void LevelScreen::fill_menu() {
  std::vector<MenuItem> items;
  for (const Entry& entry : entries_) {
    if (entry.broken) {
      items.push_back({entry.name, "cannot be read"});
    } else if (!entry.level) {
      items.push_back({entry.name});
    } else {
      const auto best = session_->records.best(level_key(*entry.level));
      items.push_back({level_title(*entry.level), best ? seconds_in_words(best->ticks) : ""});
      if (best) items.back().medal = medal_of(*entry.level, *best);
    }
  }
  menu_.set_items(std::move(items));
}

Next LevelScreen::update(const Frame& frame) {
  if (frame.menu.back) return Next::back();
  if (entries_.empty()) return Next::stay();
  const auto rows = static_cast<int>(entries_.size());
  const auto choice = menu_.update(frame.menu, menu_place(frame.canvas, frame.text_scale, card, rows));
  read_one_more();
  show_focused(frame.elapsed_ns);
  if (!choice) return Next::stay();
  if (!focused().broken) return start_level(*session_, focused().name);
  session_->notice.show("This level cannot be read");
  return Next::stay();
}

void LevelScreen::show_focused(std::int64_t elapsed_ns) {
  const Level* level = focused().level.get();
  if (level != previewed_) {
    previewed_ = level;
    view_.reset();
    preview_.reset();
    if (level == nullptr) return;
    preview_.emplace(*level);
    view_.emplace(*preview_);
  }
  if (!preview_) return;
  for (int ticks = clock_.advance(elapsed_ns); ticks > 0; --ticks) preview_->tick({});
}

void LevelScreen::draw_facts(engine::Canvas& canvas, double text_scale) const {
  const Entry& entry = focused();
  if (!entry.level) return;
  std::vector<std::string> lines;
  const auto best = session_->records.best(level_key(*entry.level));
  lines.push_back(best ? "Your best: " + best_in_words(*entry.level, best) : "Not yet made");
  if (const auto medals = level_medals(*entry.level)) {
    const auto time = [](double seconds) { return seconds_in_words(static_cast<int>(seconds * ticks_per_second)); };
    lines.push_back("Gold " + time(medals->gold) + "   Silver " + time(medals->silver) + "   Bronze " +
                    time(medals->bronze));
  }
  const double size = 19.0 * text_scale;
  const double step = canvas.line_height(size);
  double width = 0.0;
  for (const std::string& line : lines) width = std::max(width, canvas.text_width(line, size));
  const Vec2 box{width + 2.0 * size, step * static_cast<double>(lines.size()) + size};
  const Vec2 corner{24.0 * text_scale, canvas.height() - box.y - 60.0 * text_scale};
  canvas.panel(corner, box, 0.6 * size, style::paper);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    canvas.text(corner + Vec2{size, 0.5 * size + step * static_cast<double>(k)}, lines[k], size, style::white);
  }
}

void LevelScreen::draw(engine::Canvas& canvas, double text_scale) {
  if (view_) {
    ViewOptions options;
    options.hud = false;
    view_->draw(canvas, clock_.alpha(), options);
  } else {
    canvas.clear(style::sky_top, style::sky_bottom);
  }
  const auto rows = static_cast<int>(entries_.size());
  draw_card(canvas, text_scale, card, rows);
  menu_.draw(canvas, menu_place(canvas, text_scale, card, rows));
  if (!entries_.empty()) draw_facts(canvas, text_scale);
  draw_menu_keys(canvas, text_scale, session_->uses_pad);
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
  if (session.settings.long_reach) options.player_reach = PlayScreen::long_reach;
  try {
    auto play = std::make_unique<PlayScreen>(session, options, false);
    Next next = to_levels(session);
    next.screens.push_back(std::move(play));
    return next;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "ropeswing: %s\n", error.what());
    session.notice.show("This level cannot be read");
    return Next::stay();
  }
}

}  // namespace game
