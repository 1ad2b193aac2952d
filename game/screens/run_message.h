#pragma once

#include <string>

#include "game/screens/hint.h"
#include "game/screens/pace.h"
#include "game/screens/played_run.h"
#include "game/screens/session.h"

namespace game {

/// The message in the middle of a run; empty: none.
struct RunMessage {
  std::string headline;
  std::string below;
};

/// Chooses the message of a run. `won`: its results were shown.
RunMessage message_of(const PlayedRun& played, const Session& session, const Pace& pace, const Hint& hint, bool won);

}  // namespace game
