// Level files: any text loads as a level, or is refused with a message that names the file.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "game/simulation/level.h"
#include "tests/fuzz/demand.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string file = "fuzz.tmj";
  try {
    const game::Level level =
        game::level_of(engine::parse_tiled_map(std::string_view(reinterpret_cast<const char*>(data), size), file));
    fuzz::demand(is_finite(level.player_start) && is_finite(level.goal.center), "player and goal are somewhere");
    fuzz::demand(level.player_mass > 0.0 && level.goal.size.x > 0.0, "the player weighs something");
  } catch (const engine::MapError& error) {
    fuzz::demand_sentence(error.what(), file);
  }
  return 0;
}
