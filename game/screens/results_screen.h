#pragma once

#include <optional>
#include <string>
#include <vector>

#include "game/screens/card.h"
#include "game/screens/menu.h"
#include "game/screens/screen.h"
#include "game/screens/session.h"
#include "game/settings/records.h"

namespace game {

class PlayScreen;

/// Over a run that reached the goal.
class ResultsScreen : public Screen {
 public:
  /// Both outlive it. Takes the run into the records.
  ResultsScreen(Session& session, PlayScreen& play);

  Next update(const Frame& frame) override;
  void draw(engine::Canvas& canvas, double text_scale) override;
  bool is_overlay() const override { return true; }
  std::string title() const override { return "results"; }

 private:
  void fill_card(const Best& run, const std::optional<Best>& before, bool is_best);
  void fill_menu();
  Next choose(int item);

  Session* session_;
  PlayScreen* play_;
  Card card_;
  Menu menu_;
  std::string next_{};         // level
  std::vector<int> meanings_;  // of the menu's lines
};

}  // namespace game
