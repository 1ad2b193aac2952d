#pragma once

#include <csetjmp>

struct SDL_Window;

namespace engine {

/// Whether the connection to the display was lost, and where to continue after that.
struct DisplayLoss {
  bool lost = false;
  std::jmp_buf* escape = nullptr;  ///< set during calls of the display; the caller must own nothing with a destructor
};

/// Installs handlers for the loss of the X server (stopped, crashed, lost connection), which by default ends the
/// program: they set `loss.lost` and jump to `loss.escape`. The jump is needed because drivers continue with answers
/// that they did not receive (Mesa's writes to invalid memory). After a loss no function of that display may be called,
/// not even to close the window. `loss` must live as long as the display is open. Does nothing without X11; Wayland
/// sends SDL_QUIT.
void watch_for_display_loss(SDL_Window* window, DisplayLoss& loss);

}  // namespace engine
