#include "game/lab_view/plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "game/lab_view/look.h"
#include "game/lab_view/numbers.h"
#include "game/words/lab_words.h"

namespace game::lab {
namespace {

using engine::Canvas;
using ribbon::Vec2;

constexpr double plot_text_size = 12.0;  // units of text
constexpr double plot_margin = 8.0;      // the same
constexpr double least_energy = 0.01;    // J, shown range
constexpr double least_log = -10.0;      // decimal logarithm of the smallest stretch that is shown
constexpr double most_log = 3.0;

using Numbers = std::vector<std::vector<double>>;  // of each bench

struct Plot {
  const char* title;
  Numbers numbers;
  PlotRange range;
  std::string low, high;  // labels
};

Numbers numbers_of(const History& history, std::size_t benches,
                   const std::function<double(const History::Sample&)>& of) {
  Numbers numbers(benches);
  for (std::size_t bench = 0; bench < benches; ++bench) {
    for (std::size_t k = 0; k < history.size(); ++k) numbers[bench].push_back(of(history.sample(bench, k)));
  }
  return numbers;
}

std::vector<double> all_of(const Numbers& numbers) {
  std::vector<double> all;
  for (const std::vector<double>& each : numbers) all.insert(all.end(), each.begin(), each.end());
  return all;
}

double logarithm(double stretch) {
  return std::clamp(std::log10(std::max(std::abs(stretch), 1e-30)), least_log, most_log);
}

Plot energy_plot(const History& history, std::size_t benches) {
  Plot plot{words::lab::energy_plot, numbers_of(history, benches, [](const auto& s) { return s.energy; }), {}, "", ""};
  plot.range = range_around(all_of(plot.numbers), least_energy);
  // What is small beside the range is rounding.
  const double small = 1e-4 * (plot.range.high - plot.range.low);
  plot.low = energy_text(std::abs(plot.range.low) < small ? 0.0 : plot.range.low);
  plot.high = energy_text(std::abs(plot.range.high) < small ? 0.0 : plot.range.high);
  return plot;
}

/// Its axis is logarithmic, in whole decades.
Plot stretch_plot(const History& history, std::size_t benches) {
  Plot plot{words::lab::stretch_plot,
            numbers_of(history, benches, [](const auto& s) { return logarithm(s.stretch); }),
            {},
            "",
            ""};
  const PlotRange range = range_around(all_of(plot.numbers), 0.0);
  plot.range = {std::floor(range.low), std::max(std::ceil(range.high), std::floor(range.low) + 1.0)};
  plot.low = short_text(100.0 * std::pow(10.0, plot.range.low));
  plot.high = short_text(100.0 * std::pow(10.0, plot.range.high));
  return plot;
}

void draw(Canvas& canvas, const Plot& plot, const Rectangle& place, double unit) {
  canvas.panel(place.corner, place.size, 4.0 * unit, look::field);
  const double size = plot_text_size * unit;
  const double line = canvas.line_height(size);
  const Vec2 inner = place.corner + Vec2{plot_margin * unit, line + 3.0 * unit};
  const Vec2 extent = place.size - Vec2{2.0 * plot_margin * unit, 2.0 * line + 6.0 * unit};
  constexpr std::array colors = {look::cord, look::chain};
  for (std::size_t bench = plot.numbers.size(); bench-- > 0;) {
    const std::vector<double>& numbers = plot.numbers[bench];
    std::vector<Vec2> points;
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      const double up = (numbers[k] - plot.range.low) / (plot.range.high - plot.range.low);
      const double right = 1.0 - static_cast<double>(numbers.size() - 1 - k) / (History::length - 1);
      points.push_back(inner + Vec2{right * extent.x, (1.0 - std::clamp(up, 0.0, 1.0)) * extent.y});
    }
    engine::Mesh mesh;
    if (points.size() > 1) add_polyline(mesh, points, 1.8 * unit);
    canvas.mesh(mesh, colors[std::min(bench, colors.size() - 1)]);
  }
  const double right = place.corner.x + place.size.x - plot_margin * unit;
  const double bottom = place.corner.y + place.size.y - line - 1.0 * unit;
  canvas.text({inner.x, place.corner.y + 1.0 * unit}, plot.title, size, look::faint);
  canvas.text({right, place.corner.y + 1.0 * unit}, plot.high, size, look::white, engine::Align::right);
  canvas.text({right, bottom}, plot.low, size, look::white, engine::Align::right);
  canvas.text({inner.x, bottom}, words::lab::plot_time, size, look::faint);
}

}  // namespace

PlotRange range_around(std::span<const double> numbers, double least) {
  double low = 0.0;
  double high = 0.0;
  bool is_first = true;
  for (const double number : numbers) {
    if (!std::isfinite(number)) continue;
    low = is_first ? number : std::min(low, number);
    high = is_first ? number : std::max(high, number);
    is_first = false;
  }
  const double missing = std::max(least - (high - low), 0.0);
  return {low - 0.5 * missing, high + 0.5 * missing};
}

void draw_plots(Canvas& canvas, const History& history, std::size_t benches, const Layout& layout) {
  const double gap = plot_margin * layout.unit;
  canvas.panel(layout.plots.corner, layout.plots.size, 0.0, look::strip);
  const Vec2 size{0.5 * (layout.plots.size.x - 3.0 * gap), layout.plots.size.y - 2.0 * gap};
  const Vec2 corner = layout.plots.corner + Vec2{gap, gap};
  draw(canvas, energy_plot(history, benches), {corner, size}, layout.unit);
  draw(canvas, stretch_plot(history, benches), {corner + Vec2{size.x + gap, 0.0}, size}, layout.unit);
}

}  // namespace game::lab
