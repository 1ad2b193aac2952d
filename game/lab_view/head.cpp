#include "game/lab_view/head.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "game/lab/figures.h"
#include "game/lab_view/look.h"
#include "game/lab_view/numbers.h"
#include "game/view/text_box.h"
#include "game/words/words.h"

namespace game::lab {
namespace {

using ribbon::Vec2;

// Units of text.
constexpr double head_title_size = 22.0;
constexpr double head_text_size = 13.5;
constexpr double head_margin = 12.0;
constexpr std::size_t about_lines = 2;
constexpr std::size_t figure_lines = 2;  // of each bench
constexpr double least_shown = 1e-12;    // of lengths in m and strains; what is less is rounding

double without_rounding(double number) { return std::abs(number) < least_shown ? 0.0 : number; }

std::string in_words(const Reading& reading) {
  using Kind = Reading::Kind;
  const auto say = [](const char* text, const std::string& number) {
    return words::filled(text, {{"number", number}});
  };
  switch (reading.kind) {
    case Kind::excess:
      return words::filled(words::lab::excess, {{"length", length_text(without_rounding(reading.value))}});
    case Kind::pull_ratio:
      return std::isfinite(reading.value) ? say(words::lab::pull_ratio, short_text(reading.value)) : "";
    case Kind::holding_limit: return say(words::lab::holding_limit, short_text(reading.value));
    case Kind::critical_load: return say(words::lab::critical_load, short_text(reading.value));
    case Kind::awake: return say(words::lab::awake, short_text(reading.value));
    case Kind::contacts: return say(words::lab::contacts, short_text(reading.value));
    case Kind::unconverged: return reading.value > 0.0 ? say(words::lab::unconverged, short_text(reading.value)) : "";
    case Kind::self_contacts: return say(words::lab::self_contacts, short_text(reading.value));
    case Kind::turned_over: return say(words::lab::turned_over, short_text(reading.value));
  }
  return "";
}

const char* name_of(const Bench& bench) {
  if (bench.method() == Method::chains) return words::lab::of_chains;
  const bool thesis = bench.coupling().cord(0).solver() == ribbon::box2d::Solver::thesis;
  return thesis ? words::lab::of_thesis : words::lab::of_cords;
}

}  // namespace

const words::lab::SceneWords& words_of(const Scene& scene) {
  return *std::find_if(std::begin(words::lab::scenes), std::end(words::lab::scenes),
                       [&](const words::lab::SceneWords& each) { return each.name == scene.name; });
}

std::vector<std::string> figures_of(const Experiment& experiment, std::span<const TickCost> costs) {
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < experiment.benches().size(); ++k) {
    const Bench& bench = *experiment.benches()[k];
    std::string line = words::filled(words::lab::bench_figures,
                                     {{"bench", name_of(bench)},
                                      {"median", fixed_text(costs[k].median_us(), 0)},
                                      {"worst", fixed_text(costs[k].worst_us(), 0)},
                                      {"stretch", short_text(100.0 * without_rounding(greatest_stretch(bench)))}});
    for (const Reading& reading : experiment.scene().readings(bench, experiment.values())) {
      const std::string text = in_words(reading);
      if (!text.empty()) line += words::lab::between_figures + text;
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

void draw_head(engine::Canvas& canvas, const Experiment& experiment, std::span<const std::string> figures,
               const Layout& layout, bool has_notice) {
  canvas.panel(layout.head.corner, layout.head.size, 0.0, look::strip);
  const words::lab::SceneWords& about = words_of(experiment.scene());
  const double size = head_text_size * layout.unit;
  const double line = canvas.line_height(size);
  const double left = layout.head.corner.x + head_margin * layout.unit;
  const double width = layout.head.size.x - 2.0 * head_margin * layout.unit;
  if (!has_notice) {
    const double title = head_title_size * layout.unit;
    canvas.text({left, 0.5 * (top_strip * layout.unit - canvas.line_height(title))}, about.title, title, look::gold);
  }
  double y = top_strip * layout.unit;
  for (const std::string& text : wrapped(canvas, about.about, size, width, about_lines)) {
    canvas.text({left, y}, text, size, look::faint);
    y += line;
  }
  // From the bottom upwards, so that they stand still above the world.
  y = layout.head.size.y - 2.0 * layout.unit;
  constexpr std::array colors = {look::cord, look::chain};
  for (std::size_t k = figures.size(); k-- > 0;) {
    const std::vector<std::string> lines = wrapped(canvas, figures[k], size, width, figure_lines);
    y -= line * static_cast<double>(lines.size());
    for (std::size_t row = 0; row < lines.size(); ++row)
      canvas.text({left, y + line * static_cast<double>(row)}, lines[row], size,
                  colors[std::min(k, colors.size() - 1)]);
  }
}

}  // namespace game::lab
