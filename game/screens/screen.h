#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/draw/canvas.h"
#include "engine/window/window_input.h"
#include "game/screens/menu_input.h"
#include "game/sound/music.h"
#include "game/view/veil.h"

namespace game {

/// The input of a screen in one frame.
struct Frame {
  const engine::WindowInput& input;
  const MenuInput& menu;         ///< the same input for menus
  const engine::Canvas& canvas;  ///< as it was last drawn
  std::int64_t elapsed_ns;       ///< since the last frame
  double text_scale;             ///< pixels per unit of text sizes and margins
};

/// Returns the pixels per unit of text for a canvas with `pixel_scale` pixels per desktop unit.
double text_scale_of(const engine::Canvas& canvas, double pixel_scale);

class Screen;

/// The next screen after an update.
struct Next {
  enum class What { stay, open, back, replace_all, quit };

  What what;
  std::vector<std::unique_ptr<Screen>> screens;  ///< to open: one; to replace all: bottom first

  static Next stay() { return {What::stay, {}}; }
  static Next open(std::unique_ptr<Screen> screen);
  static Next back();
  static Next replace_all(std::vector<std::unique_ptr<Screen>> screens);
  static Next quit();
};

/// A screen of the game. Screens form a stack: the top one gets the input. Below overlays, the first screen that is not
/// an overlay is drawn, but not updated.
class Screen {
 public:
  Screen() = default;
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;
  virtual ~Screen() = default;

  /// Called when the screen becomes the top one: after it was opened, and after those above it were closed.
  virtual void shown() {}
  /// The title of the window.
  virtual std::string title() const = 0;
  /// The music of the screen.
  virtual Tune tune() const { return Tune::menu; }
  virtual Next update(const Frame& frame) = 0;
  virtual void draw(engine::Canvas& canvas, double text_scale) = 0;
  /// Draws the screen below an overlay.
  virtual void draw_below(engine::Canvas& canvas, double text_scale) { draw(canvas, text_scale); }
  /// True if the screen below must be drawn first.
  virtual bool is_overlay() const { return false; }
  /// True if it shows the notice of the session itself. Otherwise it leaves the strip at the top free for it.
  virtual bool shows_notice() const { return false; }
  /// True if a finger on a touch screen is a mouse everywhere; else parts of the screen are a stick and buttons.
  virtual bool takes_fingers_as_mouse() const { return false; }
  /// Called before the screen or the window is closed, to complete files.
  virtual void leave() {}
};

/// The stack of open screens.
class ScreenStack {
 public:
  void open(std::unique_ptr<Screen> screen);
  /// Updates the top screen and opens or closes screens. Returns false to quit: on request, or when none is left.
  bool update(const Frame& frame);
  void draw(engine::Canvas& canvas, double text_scale);
  /// Calls leave() of all screens, the top one first.
  void leave();
  const Screen& top() const { return *screens_.back(); }

 private:
  void close_top();

  ScreenFade fade_;  // from dark after another screen that is not an overlay was opened
  std::vector<std::unique_ptr<Screen>> screens_;
};

}  // namespace game
