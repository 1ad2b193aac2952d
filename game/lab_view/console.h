#pragma once

#include <cstdint>
#include <optional>

#include "engine/draw/canvas.h"
#include "game/lab/experiment.h"
#include "game/lab_view/layout.h"

namespace game::lab {

/// The input of the console in a frame.
struct ConsoleInput {
  int down = 0;          ///< lines to go down; negative: up
  int right = 0;         ///< steps to the right; negative: to the left
  bool accept = false;   ///< by a key or a button of a gamepad
  ribbon::Vec2 mouse{};  ///< px
  bool pressed = false;  ///< the left mouse button went down
  bool held = false;     ///< the left mouse button is down
};

enum class Button : std::uint8_t { pause, step, slow, restart, back };
inline constexpr int button_count = static_cast<int>(Button::back) + 1;

/// What the console asks for.
struct ConsoleRequest {
  std::optional<std::size_t> scene;  ///< index in scenes()
  struct Turn {
    Knob knob;
    double value;
  };
  std::optional<Turn> turn;
  std::optional<Button> button;
};

/// What the buttons show.
struct ConsoleState {
  bool paused = false;
  int slowed = 1;  ///< 1, 2, 4 or 10
  bool has_notice = false;
  bool uses_pad = false;
};

/// The columns beside the world: the list of scenes, the sliders of the scene that runs, and the buttons. One of their
/// lines has the focus, for keys and gamepads; mouse and fingers need none.
class Console {
 public:
  /// Begins with another scene of scenes(): its line has the focus, and nothing is held.
  void begin(std::size_t scene);
  /// Reads the input of a frame. Call it with the layout that was drawn last.
  ConsoleRequest update(const ConsoleInput& input, const Experiment& experiment, const Layout& layout);
  /// Returns whether the console uses the mouse: something of it is held, or the pointer is on it.
  bool takes_mouse(ribbon::Vec2 mouse, const Layout& layout) const;
  void draw(engine::Canvas& canvas, const Experiment& experiment, const ConsoleState& state,
            const Layout& layout) const;

  // The rectangles of its lines in px, for tests too.
  static Rectangle scene_place(std::size_t scene, const Layout& layout);
  static Rectangle knob_place(std::size_t knob, const Layout& layout);
  /// Returns the bar of a slider, whose ends are the ends of its range.
  static Rectangle bar_place(std::size_t knob, const Layout& layout);
  static Rectangle button_place(Button button, const Layout& layout);

 private:
  ConsoleRequest use_mouse(const ConsoleInput& input, const Experiment& experiment, const Layout& layout);
  ConsoleRequest use_keys(const ConsoleInput& input, const Experiment& experiment);
  void draw_scenes(engine::Canvas& canvas, const Experiment& experiment, const Layout& layout) const;
  void draw_knob(engine::Canvas& canvas, const Experiment& experiment, std::size_t knob, const Layout& layout) const;
  void draw_button(engine::Canvas& canvas, Button button, const ConsoleState& state, const Experiment& experiment,
                   const Layout& layout) const;

  std::size_t focus_ = 0;              // scenes, then knobs, then buttons
  std::optional<std::size_t> slider_;  // that the mouse holds
};

}  // namespace game::lab
