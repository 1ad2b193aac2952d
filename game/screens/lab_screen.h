#pragma once

#include <string>
#include <string_view>

#include "game/lab_view/desk.h"
#include "game/screens/screen.h"
#include "game/screens/session.h"
#include "game/simulation/level.h"

namespace game {

/// The lab: a scene that runs, with its sliders, buttons and plots. The mouse drags what is in it.
class LabScreen : public Screen {
 public:
  /// `scene`: its name; empty: the first one. The session must outlive the screen. Throws std::runtime_error with the
  /// names that are accepted for another one.
  LabScreen(Session& session, std::string_view scene);

  std::string title() const override;
  Next update(const Frame& frame) override;
  void draw(engine::Canvas& canvas, double text_scale) override;
  bool takes_fingers_as_mouse() const override { return true; }

  const lab::Experiment& experiment() const { return desk_.experiment(); }

 private:
  void read_keys(const engine::WindowInput& input);
  engine::TickInput pointer_of(const engine::WindowInput& input, const lab::Layout& layout);

  Session* session_;
  lab::Desk desk_;
  bool drags_ = false;
};

}  // namespace game
