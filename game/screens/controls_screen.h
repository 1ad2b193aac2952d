#pragma once

#include <optional>

#include "game/screens/card.h"
#include "game/screens/menu.h"
#include "game/screens/rebinding.h"
#include "game/screens/screen.h"
#include "game/screens/session.h"
#include "game/words/words.h"

namespace game {

/// The screen to change the bindings.
class ControlsScreen : public Screen {
 public:
  /// The session must outlive it.
  explicit ControlsScreen(Session& session);

  Next update(const Frame& frame) override;
  void draw(engine::Canvas& canvas, double text_scale) override;
  bool is_overlay() const override { return true; }
  std::string title() const override { return words::screen_keys; }

 private:
  void fill_menu();
  Card card() const;
  int rows() const { return static_cast<int>(menu_.items().size()); }

  Session* session_;
  Menu menu_;
  std::optional<Rebinding> rebinding_;
};

}  // namespace game
