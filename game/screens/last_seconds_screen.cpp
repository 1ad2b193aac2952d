#include "game/screens/last_seconds_screen.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include "engine/window/sdl_window.h"
#include "game/screens/card.h"
#include "game/screens/help.h"
#include "game/screens/style.h"
#include "game/simulation/snapshot.h"
#include "game/view/figure_state.h"
#include "game/view/text_box.h"
#include "game/words/words.h"

namespace game {
namespace {

using engine::Color;
using ribbon::Vec2;

constexpr Color other_color{255, 64, 160};          // in no place of the game
constexpr double other_width = 0.05;                // m
constexpr double gap_ring = 0.25;                   // m
constexpr double min_shown_gap = 0.005;             // m: a smaller one gets no ring
constexpr int pause_ticks = ticks_per_second;       // at the end, before it begins again
constexpr std::int64_t frame_work_ns = 10'000'000;  // of a frame, for ticks before the last seconds
constexpr int ticks_at_once = 4;

std::string with_decimals(double number, int decimals) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, number);
  return text.data();
}

std::string in_centimetres(double metres) { return with_decimals(100.0 * metres, metres < 0.01 ? 2 : 1); }

/// Draws a row of a cord as a thin line. Its points are stored column by column.
void draw_row(engine::Canvas& canvas, const std::vector<Vec2>& points, int rows, int row) {
  std::vector<Vec2> line;
  for (std::size_t p = static_cast<std::size_t>(row); p < points.size(); p += static_cast<std::size_t>(rows))
    line.push_back(points[p]);
  if (line.size() > 1) canvas.polyline(line, other_width, other_color);
}

}  // namespace

LastSecondsScreen::LastSecondsScreen(Session& session, const Level& level, std::vector<engine::TickInput> inputs,
                                     const Preset& preset)
    : session_(&session), level_(level), inputs_(std::move(inputs)), preset_(&preset) {
  begin();
}

std::string LastSecondsScreen::title() const {
  return words::filled(words::screen_last_seconds, {{"preset", preset_->name}});
}

void LastSecondsScreen::begin() {
  view_.reset();
  runs_ = std::make_unique<LastSeconds>(level_, inputs_, preset_->accuracy);
  view_.emplace(runs_->played());
  is_ready_ = false;
  paused_ticks_ = 0;
}

void LastSecondsScreen::choose(int steps) {
  const auto all = presets();
  const auto last = static_cast<std::ptrdiff_t>(all.size()) - 1;
  const std::ptrdiff_t wanted = std::clamp<std::ptrdiff_t>(preset_ - all.data() + steps, 0, last);
  if (&all[static_cast<std::size_t>(wanted)] == preset_) return;
  preset_ = &all[static_cast<std::size_t>(wanted)];
  begin();
}

Next LastSecondsScreen::update(const Frame& frame) {
  if (frame.menu.back || session_->settings.bindings.pressed(Action::panel, frame.input)) return Next::back();
  if (frame.menu.right != 0) choose(frame.menu.right);
  const std::int64_t start = engine::now_ns();
  while (!is_ready_) {
    is_ready_ = runs_->approach(ticks_at_once);
    if (engine::now_ns() - start > frame_work_ns) return Next::stay();
  }
  play(frame.elapsed_ns);
  return Next::stay();
}

void LastSecondsScreen::play(std::int64_t elapsed_ns) {
  for (int ticks = clock_.advance(elapsed_ns); ticks > 0; --ticks) {
    if (!runs_->is_over()) {
      runs_->tick();
    } else if (++paused_ticks_ > pause_ticks) {
      paused_ticks_ = 0;
      runs_->rewind();
      is_ready_ = false;
      return;
    }
  }
}

void LastSecondsScreen::draw(engine::Canvas& canvas, double text_scale) {
  const Settings& settings = session_->settings;
  ViewOptions options;
  options.hud = false;
  options.reduced_motion = settings.reduced_motion;
  options.colour_safe = settings.colour_safe;
  options.text_scale = text_scale;
  options.signs = signs_in_words(level_, settings, session_->uses_pad);
  const double alpha = runs_->is_over() ? 1.0 : clock_.alpha();
  view_->draw(canvas, alpha, options);
  if (is_ready_) draw_other(canvas, alpha);
  TextBox box;
  box.text_size = 18.0 * text_scale;
  box.headline_size = 24.0 * text_scale;
  box.margin = {16.0 * text_scale, 10.0 * text_scale};
  box.headline = words::filled(words::last_seconds_headline, {{"preset", preset_->name}});
  box.lines = figures();
  const Vec2 corner{12.0 * text_scale, 12.0 * text_scale};
  box.draw(canvas, corner);
  draw_keys_line(canvas, text_scale, session_->uses_pad ? words::last_seconds_buttons : words::last_seconds_keys);
}

/// Draws cords, players and the largest gap of the other run at the camera of the first one.
void LastSecondsScreen::draw_other(engine::Canvas& canvas, double alpha) const {
  const Simulation& other = runs_->other();
  const Snapshot now = interpolate(other.previous(), other.current(), alpha);
  const ribbon::box2d::Coupling& coupling = other.scene().coupling();
  for (const ribbon::box2d::CordId id : coupling.cords()) {
    const std::vector<Vec2>& points = now.cords[static_cast<std::size_t>(id)];
    const int rows = coupling.cord(id).shape().rows;
    draw_row(canvas, points, rows, 0);
    if (rows > 1) draw_row(canvas, points, rows, rows - 1);
  }
  for (int k = 0; k < other.players(); ++k) {
    const PlayerTuning& tuning = other.player(k).tuning();
    const Vec2 middle = figure_of(other, now, 0.0, k).at;
    const Vec2 half{0.0, 0.5 * tuning.height - tuning.radius};
    for (const Vec2 at : {middle - half, middle + half}) canvas.ring(at, tuning.radius, other_width, other_color);
  }
  const auto& gap = runs_->gap();
  if (!gap || gap->size() < min_shown_gap) return;
  canvas.ring(gap->played, gap_ring, other_width, style::gold);
  canvas.polyline(std::array{gap->played, gap->other}, other_width, style::gold);
}

std::vector<std::string> LastSecondsScreen::figures() const {
  if (!is_ready_)
    return {words::filled(words::last_seconds_progress, {{"percent", with_decimals(100.0 * runs_->progress(), 0)}})};
  std::vector<std::string> lines = {words::last_seconds_legend};
  const auto& gap = runs_->gap();
  const auto& largest = runs_->largest_gap();
  if (gap && largest) {
    lines.push_back(
        words::filled(words::last_seconds_gap, {{"now", in_centimetres(gap->size())},
                                                {"most", in_centimetres(largest->size())},
                                                {"time", with_decimals(1.0 * largest->tick / ticks_per_second, 1)}}));
  }
  lines.push_back(
      words::filled(words::last_seconds_cost, {{"other", with_decimals(runs_->other_meter().median_us(), 0)},
                                               {"played", with_decimals(runs_->played_meter().median_us(), 0)}}));
  return lines;
}

}  // namespace game
