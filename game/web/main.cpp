#include <emscripten.h>

#include <cstdio>
#include <exception>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "engine/window/sdl_window.h"
#include "game/program/app.h"

// The game in a page: the browser calls each frame. page/page.js starts it.

EM_JS(void, tell_page, (const char* sentence), { Module.gameEnded(UTF8ToString(sentence)); });
EM_JS(void, tell_first_frame, (), { Module.gameShown(); });
EM_JS(void, tell_fingers, (bool as_mouse), { Module.gameFingers(as_mouse); });

namespace {

struct Page {
  std::unique_ptr<game::App> app;
  std::int64_t shown_ns = 0;
  bool was_shown = false;
  bool fingers_as_mouse = false;
};

/// Lives as long as the page, for main() returns before the first frame.
Page& page() {
  static Page one;
  return one;
}

/// Ends the game and shows a sentence in its place; an empty one for an end that the player chose.
void end_game(const std::string& sentence) {
  emscripten_cancel_main_loop();
  page().app.reset();
  tell_page(sentence.c_str());
}

void run_frame() {
  Page& here = page();
  try {
    const std::int64_t now = engine::now_ns();
    const bool goes_on = here.app->frame(now - here.shown_ns);
    here.shown_ns = now;
    if (!here.was_shown) tell_first_frame();
    here.was_shown = true;
    const bool as_mouse = here.app->screens().top().takes_fingers_as_mouse();
    if (std::exchange(here.fingers_as_mouse, as_mouse) != as_mouse) tell_fingers(as_mouse);
    if (goes_on) return;
    here.app->finish();
    end_game("");
  } catch (const std::exception& error) {
    here.app->save_recordings();
    end_game(error.what());
  }
}

/// The page gives at most one pair: level NAME, lab SCENE, or replay FILE.
game::RunOptions options_of(int argc, char** argv) {
  game::RunOptions options;
  if (argc < 3) return options;
  if (std::string_view(argv[1]) == "level") options.level = argv[2];
  if (std::string_view(argv[1]) == "lab") options.lab = argv[2];
  if (std::string_view(argv[1]) == "replay") options.replay = argv[2];
  return options;
}

}  // namespace

/// The page calls it when the browser gives back graphics hardware that it had taken away.
extern "C" EMSCRIPTEN_KEEPALIVE void renew_window() {
  if (!page().app) return;
  try {
    page().app->window().renew();
  } catch (const std::exception& error) {
    page().app->save_recordings();
    end_game(error.what());
  }
}

int main(int argc, char** argv) {
  try {
    page().app = std::make_unique<game::App>(options_of(argc, argv));
    page().shown_ns = engine::now_ns();
    emscripten_set_main_loop(run_frame, 0, 0);
  } catch (const std::exception& error) {
    tell_page(error.what());
  }
  return 0;
}
