#include "game/hud.h"

#include <array>
#include <cstdio>
#include <string>
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

/// A panel just large enough for its lines, with its top left corner at `at`.
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

/// A headline with a line below it, in the middle of the screen.
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

std::vector<std::string> keys_in_words() {
  return {
      "Arrows or A D: run, pump", "Space: jump, let go",           "Hold E or Shift: catch a cord", "R: start again",
      "P: pause   N: one tick",   "F1: debug view, drag by mouse", "F12: screenshot   H: hide this"};
}

std::vector<std::string> counts_in_words(const Simulation& simulation) {
  std::vector<std::string> lines = {"cord   points  self  circles  FEM skipped  held back"};
  const engine::Coupling& coupling = simulation.scene().coupling();
  for (int c = 0; c < coupling.size(); ++c) {
    const ribbon::StepReport& report = coupling.report(c);
    std::array<char, 96> line{};
    std::snprintf(line.data(), line.size(), "%4d %9d %7d %8d %12d %12d", c, coupling.cord(c).mesh().size(),
                  report.self_contacts, report.circle_contacts, report.fem_skipped, report.motion_limited);
    lines.emplace_back(line.data());
  }
  lines.emplace_back("points: blue free, yellow dragged, red constrained");
  return lines;
}

}  // namespace

std::string seconds_in_words(int ticks) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f s", static_cast<double>(ticks) / ticks_per_second);
  return text.data();
}

void draw_hud(Canvas& canvas, const Simulation& simulation, const ViewOptions& options) {
  const double scale = options.text_scale;
  const double margin = 14.0 * scale;
  const auto goal = simulation.goal_ticks();
  const std::string time = seconds_in_words(goal.value_or(simulation.run_ticks()));
  const std::string falls = simulation.falls() == 0 ? "" : "   falls " + std::to_string(simulation.falls());
  const double right = canvas.width() - margin;
  const double width = canvas.text_width(time + falls, 24.0 * scale);
  canvas.panel({right - width - 1.6 * margin, margin}, {width + 1.6 * margin, 38.0 * scale}, 10.0 * scale, paper);
  canvas.text({right - 0.8 * margin, margin + 5.0 * scale}, time + falls, 24.0 * scale, white, Align::right);

  if (options.help) draw_box(canvas, {margin, margin}, {keys_in_words(), 15.0 * scale, faint});
  if (options.debug) {
    const Lines counts{counts_in_words(simulation), 14.0 * scale, faint};
    const double height = canvas.line_height(counts.size) * static_cast<double>(counts.text.size()) + counts.size;
    draw_box(canvas, {margin, canvas.height() - height - margin}, counts);
  }
  if (options.paused) {
    draw_banner(canvas, "Paused", "P to go on, N for one tick", scale);
  } else if (goal) {
    draw_banner(canvas, "You made it!", "in " + time + (options.watching ? "" : "   R to try again"), scale);
  } else if (options.watching) {
    canvas.text({0.5 * canvas.width(), margin}, "watching a replay", 20.0 * scale, white, Align::center);
  }
}

}  // namespace game
