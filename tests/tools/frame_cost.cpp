// Prints the processor time of a frame over the ticks of recorded runs: all in assets/replays, or the given ones:
//   build/release/bin/frame_cost
//   build/release/bin/frame_cost assets/replays/curtains.replay --size 1920x1080 --frames
// tick: the physics; lists: the meshes of everything drawn; both: these two of one tick together; first: the lists of
// the first frame, which also creates the images, and is in no other column; raster: the pixels, in memory; frame:
// lists and pixels, which is a frame apart from the driver. Every tick of a run is deterministic, so its cost is the
// minimum of a few runs, which excludes other work of the machine.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/window/sdl_canvas.h"
#include "game/simulation/recorded_run.h"
#include "game/view/view.h"

namespace {

/// Receives the meshes and draws nothing: the measured cost is that of the meshes.
class Lists : public engine::HeadlessCanvas {
 public:
  using engine::HeadlessCanvas::HeadlessCanvas;

 protected:
  void paint_mesh(const engine::Mesh&, engine::Color) override {}
  void paint_textured(const engine::TexturedMesh&, const engine::Texture&, const engine::PixelBox&) override {}
  void paint_text(ribbon::Vec2, std::string_view, double, engine::Color) override {}
  void paint_skyline(std::span<const ribbon::Vec2>, const engine::SkylineLook&) override {}
};

struct Options {
  std::vector<std::string> replays;
  int runs = 3;
  int most_ticks = 1'000'000;
  int width = 1280;
  int height = 720;
  bool debug = false;
  bool frames = false;
};

/// Costs of one tick, ms, each the minimum over the runs.
struct TickCost {
  double tick = 1e9;
  double lists = 1e9;
  double frame = 1e9;
  int newton_steps = 0;  // summed over all cords, including those solved together
};

double now_ms() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

template <typename Work>
void take(double& least, Work work) {
  const double begun = now_ms();
  work();
  least = std::min(least, now_ms() - begun);
}

int newton_steps(const ribbon::box2d::Coupling& coupling) {
  int sum = 0;
  for (const ribbon::box2d::CordId c : coupling.cords()) sum += coupling.cord(c).island_report().iterations;
  return sum;
}

void measure(const std::string& replay, const Options& options, std::vector<TickCost>& costs) {
  game::RunOptions asked;
  asked.replay = replay;
  game::RecordedRun run(asked);
  game::View view_of_lists(run.simulation());
  game::View view(run.simulation());
  Lists lists(options.width, options.height);
  engine::HeadlessCanvas canvas(options.width, options.height);
  game::ViewOptions shown;
  shown.debug = options.debug;
  for (std::size_t k = 0; !run.is_over() && run.simulation().ticks() < options.most_ticks; ++k) {
    if (k == costs.size()) costs.emplace_back();
    take(costs[k].tick, [&] { run.tick({}); });
    take(costs[k].lists, [&] { view_of_lists.draw(lists, 1.0, shown); });
    if (options.frames) take(costs[k].frame, [&] { view.draw(canvas, 1.0, shown); });
    costs[k].newton_steps = newton_steps(run.simulation().scene().coupling());
  }
}

template <typename Of>
void print(const std::vector<TickCost>& costs, Of of) {
  std::vector<double> values;
  // The first frame is in a column of its own.
  for (std::size_t k = costs.size() > 1 ? 1 : 0; k < costs.size(); ++k) values.push_back(of(costs[k]));
  std::sort(values.begin(), values.end());
  std::printf("  %6.3f %6.3f", values[values.size() / 2], values.back());
}

void print_row(const std::string& name, const std::vector<TickCost>& costs, double first, const Options& options) {
  const auto most = std::max_element(
      costs.begin(), costs.end(), [](const TickCost& a, const TickCost& b) { return a.newton_steps < b.newton_steps; });
  std::printf("%-15s %5zu", name.c_str(), costs.size());
  print(costs, [](const TickCost& cost) { return cost.tick; });
  print(costs, [](const TickCost& cost) { return cost.lists; });
  print(costs, [](const TickCost& cost) { return cost.tick + cost.lists; });
  std::printf("  %7d  %6.1f", most->newton_steps, first);
  if (options.frames) {
    print(costs, [](const TickCost& cost) { return cost.frame - cost.lists; });
    print(costs, [](const TickCost& cost) { return cost.frame; });
  }
  std::printf("\n");
  std::fflush(stdout);
}

std::vector<std::string> all_replays() {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(game::assets_folder() + "/replays"))
    if (entry.path().extension() == ".replay") paths.push_back(entry.path().string());
  std::sort(paths.begin(), paths.end());
  return paths;
}

int measure_all(const Options& options) {
  std::printf("%d x %d, ms, median and worst; each tick the least of %d runs\n", options.width, options.height,
              options.runs);
  std::printf("%-15s %5s  %-13s  %-13s  %-13s  %7s  %6s%s\n", "run", "ticks", "tick", "lists", "both", "Newton",
              "first", options.frames ? "  raster         frame" : "");
  for (const std::string& replay : options.replays.empty() ? all_replays() : options.replays) {
    std::vector<TickCost> costs;
    double first = 0.0;
    for (int run = 0; run < options.runs; ++run) {
      measure(replay, options, costs);
      if (run == 0 && !costs.empty()) first = costs.front().lists;
    }
    if (costs.empty()) continue;
    print_row(std::filesystem::path(replay).stem().string(), costs, first, options);
  }
  return 0;
}

std::string is_size(const std::string& text) {
  int width = 0;
  int height = 0;
  char more = 0;
  const bool two = std::sscanf(text.c_str(), "%5dx%5d%c", &width, &height, &more) == 2;
  if (two && width >= 1 && height >= 1 && width <= 16384 && height <= 16384) return {};
  return "the size is " + text + "; accepted is WIDTHxHEIGHT, 1 to 16384 pixels each, as in 1920x1080";
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"What a frame costs."};
  Options options;
  app.add_option("replays", options.replays, "The runs; all in assets/replays unless given");
  app.add_option("--runs", options.runs, "How often each is played")->check(CLI::Range(1, 1000));
  std::string size = "1280x720";
  app.add_option("--size", size, "WIDTHxHEIGHT, px")->check(CLI::Validator(is_size, "WIDTHxHEIGHT", "size"));
  app.add_option("--ticks", options.most_ticks, "Stop after so many")->check(CLI::Range(1, 1'000'000'000));
  app.add_flag("--debug", options.debug, "With the debug view");
  app.add_flag("--frames", options.frames, "Rasterise too");
  CLI11_PARSE(app, argc, argv);
  std::sscanf(size.c_str(), "%dx%d", &options.width, &options.height);
  try {
    return measure_all(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "frame_cost: %s\n", error.what());
    return 1;
  }
}
