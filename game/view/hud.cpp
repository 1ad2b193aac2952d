#include "game/view/hud.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "game/view/debug_figures.h"
#include "game/view/hud_style.h"
#include "game/view/strain_legend.h"
#include "game/view/text_box.h"
#include "game/words/words.h"

namespace game {

using engine::Align;
using engine::Canvas;
using engine::Color;
using ribbon::Vec2;

namespace {

constexpr double edge = 14.0;           // units of text, between the boxes and the edge of the canvas
constexpr double gap = 6.0;             // units of text, between two boxes
constexpr double min_keys_size = 12.0;  // px

/// What all boxes need.
struct Hud {
  Canvas& canvas;
  const Simulation& simulation;
  const ViewOptions& options;
  FreeSpace& space;
  HudPlaces& places;

  double scale() const { return options.text_scale; }
  const Rectangle& area() const { return space.area(); }
  /// The corner that puts a box at a fraction of the free area: 0 left or top … 1 right or bottom.
  Vec2 corner(Vec2 size, double x, double y) const {
    const Vec2 room = area().size - size;
    return area().corner + Vec2{x * room.x, y * room.y};
  }
  bool draw(const TextBox& box, std::span<const Vec2> wanted, int& last) {
    const auto at = space.place(box.size(canvas), wanted, last);
    if (at) box.draw(canvas, *at);
    return at.has_value();
  }
};

Rectangle area_of(const Canvas& canvas, const ViewOptions& options) {
  Rectangle area{{}, {1.0 * canvas.width(), 1.0 * canvas.height()}};
  if (options.free.size.x > 0.0) area = options.free;
  const double margin = edge * options.text_scale;
  return {area.corner + Vec2{margin, margin}, area.size - Vec2{2.0 * margin, 2.0 * margin}};
}

void draw_time(Hud hud) {
  const auto goal = hud.simulation.goal_ticks();
  const std::string time = seconds_in_words(goal.value_or(hud.simulation.run_ticks()));
  const int falls = hud.simulation.falls();
  TextBox box;
  std::string line =
      falls == 0 ? time : words::filled(words::time_and_falls, {{"time", time}, {"falls", std::to_string(falls)}});
  if (const std::size_t coins = hud.simulation.level().rules.coins.size(); coins > 0) {
    const std::string found = std::to_string(hud.simulation.coins());
    line = words::filled(words::time_and_coins, {{"time", line}, {"found", found}, {"all", std::to_string(coins)}});
  }
  box.lines = {line};
  box.text_size = 24.0 * hud.scale();
  box.align = Align::right;
  box.margin = hud.scale() * Vec2{11.0, 4.0};
  const Vec2 size = box.size(hud.canvas);
  hud.draw(box, std::array{hud.corner(size, 1.0, 0.0), hud.corner(size, 1.0, 1.0)}, hud.places.time);
}

/// Puts the lines into columns, so that they are at most `max_width` px wide. Returns no line if they are not.
std::vector<TextBox> columns_of(const Canvas& canvas, const TextBox& box, std::size_t count, double max_width) {
  std::vector<TextBox> columns;
  const std::size_t rows = (box.lines.size() + count - 1) / count;
  double width = 0.0;
  for (std::size_t first = 0; first < box.lines.size(); first += rows) {
    TextBox column = box;
    const std::size_t last = std::min(first + rows, box.lines.size());
    column.lines = {box.lines.begin() + static_cast<std::ptrdiff_t>(first),
                    box.lines.begin() + static_cast<std::ptrdiff_t>(last)};
    width += column.size(canvas).x;
    columns.push_back(std::move(column));
  }
  return width <= max_width ? columns : std::vector<TextBox>{};
}

/// Draws the keys in as few columns as leave the middle of the picture free.
void draw_keys(Hud hud) {
  TextBox box;
  box.lines = *hud.options.keys;
  box.text_size = std::max(15.0 * hud.scale(), min_keys_size);
  box.color = hud_style::faint;
  box.margin = box.text_size * Vec2{0.6, 0.3};
  const std::size_t many = 8;  // lines
  for (const std::size_t count : box.lines.size() > many ? std::array{2U, 3U, 1U} : std::array{1U, 1U, 1U}) {
    const std::vector<TextBox> columns = columns_of(hud.canvas, box, count, hud.area().size.x);
    if (columns.empty()) continue;
    Vec2 size{0.0, columns.front().size(hud.canvas).y};
    for (const TextBox& column : columns) size.x += column.size(hud.canvas).x;
    auto at =
        hud.space.place(size, std::array{hud.corner(size, 0.0, 0.0), hud.corner(size, 0.0, 1.0)}, hud.places.keys);
    if (!at) continue;
    hud.canvas.panel(*at, size, 0.5 * box.text_size, hud_style::paper);
    for (const TextBox& column : columns) {
      Vec2 line = *at + column.margin;
      for (const std::string& text : column.lines) {
        hud.canvas.text(line, text, column.text_size, column.color);
        line.y += hud.canvas.line_height(column.text_size);
      }
      at->x += column.size(hud.canvas).x;
    }
    return;
  }
}

/// Draws a headline with a line below it at the top, or a line alone at the bottom.
void draw_message(Hud hud) {
  const ViewOptions& options = hud.options;
  if (options.headline.empty() && options.below.empty()) return;
  TextBox box;
  box.headline = options.headline;
  box.headline_size = 44.0 * hud.scale();
  box.text_size = (options.headline.empty() ? 21.0 : 19.0) * hud.scale();
  box.align = Align::center;
  box.margin = hud.scale() * (options.headline.empty() ? Vec2{17.0, 6.0} : Vec2{35.0, 10.0});
  box.lines = wrapped(hud.canvas, options.below, box.text_size, hud.area().size.x - 2.0 * box.margin.x);
  const Vec2 size = box.size(hud.canvas);
  const Vec2 top = hud.corner(size, 0.5, options.headline.empty() ? 0.02 : 0.08);
  const Vec2 bottom = hud.corner(size, 0.5, 0.95);
  hud.draw(box, options.headline.empty() ? std::array{bottom, top} : std::array{top, bottom}, hud.places.message);
}

/// Draws the time at a checkpoint below the time of the run, and the difference to the compared run. Its sign tells it
/// without the colour.
void draw_split(Hud hud) {
  if (hud.options.split == nullptr) return;
  const SplitMessage& split = *hud.options.split;
  const Color ahead = hud.options.colour_safe ? Color{120, 190, 255} : Color{130, 225, 130};
  const Color behind = hud.options.colour_safe ? Color{255, 180, 70} : Color{255, 140, 120};
  TextBox box;
  box.text_size = 21.0 * hud.scale();
  box.margin = box.text_size * Vec2{0.6, 0.2};
  box.color = split.difference.empty() ? hud_style::faint : split.is_ahead ? ahead : behind;
  box.lines = {split.difference.empty()
                   ? split.time
                   : words::filled(words::two_parts, {{"first", split.time}, {"second", split.difference}})};
  const Vec2 size = box.size(hud.canvas);
  hud.draw(box, std::array{hud.corner(size, 1.0, 0.1), hud.corner(size, 1.0, 0.9)}, hud.places.split);
}

/// Draws the distance to the goal at the edge of the screen, if the goal is outside.
void draw_goal_distance(Hud hud) {
  if (!hud.simulation.level().goal || hud.simulation.goal_ticks()) return;
  const Vec2 goal = hud.simulation.level().goal->center;
  const Vec2 there = hud.canvas.to_pixels(goal);
  if (there.x >= 0.0 && there.x <= hud.canvas.width()) return;
  const bool right = there.x > 0.0;
  const int metres = static_cast<int>(std::lround(std::abs(goal.x - hud.simulation.player().position().x)));
  TextBox box;
  box.lines = {words::filled(right ? words::flag_right : words::flag_left, {{"metres", std::to_string(metres)}})};
  box.text_size = 18.0 * hud.scale();
  box.color = hud_style::gold;
  box.margin = box.text_size * Vec2{0.6, 0.2};
  const double y = std::clamp(there.y / hud.canvas.height(), 0.35, 0.65);
  const Vec2 size = box.size(hud.canvas);
  hud.draw(box, std::array{hud.corner(size, right ? 1.0 : 0.0, y)}, hud.places.goal);
}

void draw_notice_in(Hud hud) {
  if (hud.options.notice == nullptr || *hud.options.notice == '\0') return;
  TextBox box;
  box.text_size = 18.0 * hud.scale();
  box.color = hud_style::gold;
  box.margin = hud.scale() * Vec2{14.0, 7.0};
  box.lines = wrapped(hud.canvas, hud.options.notice, box.text_size, 0.6 * hud.area().size.x, 4);
  const Vec2 size = box.size(hud.canvas);
  hud.draw(box,
           std::array{hud.corner(size, 1.0, 1.0), hud.corner(size, 0.0, 1.0), hud.corner(size, 0.5, 0.0),
                      hud.corner(size, 1.0, 0.8)},
           hud.places.notice);
}

void draw_legend(Hud hud) {
  const Vec2 size = strain_legend_size(hud.canvas, hud.scale());
  const auto at = hud.space.place(
      size, std::array{hud.corner(size, 1.0, 0.5), hud.corner(size, 0.0, 0.5), hud.corner(size, 0.0, 1.0)},
      hud.places.legend);
  if (at) draw_strain_legend(hud.canvas, *at, hud.scale());
}

void draw_figures(Hud hud) {
  const Vec2 most{hud.area().size.x, 0.55 * hud.area().size.y};
  const DebugFigures figures(hud.canvas, hud.simulation, hud.options.meter, hud.scale(), most);
  const auto at = hud.space.place(
      figures.size(), std::array{hud.corner(figures.size(), 0.0, 1.0), hud.corner(figures.size(), 0.0, 0.5)},
      hud.places.figures);
  if (at) figures.draw(hud.canvas, *at);
}

}  // namespace

std::string seconds_in_words(int ticks) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f", static_cast<double>(ticks) / ticks_per_second);
  return words::filled(words::seconds, {{"number", text.data()}});
}

void draw_notice(Canvas& canvas, const std::string& notice, double text_scale) {
  TextBox box;
  box.text_size = 15.0 * text_scale;
  box.color = hud_style::gold;
  box.align = Align::center;
  box.margin = text_scale * Vec2{14.0, 2.0};
  const double most = canvas.width() - 2.0 * (box.margin.x + gap * text_scale);
  box.lines = wrapped(canvas, notice, box.text_size, most, 2);
  const Vec2 size = box.size(canvas);
  box.draw(canvas, {0.5 * (canvas.width() - size.x), std::max(0.5 * (notice_strip * text_scale - size.y), 0.0)});
}

void draw_hud(Canvas& canvas, const Simulation& simulation, const ViewOptions& options, const HudObstacles& obstacles,
              HudPlaces& last_places) {
  FreeSpace space(area_of(canvas, options), gap * options.text_scale);
  for (const Rectangle& label : obstacles.labels) space.take(label);
  if (options.panel.size.x > 0.0) space.take(options.panel);
  const Hud hud{canvas, simulation, options, space, last_places};
  draw_time(hud);
  draw_split(hud);
  draw_message(hud);
  space.take(obstacles.player);
  if (options.keys != nullptr && !options.keys->empty()) draw_keys(hud);
  draw_notice_in(hud);
  draw_goal_distance(hud);
  if (options.debug && options.panel.size.x == 0.0) draw_figures(hud);
  if (options.strain_tint) draw_legend(hud);
}

}  // namespace game
