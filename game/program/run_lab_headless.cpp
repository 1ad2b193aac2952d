#include <cstdio>
#include <stdexcept>
#include <string>

#include "engine/tick/workers.h"
#include "engine/window/sdl_canvas.h"
#include "engine/window/sdl_window.h"
#include "game/lab/figures.h"
#include "game/lab_view/desk.h"
#include "game/program/picture_size.h"
#include "game/screens/screen.h"
#include "game/simulation/run.h"
#include "ribbon/box2d/state_hash.h"

namespace game {
namespace {

const char* name_of(const lab::Bench& bench) { return bench.method() == lab::Method::chains ? "chains" : "cords"; }

}  // namespace

int run_lab_headless(const RunOptions& options) {
  if (!options.ticks) {
    throw std::runtime_error("--headless --lab needs to know how far to run; accepted is --ticks N");
  }
  engine::Workers workers;
  lab::Desk desk(options.lab->empty() ? lab::scenes().front() : lab::scene_named(*options.lab), engine::now_ns,
                 workers.parallel_for());
  for (int k = 0; k < *options.ticks; ++k) desk.tick();
  for (const auto& bench : desk.experiment().benches()) {
    std::printf("%s: stretched by %.6g %%, energy %.6g J\n", name_of(*bench), 100.0 * lab::greatest_stretch(*bench),
                lab::energy(*bench));
  }
  if (!options.screenshot.empty()) {
    engine::HeadlessCanvas canvas(picture_width, picture_height);
    desk.draw(canvas, text_scale_of(canvas, 1.0));
    canvas.save_png(options.screenshot);
    std::printf("picture of the last moment: %s\n", options.screenshot.c_str());
  }
  std::printf("ran %d ticks, hash %s\n", desk.experiment().ticks(),
              ribbon::box2d::to_hex(desk.experiment().hash()).c_str());
  return 0;
}

}  // namespace game
