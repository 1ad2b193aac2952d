#include "game/view/hud.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace game {
namespace {

using engine::Align;
using engine::Canvas;
using engine::Color;
using ribbon::Vec2;

constexpr Color paper{20, 24, 34, 150};
constexpr Color white{255, 255, 255};
constexpr Color faint{206, 216, 226};
constexpr Color gold{255, 212, 92};

struct Lines {
  std::vector<std::string> text;
  double size;  // px
  Color color;
};

/// Draws lines on a panel of their size with its top left corner at `at`.
void draw_box(Canvas& canvas, Vec2 at, const Lines& lines) {
  double width = 0.0;
  for (const std::string& line : lines.text) width = std::max(width, canvas.text_width(line, lines.size));
  const double step = canvas.line_height(lines.size);
  const double margin = 0.6 * lines.size;
  const double height = step * static_cast<double>(lines.text.size());
  canvas.panel(at, {width + 2.0 * margin, height + margin}, 0.5 * lines.size, paper);
  for (std::size_t k = 0; k < lines.text.size(); ++k) {
    canvas.text(at + Vec2{margin, 0.5 * margin + step * static_cast<double>(k)}, lines.text[k], lines.size,
                lines.color);
  }
}

/// Draws a headline with a line below it at the top of the screen.
void draw_banner(Canvas& canvas, const std::string& headline, const std::string& below, double scale) {
  const Vec2 middle{0.5 * canvas.width(), 0.10 * canvas.height()};
  const double large = 44.0 * scale;
  const double small = 19.0 * scale;
  const double width = std::max(canvas.text_width(headline, large), canvas.text_width(below, small)) + 70.0 * scale;
  const double height = canvas.line_height(large) + canvas.line_height(small) + 30.0 * scale;
  canvas.panel(middle - Vec2{0.5 * width, 0.0}, {width, height}, 16.0 * scale, {20, 24, 34, 190});
  canvas.text(middle + Vec2{0.0, 10.0 * scale}, headline, large, gold, Align::center);
  canvas.text(middle + Vec2{0.0, 14.0 * scale + canvas.line_height(large)}, below, small, white, Align::center);
}

/// A table with right-aligned columns; the first row has the titles.
using Table = std::vector<std::vector<std::string>>;

std::vector<std::string> in_words(std::initializer_list<int> counts) {
  std::vector<std::string> row;
  for (const int count : counts) row.push_back(std::to_string(count));
  return row;
}

int points_of(const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord) {
  return static_cast<int>(coupling.cord(cord).positions().size());
}

Table thesis_counts(const ribbon::box2d::Coupling& coupling) {
  Table table = {
      {"cord", "points", "self", "circles", "tangled", "FEM skipped in all", "held back in all", "strained"}};
  for (const ribbon::box2d::CordId c : coupling.cords()) {
    if (coupling.cord(c).solver() != ribbon::box2d::Solver::thesis) continue;
    const ribbon::StepReport& report = coupling.cord(c).thesis_report();
    const ribbon::StepReport& total = coupling.cord(c).thesis_total();
    table.push_back(in_words({c, points_of(coupling, c), report.self_contacts, report.circle_contacts,
                              report.tangled_columns, total.fem_skipped, total.motion_limited, report.strained_bars}));
  }
  return table;
}

/// Returns a fraction in per cent with two significant digits.
std::string per_cent(double fraction) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2g %%", 100.0 * fraction);
  return text.data();
}

/// Returns a length in millimetres without the unit, with two significant digits below 1 cm.
std::string millimetres(double metres) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), metres < 1e-2 ? "%.2g" : "%.0f", 1e3 * metres);
  return text.data();
}

/// Returns the cost of a tick and the budget of 1/60 s.
std::string cost_in_words(const Meter& meter) {
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), "a tick: %.0f µs, at most %.0f µs in the last second (of 16667)",
                meter.median_us(), meter.worst_us());
  return text.data();
}

Table direct_counts(const ribbon::box2d::Coupling& coupling, const Meter* meter) {
  Table table = {
      {"cord", "points", "touches", "iterations", "impacts in all", "fallbacks in all", "unconverged in all"}};
  if (meter != nullptr) table.front().insert(table.front().end(), {"peak stretch", "est. error mm/s"});
  for (const ribbon::box2d::CordId c : coupling.cords()) {
    if (coupling.cord(c).solver() != ribbon::box2d::Solver::direct) continue;
    const ribbon::IslandReport& total = coupling.cord(c).island_total();
    const auto touches = static_cast<int>(coupling.cord(c).direct().touches().size());
    table.push_back(in_words({c, points_of(coupling, c), touches, coupling.cord(c).island_report().iterations,
                              total.impacts, total.fallbacks, total.unconverged}));
    if (coupling.cord(c).direct().is_asleep()) table.back()[3] = "asleep";
    if (meter == nullptr) continue;
    table.back().push_back(per_cent(meter->peak_stretch(c)));
    table.back().push_back(millimetres(meter->error_per_second(c)));
  }
  return table;
}

/// Returns the right edge of each column in px from the left edge of the panel.
std::vector<double> column_edges(const Canvas& canvas, const Table& table, double size, double margin) {
  std::vector<double> right;
  for (const std::string& title : table.front()) {
    right.push_back((right.empty() ? margin : right.back() + margin) + canvas.text_width(title, size));
  }
  return right;
}

/// Draws the figures of all cords at the bottom left, in one table per solver, with a legend.
void draw_counts(Canvas& canvas, const Simulation& simulation, const Meter* meter, double scale) {
  const ribbon::box2d::Coupling& coupling = simulation.scene().coupling();
  std::vector<std::string> legend = {
      "points: blue free, grey asleep, yellow dragged, red constrained; pink: contacts; boxes: what a cord may reach",
      "ropes: tension, from violet (1 N) to yellow (10 kN); red cells are inside out"};
  if (meter != nullptr) legend.push_back(cost_in_words(*meter));
  const double size = 14.0 * scale;
  const double margin = 14.0 * scale;
  const double step = canvas.line_height(size);
  Vec2 box{0.0, step * static_cast<double>(legend.size()) + margin};
  for (const std::string& line : legend) box.x = std::max(box.x, canvas.text_width(line, size) + 2.0 * margin);
  std::vector<Table> tables;
  for (Table& table : std::array{thesis_counts(coupling), direct_counts(coupling, meter)}) {
    if (table.size() == 1) continue;  // titles only
    box.x = std::max(box.x, column_edges(canvas, table, size, margin).back() + margin);
    box.y += step * static_cast<double>(table.size());
    tables.push_back(std::move(table));
  }
  const Vec2 corner{margin, canvas.height() - margin - box.y};
  canvas.panel(corner, box, 0.5 * size, paper);
  double y = 0.5 * margin;
  for (const Table& table : tables) {
    const std::vector<double> right = column_edges(canvas, table, size, margin);
    for (const std::vector<std::string>& row : table) {
      for (std::size_t k = 0; k < row.size(); ++k) {
        canvas.text(corner + Vec2{right[k], y}, row[k], size, faint, Align::right);
      }
      y += step;
    }
  }
  for (const std::string& line : legend) {
    canvas.text(corner + Vec2{margin, y}, line, size, faint);
    y += step;
  }
}

/// Draws a line at the bottom in the middle, or below the time, to leave space for the figures of the debug view.
void draw_line(Canvas& canvas, const std::string& line, double scale, bool at_top) {
  if (line.empty()) return;
  const double size = 21.0 * scale;
  const Vec2 box{canvas.text_width(line, size) + 1.6 * size, canvas.line_height(size) + 0.6 * size};
  const double y = at_top ? 60.0 * scale : canvas.height() - box.y - 60.0 * scale;
  const Vec2 corner{at_top ? canvas.width() - box.x - 14.0 * scale : 0.5 * (canvas.width() - box.x), y};
  canvas.panel(corner, box, 0.5 * size, paper);
  canvas.text(corner + Vec2{0.8 * size, 0.3 * size}, line, size, white);
}

/// Draws the time at a checkpoint below the time of the run, and the difference to the compared run. Its sign tells it
/// without the colour.
void draw_split(Canvas& canvas, const SplitMessage& split, double scale, bool colour_safe, double y) {
  const Color ahead = colour_safe ? Color{120, 190, 255} : Color{130, 225, 130};
  const Color behind = colour_safe ? Color{255, 180, 70} : Color{255, 140, 120};
  const double size = 21.0 * scale;
  const double gap = split.difference.empty() ? 0.0 : 0.6 * size;
  const double right = canvas.width() - 14.0 * scale - 0.6 * size;
  const double width = canvas.text_width(split.difference, size) + gap + canvas.text_width(split.time, size);
  canvas.panel({right - width - 0.6 * size, y}, {width + 1.2 * size, canvas.line_height(size) + 0.4 * size}, 0.5 * size,
               paper);
  canvas.text({right, y + 0.2 * size}, split.difference, size, split.is_ahead ? ahead : behind, Align::right);
  canvas.text({right - canvas.text_width(split.difference, size) - gap, y + 0.2 * size}, split.time, size, faint,
              Align::right);
}

/// Draws the distance to the goal at the edge of the screen, if the goal is outside.
void draw_goal_distance(Canvas& canvas, const Simulation& simulation, double scale) {
  if (!simulation.level().goal) return;
  const Vec2 goal = simulation.level().goal->center;
  const Vec2 there = canvas.to_pixels(goal);
  const double width = canvas.width();
  if (there.x >= 0.0 && there.x <= width) return;
  const bool right = there.x > width;
  const int metres = static_cast<int>(std::lround(std::abs(goal.x - simulation.player().position().x)));
  const std::string far = std::to_string(metres) + " m";
  const std::string words = right ? "flag " + far + " →" : "← flag " + far;
  const double size = 18.0 * scale;
  const double margin = 14.0 * scale;
  const Vec2 box{canvas.text_width(words, size) + 1.2 * size, canvas.line_height(size) + 0.4 * size};
  const double y = std::clamp(there.y, 0.35 * canvas.height(), 0.65 * canvas.height());
  const Vec2 corner{right ? width - margin - box.x : margin, y};
  canvas.panel(corner, box, 0.5 * size, paper);
  canvas.text(corner + Vec2{0.6 * size, 0.2 * size}, words, size, gold);
}

}  // namespace

std::string seconds_in_words(int ticks) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f s", static_cast<double>(ticks) / ticks_per_second);
  return text.data();
}

void draw_notice(Canvas& canvas, const std::string& notice, double scale) {
  const double margin = 14.0 * scale;
  const double size = 18.0 * scale;
  const Vec2 box{canvas.text_width(notice, size) + 2.0 * margin, canvas.line_height(size) + margin};
  // Above the line of keys that menus have at the bottom.
  const Vec2 corner{canvas.width() - margin - box.x, canvas.height() - 44.0 * scale - box.y};
  canvas.panel(corner, box, 0.5 * size, paper);
  canvas.text(corner + Vec2{margin, 0.5 * margin}, notice, size, gold);
}

void draw_hud(Canvas& canvas, const Simulation& simulation, const ViewOptions& options) {
  const double scale = options.text_scale;
  const double margin = 14.0 * scale;
  const auto goal = simulation.goal_ticks();
  const std::string time = seconds_in_words(goal.value_or(simulation.run_ticks()));
  const std::string falls = simulation.falls() == 0 ? "" : "   falls " + std::to_string(simulation.falls());
  const std::size_t coins = simulation.level().rules.coins.size();
  const std::string found =
      coins == 0 ? "" : "   coins " + std::to_string(simulation.coins()) + "/" + std::to_string(coins);
  const double right = canvas.width() - margin;
  const double width = canvas.text_width(time + falls + found, 24.0 * scale);
  canvas.panel({right - width - 1.6 * margin, margin}, {width + 1.6 * margin, 38.0 * scale}, 10.0 * scale, paper);
  canvas.text({right - 0.8 * margin, margin + 5.0 * scale}, time + falls + found, 24.0 * scale, white, Align::right);

  if (options.split != nullptr) {
    draw_split(canvas, *options.split, scale, options.colour_safe, (options.debug ? 104.0 : 60.0) * scale);
  }
  if (!goal) draw_goal_distance(canvas, simulation, scale);
  if (options.keys != nullptr) draw_box(canvas, {margin, margin}, {*options.keys, std::max(15.0 * scale, 12.0), faint});
  if (options.notice != nullptr) draw_notice(canvas, options.notice, scale);
  if (options.debug) draw_counts(canvas, simulation, options.meter, scale);
  if (options.headline.empty()) {
    draw_line(canvas, options.below, scale, options.debug);
  } else {
    draw_banner(canvas, options.headline, options.below, scale);
  }
}

}  // namespace game
