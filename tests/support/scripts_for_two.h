#pragma once

#include <string>
#include <vector>

#include "tests/support/scripted_player.h"

namespace test_support {

/// Returns the moves of a player, 0 or 1, that win a level for two together with those of the other; empty for an
/// unknown name.
std::vector<Move> winning_script_for_two(const std::string& level, int player);

}  // namespace test_support
