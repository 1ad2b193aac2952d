#pragma once

#include "game/screens/menu.h"
#include "game/screens/screen.h"
#include "game/session.h"

namespace game {

class TitleScreen : public Screen {
 public:
  /// The session outlives it.
  explicit TitleScreen(Session& session);

  Next update(const Frame& frame) override;
  void draw(engine::Canvas& canvas, double text_scale) override;

 private:
  Session* session_;
  Menu menu_;
};

/// Leaves everything else.
Next to_title(Session& session);

}  // namespace game
