// What a frame costs, by the processor's time, median and worst over the ticks of a replay:
//   build/release/bin/frame_cost assets/replays/first_swing.replay
// ticks (the physics), lists (everything that is drawn, as meshes), and the same rasterised in memory.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <exception>
#include <string>
#include <vector>

#include "engine/sdl_canvas.h"
#include "game/recorded_run.h"
#include "game/view.h"

namespace {

/// Takes the meshes and paints nothing: what is left is the cost of making them.
class Lists : public engine::HeadlessCanvas {
 public:
  using engine::HeadlessCanvas::HeadlessCanvas;

 protected:
  void paint_mesh(const engine::Mesh&, engine::Color) override {}
  void paint_textured(const engine::TexturedMesh&, const engine::Texture&, const engine::PixelBox&) override {}
  void paint_text(ribbon::Vec2, std::string_view, double, engine::Color) override {}
};

double now_ms() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

template <typename Work>
void take(std::vector<double>& times, Work work) {
  const double begun = now_ms();
  work();
  times.push_back(now_ms() - begun);
}

void print(const char* name, std::vector<double>& times) {
  std::sort(times.begin(), times.end());
  std::printf("%-8s median %6.3f ms, worst %6.3f ms\n", name, times[times.size() / 2], times.back());
}

int measure(const std::string& replay, int most, int width, int height, bool debug) {
  game::RunOptions options;
  options.replay = replay;
  game::RecordedRun run(options);
  game::View view_of_lists(run.simulation());
  game::View view(run.simulation());
  Lists lists(width, height);
  engine::HeadlessCanvas canvas(width, height);
  game::ViewOptions shown;
  shown.debug = debug;
  std::vector<double> ticks;
  std::vector<double> making;
  std::vector<double> frames;
  while (!run.is_over() && run.simulation().ticks() < most) {
    take(ticks, [&] { run.tick({}); });
    take(making, [&] { view_of_lists.draw(lists, 1.0, shown); });
    take(frames, [&] { view.draw(canvas, 1.0, shown); });
  }
  std::printf("%zu frames of %d x %d\n", frames.size(), width, height);
  print("tick", ticks);
  print("lists", making);
  print("frame", frames);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"What a frame costs."};
  std::string replay;
  int width = 1280;
  int height = 720;
  bool debug = false;
  int most = 1'000'000;
  app.add_option("replay", replay, "The run to draw")->required();
  app.add_option("--width", width, "px")->check(CLI::Range(1, 16384));
  app.add_option("--height", height, "px")->check(CLI::Range(1, 16384));
  app.add_option("--ticks", most, "Stop after so many")->check(CLI::Range(1, 1'000'000'000));
  app.add_flag("--debug", debug, "With the debug view");
  CLI11_PARSE(app, argc, argv);
  try {
    return measure(replay, most, width, height, debug);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "frame_cost: %s\n", error.what());
    return 1;
  }
}
