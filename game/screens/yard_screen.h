#pragma once

#include <optional>
#include <string>

#include "game/screens/card.h"
#include "game/screens/menu.h"
#include "game/screens/screen.h"
#include "game/screens/session.h"
#include "game/screens/yard_tool.h"
#include "game/words/words.h"

namespace game {

class PlayScreen;

/// The palette of things to place in a sandbox, over its run, which stands still at its start meanwhile. A pointer,
/// which the mouse, the arrows or a stick move, uses the tool that was chosen in the palette.
class YardScreen : public Screen {
 public:
  static constexpr double pointer_speed = 6.0;  ///< m/s, by keys or a stick
  static constexpr double drag_distance = 0.5;  ///< m; a longer way with the button down ends with a second use

  /// Both must outlive it. `play` is of a sandbox.
  YardScreen(Session& session, PlayScreen& play);

  void shown() override;
  Next update(const Frame& frame) override;
  void draw(engine::Canvas& canvas, double text_scale) override;
  void leave() override;
  bool is_overlay() const override { return true; }
  bool takes_fingers_as_mouse() const override { return true; }
  std::string title() const override { return words::screen_yard; }
  Tune tune() const override { return Tune::none; }

  ribbon::Vec2 pointer() const { return pointer_; }  ///< m
  const YardTool& tool() const { return tool_; }

 private:
  enum class Chosen : unsigned char { a_tool, done };

  MenuPlace place_of(const engine::Canvas& canvas, double text_scale) const;
  Chosen choose(int item);
  void move_pointer(const Frame& frame);
  void use_tool();
  void follow_button(const Frame& frame, bool over_palette);
  std::string status() const;
  void draw_world(engine::Canvas& canvas) const;

  Session* session_;
  PlayScreen* play_;
  Card card_;
  Menu menu_;
  YardTool tool_;
  ribbon::Vec2 pointer_{};               // m
  std::optional<ribbon::Vec2> pressed_;  // m, where the mouse button went down
  std::optional<PlacingFault> fault_;    // of the last use
};

}  // namespace game
