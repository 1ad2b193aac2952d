// Level files: any text loads as a level, or is refused with a message that names the file.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "game/simulation/level.h"
#include "tests/fuzz/require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string file = "fuzz.tmj";
  try {
    const game::Level level =
        game::level_of(engine::parse_tiled_map(std::string_view(reinterpret_cast<const char*>(data), size), file));
    fuzz::require(is_finite(level.player_start) && (!level.goal || is_finite(level.goal->center)),
                  "positions of player and goal are finite");
    fuzz::require(level.player_mass > 0.0 && (!level.goal || level.goal->size.x > 0.0),
                  "the mass of the player and the size of the goal are positive");
  } catch (const engine::MapError& error) {
    fuzz::require_message(error.what(), file);
  }
  return 0;
}
