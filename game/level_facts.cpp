#include "game/level_facts.h"

#include <algorithm>
#include <cctype>

#include "game/hud.h"

namespace game {

std::string level_title(const Level& level) {
  std::string title = level.name;
  std::replace(title.begin(), title.end(), '_', ' ');
  if (!title.empty()) title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
  return title;
}

std::optional<Medals> level_medals(const Level& level) {
  return level.medals.bronze > 0.0 ? std::optional(level.medals) : std::nullopt;
}

LevelKey level_key(const Level& level) { return {level.name, level.map.content_hash}; }

Medal medal_of(const Level& level, const Best& run) {
  const auto medals = level_medals(level);
  return medals && !run.assisted ? medal_for(run.ticks, *medals) : Medal::none;
}

std::string best_in_words(const Level& level, const std::optional<Best>& best) {
  if (!best) return "";
  const std::string medal = medal_title(medal_of(level, *best));
  return seconds_in_words(best->ticks) + (best->assisted ? " with help" : medal.empty() ? "" : ", " + medal);
}

}  // namespace game
