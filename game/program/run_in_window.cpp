#include <utility>

#include "engine/window/sdl_window.h"
#include "game/program/app.h"
#include "game/simulation/run.h"

namespace game {

int run_in_window(const RunOptions& options) {
  App app(options);
  try {
    std::int64_t shown_ns = engine::now_ns();
    const auto elapsed = [&shown_ns] {
      const std::int64_t now = engine::now_ns();
      return now - std::exchange(shown_ns, now);
    };
    while (app.frame(elapsed())) {
    }
  } catch (...) {
    app.save_recordings();
    throw;
  }
  return app.finish();
}

}  // namespace game
