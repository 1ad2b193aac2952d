#pragma once

#include <string>
#include <vector>

#include "tests/support/scripted_player.h"

namespace test_support {

/// Returns the script that wins one of the first levels, which teach the keys, or the one of the balloons; empty for
/// any other name.
std::vector<Move> winning_script_of_lesson(const std::string& level);

}  // namespace test_support
