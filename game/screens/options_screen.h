#pragma once

#include "game/screens/menu.h"
#include "game/screens/screen.h"
#include "game/screens/session.h"
#include "game/words/words.h"

namespace game {

class OptionsScreen : public Screen {
 public:
  /// The session must outlive it.
  explicit OptionsScreen(Session& session);

  Next update(const Frame& frame) override;
  void draw(engine::Canvas& canvas, double text_scale) override;
  bool is_overlay() const override { return true; }
  std::string title() const override { return words::screen_options; }

 private:
  void fill_menu();

  Session* session_;
  Menu menu_;
};

}  // namespace game
