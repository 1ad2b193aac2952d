#pragma once

#include <optional>
#include <string>
#include <vector>

#include "game/screens/card.h"
#include "game/screens/menu.h"
#include "game/screens/rebinding.h"
#include "game/screens/screen.h"
#include "game/screens/session.h"
#include "game/words/words.h"

namespace game {

/// The screen to change the bindings of the first player and the second one.
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
  Next choose(const MenuChoice& choice);
  std::string codes_of(Action action) const;
  Bindings& bindings() const;
  int rows() const { return static_cast<int>(menu_.items().size()); }

  Session* session_;
  Menu menu_;
  bool is_of_second_ = false;    // the bindings that are shown are the second player's
  std::vector<Action> actions_;  // in the order of the lines
  std::optional<Rebinding> rebinding_;
};

}  // namespace game
