#pragma once

#include <vector>

#include "game/screens/card.h"
#include "game/screens/menu.h"
#include "game/screens/screen.h"
#include "game/screens/session.h"
#include "game/words/words.h"

namespace game {

class PlayScreen;

/// The menu over a paused run.
class PauseScreen : public Screen {
 public:
  /// Both must outlive it.
  PauseScreen(Session& session, PlayScreen& play);

  Next update(const Frame& frame) override;
  void draw(engine::Canvas& canvas, double text_scale) override;
  bool is_overlay() const override { return true; }
  std::string title() const override { return words::screen_paused; }
  Tune tune() const override { return Tune::none; }

 private:
  enum class Item : unsigned char { resume, build, restart, options, levels, quit, title };

  Next choose(Item item);

  Session* session_;
  PlayScreen* play_;
  Card card_;
  Menu menu_;
  std::vector<Item> choices_;  // of the lines of the menu
  bool has_built_ = false;     // and goes on with the run
};

}  // namespace game
