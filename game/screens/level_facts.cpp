#include "game/screens/level_facts.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <exception>
#include <limits>

#include "game/view/hud.h"
#include "game/words/words.h"

namespace game {

std::string level_title(const Level& level) {
  if (level.title != level.name) return level.title;
  std::string title = level.name;
  std::replace(title.begin(), title.end(), '_', ' ');
  if (!title.empty()) title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
  return title;
}

std::vector<Level> levels_in_order() {
  std::vector<Level> levels;
  for (const std::string& name : level_names()) {
    try {
      levels.push_back(load_level(name));
    } catch (const std::exception& error) {
      std::fprintf(stderr, "ropeswing: %s\n", error.what());
    }
  }
  const auto place = [](const Level& level) {
    return level.number == 0 ? std::numeric_limits<int>::max() : level.number;
  };
  std::stable_sort(levels.begin(), levels.end(), [&](const Level& a, const Level& b) { return place(a) < place(b); });
  return levels;
}

std::string medal_title(Medal medal) {
  switch (medal) {
    case Medal::gold: return words::gold;
    case Medal::silver: return words::silver;
    case Medal::bronze: return words::bronze;
    case Medal::none:
    default: return "";
  }
}

std::vector<std::string> splits_in_words(const Splits& splits, const Splits& reference) {
  std::vector<std::string> lines;
  int in_line = 0;
  for (std::size_t k = 0; k < splits.size(); ++k) {
    if (!splits[k]) continue;
    std::string line = std::to_string(k + 1) + ": " + seconds_in_words(*splits[k]);
    if (k < reference.size() && reference[k]) line += " (" + difference_in_words(*splits[k], *reference[k]) + ")";
    if (in_line == 0) {
      lines.push_back(words::filled(words::checkpoint_splits, {{"splits", line}}));
    } else {
      lines.back() += "   " + line;
    }
    in_line = (in_line + 1) % 2;
  }
  return lines;
}

LevelKey level_key(const Level& level) { return {level.name, level.map.content_hash}; }

Medal medal_of(const Level& level, const Best& run) {
  return run.assisted ? Medal::none : medal_for(run.ticks, level.medals);
}

std::string best_in_words(const Level& level, const std::optional<Best>& best) {
  if (!best) return "";
  const std::string medal = medal_title(medal_of(level, *best));
  const std::string time = seconds_in_words(best->ticks);
  if (best->assisted) return words::filled(words::best_with_assists, {{"time", time}});
  return medal.empty() ? time : words::filled(words::best_with_medal, {{"time", time}, {"medal", medal}});
}

}  // namespace game
