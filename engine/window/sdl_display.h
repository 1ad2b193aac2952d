#pragma once

#include <csetjmp>

struct SDL_Window;

namespace engine {

/// Whether a display has gone, and where whoever asks it something goes on then.
struct DisplayLoss {
  bool lost = false;
  std::jmp_buf* escape = nullptr;  ///< while somebody asks, who holds nothing that has to be cleared up
};

/// Without it Xlib ends the whole program when the X server goes away (stopped, crashed, a lost remote connection):
/// this sets `loss.lost` and jumps to `loss.escape`, out of drivers that draw on with the answers that they did not get
/// (Mesa's writes anywhere). After that nothing may be asked of that display again, not even to close the window.
/// `loss` must live as long as the display is open. Does nothing where the window is not X11's; Wayland sends SDL_QUIT.
void note_loss_of_display(SDL_Window* window, DisplayLoss& loss);

}  // namespace engine
