#pragma once

struct SDL_Window;

namespace engine {

/// Without it Xlib ends the whole program when the X server goes away (stopped, crashed, a lost remote connection):
/// this has it return, and sets `lost`, after which nothing may be asked of that display again, not even to close the
/// window. `lost` must live as long as the display is open. Does nothing where the window is not X11's; Wayland sends
/// SDL_QUIT.
void note_loss_of_display(SDL_Window* window, bool& lost);

}  // namespace engine
