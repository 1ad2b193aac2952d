#include "game/screens/help.h"

#include <algorithm>
#include <variant>

#include "game/words/words.h"

namespace game {
namespace {

constexpr std::size_t max_codes = 2;  // of an action

}  // namespace

std::vector<std::string> help_lines(const Settings& settings, bool pad) {
  std::vector<std::string> lines;
  for (const Action action : all_actions()) {
    std::string keys = codes_in_words(settings.bindings, action, pad, max_codes);
    const bool bound = std::any_of(
        settings.bindings.codes(action).begin(), settings.bindings.codes(action).end(),
        [pad](const engine::InputCode& code) { return std::holds_alternative<engine::PadButton>(code) == pad; });
    if (!bound) continue;
    if (action == Action::grab && !settings.toggle_grab) keys = words::filled(words::help_hold, {{"keys", keys}});
    lines.push_back(words::filled(words::help_entry, {{"keys", keys}, {"action", action_title(action)}}));
  }
  return lines;
}

std::vector<std::string> help_line(const Settings& settings, bool pad) {
  if (pad) return {};
  return {words::filled(words::help_key, {{"key", codes_in_words(settings.bindings, Action::help, false, 1)}})};
}

std::string name_in_braces(Action action) {
  std::string name = "{";
  name += action_name(action);
  name += "}";
  return name;
}

std::string hint_in_words(const std::string& hint, const Settings& settings, bool pad) {
  std::string words = hint;
  for (const Action action : all_actions()) {
    const std::string name = name_in_braces(action);
    const std::string key = codes_in_words(settings.bindings, action, pad, 1);
    for (std::size_t at = words.find(name); at != std::string::npos; at = words.find(name, at + key.size())) {
      words.replace(at, name.size(), key);
    }
  }
  return words;
}

std::vector<std::string> signs_in_words(const Level& level, const Settings& settings, bool pad) {
  std::vector<std::string> texts;
  for (const Sign& sign : level.signs) texts.push_back(hint_in_words(sign.text, settings, pad));
  return texts;
}

}  // namespace game
