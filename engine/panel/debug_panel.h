#pragma once

#include <memory>
#include <string>

#include "engine/draw/canvas.h"
#include "engine/window/window_input.h"

namespace engine {

/// Dear ImGui on a canvas, with or without a window. draw() paints what ImGui's functions added between begin() and
/// end(). It writes no files.
class DebugPanel {
 public:
  /// `font`: path of a TrueType file; if it does not exist, ImGui's built-in font is used.
  explicit DebugPanel(const std::string& font);
  DebugPanel(const DebugPanel&) = delete;
  DebugPanel& operator=(const DebugPanel&) = delete;
  ~DebugPanel();

  /// Begins a frame `seconds` after the last one, on a canvas of width × height pixels with `scale` pixels per desktop
  /// unit. ImGui's functions may be called until end().
  void begin(const WindowInput& input, int width, int height, double scale, double seconds);
  void end();

  /// Paints the last frame that was ended; nothing before the first.
  void draw(Canvas& canvas) const;

  /// True while the panel uses the mouse or the keyboard: the game should then ignore them.
  bool wants_mouse() const;
  bool wants_keyboard() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Returns the input without what the panel uses.
WindowInput without_captured(const DebugPanel& panel, const WindowInput& input);

}  // namespace engine
