#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/draw/canvas.h"
#include "engine/window/window_input.h"
#include "game/screens/menu_input.h"

namespace game {

/// A frame as a screen sees it.
struct Frame {
  const engine::WindowInput& input;
  const MenuInput& menu;         ///< the same for whoever shows a menu
  const engine::Canvas& canvas;  ///< as it was last drawn
  std::int64_t elapsed_ns;       ///< since the frame before
  double text_scale;             ///< pixels a unit of text sizes and margins
};

class Screen;

/// What a screen asks for.
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

/// One of the pictures that the game consists of. They lie on each other: the top one gets the input; below an
/// overlay the next one that is none is drawn, and stands still.
class Screen {
 public:
  Screen() = default;
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;
  virtual ~Screen() = default;

  /// Comes to lie on top: at first, and again when what was above it has gone.
  virtual void shown() {}
  /// What the window is called meanwhile.
  virtual std::string title() const = 0;
  virtual Next update(const Frame& frame) = 0;
  virtual void draw(engine::Canvas& canvas, double text_scale) = 0;
  /// The same while an overlay lies on it.
  virtual void draw_below(engine::Canvas& canvas, double text_scale) { draw(canvas, text_scale); }
  /// True if what lies below is to be drawn first.
  virtual bool is_overlay() const { return false; }
  /// Before it goes, at the latest when the window closes: completes what it has under way.
  virtual void leave() {}
};

/// The screens that are open.
class ScreenStack {
 public:
  void open(std::unique_ptr<Screen> screen);
  /// Gives the top one a frame and does what it asks for. False if it asked to quit or the last one has gone.
  bool update(const Frame& frame);
  void draw(engine::Canvas& canvas, double text_scale);
  /// All of them leave, top first.
  void leave();
  const Screen& top() const { return *screens_.back(); }

 private:
  void close_top();

  std::vector<std::unique_ptr<Screen>> screens_;
};

}  // namespace game
