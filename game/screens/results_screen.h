#pragma once

#include <optional>
#include <string>
#include <vector>

#include "game/screens/card.h"
#include "game/screens/menu.h"
#include "game/screens/screen.h"
#include "game/screens/session.h"
#include "game/settings/records.h"
#include "game/simulation/medals.h"
#include "game/words/words.h"

namespace game {

class PlayScreen;

/// The results over a run that reached the goal.
class ResultsScreen : public Screen {
 public:
  /// Offers the run to the records. Both must outlive it.
  ResultsScreen(Session& session, PlayScreen& play);

  Next update(const Frame& frame) override;
  void draw(engine::Canvas& canvas, double text_scale) override;
  bool is_overlay() const override { return true; }
  std::string title() const override { return words::screen_results; }

 private:
  void fill_card(const Best& run, const std::optional<Best>& before, bool is_best);
  void fill_menu();
  Next watch_recording();
  Next choose(int item);

  Session* session_;
  PlayScreen* play_;
  Card card_;
  Menu menu_;
  Medal medal_ = Medal::none;
  std::string next_{};         // name of the next level
  std::vector<int> meanings_;  // by line of the menu
};

}  // namespace game
