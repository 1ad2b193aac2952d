#include "engine/window/sdl_display.h"

#include <SDL.h>
#include <SDL_syswm.h>

namespace engine {

#if defined(SDL_VIDEO_DRIVER_X11)

namespace {

int ignore_error(Display*) { return 0; }
void set_lost(Display*, void* context) {
  auto& loss = *static_cast<DisplayLoss*>(context);
  loss.lost = true;
  if (loss.escape != nullptr) std::longjmp(*loss.escape, 1);
}

/// Returns a function of the Xlib that SDL has loaded; null if that version does not have it.
template <typename Function>
Function* function_of(void* xlib, const char* name) {
  return reinterpret_cast<Function*>(SDL_LoadFunction(xlib, name));
}

}  // namespace

void watch_for_display_loss(SDL_Window* window, DisplayLoss& loss) {
  SDL_SysWMinfo info;
  SDL_VERSION(&info.version);
  if (SDL_GetWindowWMInfo(window, &info) == SDL_FALSE || info.subsystem != SDL_SYSWM_X11) return;
  void* const xlib = SDL_LoadObject("libX11.so.6");
  if (xlib == nullptr) return;
  // The default first handler prints and ends the program. The second, of Xlib 1.7 (2020) and later, runs instead of
  // exit() after it. The first alone would not help.
  const auto on_error = function_of<decltype(XSetIOErrorHandler)>(xlib, "XSetIOErrorHandler");
  const auto on_exit = function_of<decltype(XSetIOErrorExitHandler)>(xlib, "XSetIOErrorExitHandler");
  if (on_error != nullptr && on_exit != nullptr) {
    on_error(ignore_error);
    on_exit(info.info.x11.display, set_lost, &loss);
  }
  SDL_UnloadObject(xlib);
}

#else

void watch_for_display_loss(SDL_Window*, DisplayLoss&) {}

#endif

}  // namespace engine
