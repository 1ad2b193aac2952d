#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "engine/window/sdl_canvas.h"
#include "engine/window/window_input.h"

namespace engine {

/// A size in desktop units.
struct WindowSize {
  int width = 0;
  int height = 0;

  bool operator==(const WindowSize&) const = default;
};

/// Returns the largest size up to `wanted` with which a window and its `borders` fit on a display whose usable part is
/// `usable`, at least 1 × 1. A side of `usable` that is 0 is unknown.
WindowSize fitting_size(WindowSize wanted, WindowSize usable, WindowSize borders = {});

/// A resizable window with a canvas. In each frame: poll, draw on canvas(), present.
class Window {
 public:
  /// `width` and `height`: 1 … 16384 desktop units, which are pixels unless the desktop scales its windows. Throws
  /// std::runtime_error, with advice, if there is no display, and std::invalid_argument for other sizes. The window is
  /// smaller if it does not fit on the display.
  Window(const std::string& title, int width, int height);
  ~Window();

  /// The canvas, in pixels of the display. It keeps its content until it is cleared.
  Canvas& canvas();
  const Canvas& canvas() const;
  const Raster& raster() const;
  /// Pixels per desktop unit, 1 or more: multiply text sizes by it to keep them readable.
  double pixel_scale() const;

  /// Returns the input since the last poll. If the window was resized, the canvas now has the new size and is black:
  /// draw again before present. Throws std::runtime_error if the display was lost.
  WindowInput poll();
  /// Shows the canvas and waits, so that a loop of frames runs at the rate of the display, or at 60 Hz if that is
  /// unknown. Throws std::runtime_error if the display was lost.
  void present();

  /// Makes anew what shows the canvas, which is black then: draw again before present. Call it when the graphics
  /// hardware has lost what it stored; a browser tells. Throws std::runtime_error if it cannot be made.
  void renew();

  void set_title(const std::string& title);
  /// Switches between full screen and window. No effect if the desktop does not support it.
  void set_fullscreen(bool fullscreen);

  /// Writes the canvas to a PNG file. Throws std::runtime_error with path and reason if it cannot be written.
  void save_png(const std::string& path) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// A monotonic clock: nanoseconds since an unspecified moment.
std::int64_t now_ns();

}  // namespace engine
