#include "game/screens/level_screen.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <utility>

#include "game/screens/help.h"
#include "game/screens/level_facts.h"
#include "game/screens/play_screen.h"
#include "game/screens/style.h"
#include "game/screens/title_screen.h"
#include "game/view/hud.h"

namespace game {
namespace {

using engine::Align;
using ribbon::Vec2;

const Card card{.headline = "Levels", .lines = {}, .width = 420.0, .side = 1.0};

}  // namespace

LevelScreen::LevelScreen(Session& session) : session_(&session), levels_(levels_in_order()) {
  fill_menu();
  const auto last = std::find_if(levels_.begin(), levels_.end(),
                                 [&](const Level& level) { return level.name == session.last_level; });
  if (last != levels_.end()) menu_.set_focus(static_cast<int>(last - levels_.begin()));
}

void LevelScreen::shown() { fill_menu(); }

void LevelScreen::fill_menu() {
  std::vector<MenuItem> items;
  for (const Level& level : levels_) {
    const auto best = session_->records.best(level_key(level));
    const std::string title = level_title(level) + (level.players() == 2 ? ", for two" : "");
    items.push_back({title, best ? seconds_in_words(best->ticks) : ""});
    if (best) items.back().medal = medal_of(level, *best);
  }
  menu_.set_items(std::move(items));
}

Next LevelScreen::update(const Frame& frame) {
  if (frame.menu.back) return Next::back();
  if (levels_.empty()) return Next::stay();
  const auto rows = static_cast<int>(levels_.size());
  const auto choice = menu_.update(frame.menu, menu_place(frame.canvas, frame.text_scale, card, rows));
  show_focused(frame.elapsed_ns);
  return choice ? start_level(*session_, focused().name) : Next::stay();
}

void LevelScreen::show_focused(std::int64_t elapsed_ns) {
  if (previewed_ != menu_.focus()) {
    previewed_ = menu_.focus();
    view_.reset();
    preview_.emplace(focused());
    view_.emplace(*preview_);
  }
  for (int ticks = clock_.advance(elapsed_ns); ticks > 0; --ticks) preview_->tick({});
}

void LevelScreen::draw_facts(engine::Canvas& canvas, double text_scale) const {
  const Level& level = focused();
  std::vector<std::string> lines;
  if (!level.hint.empty()) lines.push_back(hint_in_words(level.hint, session_->settings, session_->uses_pad));
  const auto best = session_->records.best(level_key(level));
  lines.push_back(best ? "Your best: " + best_in_words(level, best) : "Not completed yet");
  if (const std::string medals = medals_in_words(level); !medals.empty()) lines.push_back(medals);
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
    options.signs = signs_in_words(preview_->level(), session_->settings, session_->uses_pad);
    view_->draw(canvas, clock_.alpha(), options);
  } else {
    canvas.clear(style::sky_top, style::sky_bottom);
  }
  const auto rows = static_cast<int>(levels_.size());
  draw_card(canvas, text_scale, card, rows);
  menu_.draw(canvas, menu_place(canvas, text_scale, card, rows));
  if (!levels_.empty()) draw_facts(canvas, text_scale);
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
  options.assists = session.settings.assists();
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
