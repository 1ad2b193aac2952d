#include "engine/window/sdl_display.h"

#include <SDL.h>
#include <SDL_syswm.h>

namespace engine {

#if defined(SDL_VIDEO_DRIVER_X11)

namespace {

int keep_silent(Display*) { return 0; }
void set_lost(Display*, void* noted) {
  auto& loss = *static_cast<DisplayLoss*>(noted);
  loss.lost = true;
  if (loss.escape != nullptr) std::longjmp(*loss.escape, 1);
}

/// A function of the Xlib that SDL holds open; null if that is too old to have it.
template <typename Function>
Function* function_of(void* xlib, const char* name) {
  return reinterpret_cast<Function*>(SDL_LoadFunction(xlib, name));
}

}  // namespace

void note_loss_of_display(SDL_Window* window, DisplayLoss& loss) {
  SDL_SysWMinfo info;
  SDL_VERSION(&info.version);
  if (SDL_GetWindowWMInfo(window, &info) == SDL_FALSE || info.subsystem != SDL_SYSWM_X11) return;
  void* const xlib = SDL_LoadObject("libX11.so.6");
  if (xlib == nullptr) return;
  // The first handler would print and end the program; the second, of Xlib 1.7 (2020) and later, decides whether the
  // call that failed returns. Without the second the first changes nothing for the better.
  const auto on_error = function_of<decltype(XSetIOErrorHandler)>(xlib, "XSetIOErrorHandler");
  const auto on_exit = function_of<decltype(XSetIOErrorExitHandler)>(xlib, "XSetIOErrorExitHandler");
  if (on_error != nullptr && on_exit != nullptr) {
    on_error(keep_silent);
    on_exit(info.info.x11.display, set_lost, &loss);
  }
  SDL_UnloadObject(xlib);
}

#else

void note_loss_of_display(SDL_Window*, DisplayLoss&) {}

#endif

}  // namespace engine
