#include <algorithm>
#include <cstdio>
#include <ctime>
#include <limits>
#include <optional>
#include <stdexcept>

#include "engine/draw/video_writer.h"
#include "engine/window/sdl_canvas.h"
#include "game/program/bad_ticks.h"
#include "game/program/picture_size.h"
#include "game/screens/help.h"
#include "game/simulation/recorded_run.h"
#include "game/simulation/run.h"
#include "game/view/hud.h"
#include "game/view/view.h"
#include "game/words/words.h"

namespace game {
namespace {

void save_picture(const Simulation& simulation, const RunOptions& options) {
  engine::HeadlessCanvas canvas(picture_width, picture_height);
  ViewOptions view_options;
  view_options.signs = signs_in_words(simulation.level(), Settings{}, false);
  if (const auto goal = simulation.goal_ticks()) {
    view_options.headline = words::made_it;
    view_options.below = words::filled(words::made_it_in, {{"time", seconds_in_words(*goal)}});
  }
  View(simulation).draw(canvas, 1.0, view_options);
  canvas.save_png(options.screenshot);
  std::printf("picture of the last moment: %s\n", options.screenshot.c_str());
}

/// A video with a frame for every second tick.
class HeadlessFilm {
 public:
  HeadlessFilm(const Simulation& simulation, const RunOptions& options)
      : canvas_(options.video_width, options.video_height),
        view_(simulation),
        writer_(options.video, options.video_width, options.video_height) {
    view_options_.text_scale = options.video_height / (1.0 * picture_height);
    view_options_.signs = signs_in_words(simulation.level(), Settings{}, false);
  }

  void take(const Simulation& simulation) {
    if (simulation.ticks() % (ticks_per_second / engine::VideoWriter::frames_per_second) != 0) return;
    view_.draw(canvas_, 1.0, view_options_);
    writer_.write(canvas_.raster().pixels());
    ++frames_;
  }
  void finish(const std::string& path) {
    writer_.finish();
    std::printf("video of %d frames: %s\n", frames_, path.c_str());
  }

 private:
  engine::HeadlessCanvas canvas_;
  View view_;
  ViewOptions view_options_;
  engine::VideoWriter writer_;
  int frames_ = 0;
};

/// Goes to a tick and prints the speed in processor time, which does not depend on other programs.
void seek(RecordedRun& run, int tick) {
  const std::clock_t start = std::clock();
  run.seek(tick);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  const double played = static_cast<double>(tick) / ticks_per_second;
  std::printf("tick %d reached in %.1f ms, %.0f times real time\n", tick, 1e3 * seconds,
              played / std::max(seconds, 1e-6));
}

void print_result(const Simulation& simulation) {
  const auto goal = simulation.goal_ticks();
  if (goal) {
    std::printf("reached the goal after %d ticks (%s)\n", *goal, seconds_in_words(*goal).c_str());
  } else {
    std::printf("ran %d ticks (%s), the goal was not reached\n", simulation.ticks(),
                seconds_in_words(simulation.ticks()).c_str());
  }
}

}  // namespace

int run_headless(const RunOptions& options) {
  const auto bad_ticks = bad_tick_recorder(options);
  RecordedRun run(options);
  run.watch(bad_ticks.get());
  if (!run.has_replay() && !options.ticks) {
    throw std::runtime_error("--headless needs to know how far to run; accepted is --replay FILE or --ticks N");
  }
  if (options.seek > 0) seek(run, options.seek);
  std::optional<HeadlessFilm> film;
  if (!options.video.empty()) film.emplace(run.simulation(), options);
  run.start_recording();
  const int max_ticks = options.ticks.value_or(run.has_replay() ? std::numeric_limits<int>::max() : 0);
  while (!run.is_over() && run.simulation().ticks() < max_ticks) {
    run.tick({});
    if (film) film->take(run.simulation());
  }
  run.finish();
  print_result(run.simulation());
  if (bad_ticks) std::puts(bad_ticks_line(*bad_ticks, options).c_str());
  if (film) film->finish(options.video);
  if (!options.screenshot.empty()) save_picture(run.simulation(), options);
  std::puts(run.closing_line().c_str());
  return run.exit_status();
}

}  // namespace game
