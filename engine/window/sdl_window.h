#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "engine/window/sdl_canvas.h"
#include "engine/window/window_input.h"

namespace engine {

/// A resizable window with a canvas. A frame is: poll, draw on canvas(), present.
class Window {
 public:
  /// Width and height are in the desktop's units, which are pixels unless it scales its windows. Throws
  /// std::runtime_error if there is no display to open a window on, saying what to do then, and
  /// std::invalid_argument unless both are 1 … 16384.
  Window(const std::string& title, int width, int height);
  ~Window();

  /// The picture to draw on, in the display's own pixels. It keeps what was drawn until it is cleared.
  Canvas& canvas();
  const Canvas& canvas() const;
  const Raster& raster() const;
  /// How many pixels a desktop unit has, 1 or more: multiply text sizes by it to keep them readable.
  double pixel_scale() const;

  /// Everything that happened since the last poll. If the window was resized, the canvas now has the new size and is
  /// black: draw again before present. Throws std::runtime_error if the display has gone, as present does.
  WindowInput poll();
  /// Shows the canvas, and waits so that a loop of frames runs at the display's rate, or at 60 a second if it is
  /// unknown.
  void present();

  void set_title(const std::string& title);
  /// Fills the whole screen, or is a window again. Where the desktop does not have it, nothing happens.
  void set_fullscreen(bool fullscreen);

  /// Writes the canvas as it is now. Throws std::runtime_error naming the path and the reason if it cannot be written.
  void save_png(const std::string& path) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// A clock for pacing a loop: nanoseconds since some fixed moment; it never goes back.
std::int64_t now_ns();

}  // namespace engine
