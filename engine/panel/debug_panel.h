#pragma once

#include <memory>
#include <string>

#include "engine/draw/canvas.h"
#include "engine/window/window_input.h"

namespace engine {

/// Dear ImGui on a canvas: what its functions are asked for between begin and end, draw paints, in a window and without
/// one alike. It writes no file of its own.
class DebugPanel {
 public:
  /// `font`: a TrueType file; where there is none ImGui's own is taken. Sizes are those of a desktop unit; see begin.
  explicit DebugPanel(const std::string& font);
  DebugPanel(const DebugPanel&) = delete;
  DebugPanel& operator=(const DebugPanel&) = delete;
  ~DebugPanel();

  /// Begins a frame `seconds` after the one before, on a canvas of that size in pixels, `scale` pixels a desktop unit.
  /// From here to end ImGui's functions may be called.
  void begin(const WindowInput& input, int width, int height, double scale, double seconds);
  void end();

  /// Paints the frame that was ended last. Nothing before the first.
  void draw(Canvas& canvas) const;

  /// Whether the panel uses the mouse, or the keyboard: then they are not meant for the game.
  bool wants_mouse() const;
  bool wants_keyboard() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The input without what the panel uses.
WindowInput left_by(const DebugPanel& panel, const WindowInput& input);

}  // namespace engine
