#include "game/screens/help.h"

#include <algorithm>
#include <variant>
#include "game/settings/two_players.h"

#include "game/words/words.h"

namespace game {
namespace {

constexpr const char* behind_second = "_2}";  // the end of an action's name in braces: of the second player

void replace_all(std::string& words, const std::string& name, const std::string& by) {
  for (std::size_t at = words.find(name); at != std::string::npos; at = words.find(name, at + by.size())) {
    words.replace(at, name.size(), by);
  }
}
constexpr std::size_t max_codes = 2;  // of an action

/// Returns whether an action has a key or mouse button, or one of a gamepad.
bool has_codes(const Bindings& bindings, Action action, bool of_pad) {
  const auto& codes = bindings.codes(action);
  return std::any_of(codes.begin(), codes.end(), [of_pad](const engine::InputCode& code) {
    return std::holds_alternative<engine::PadButton>(code) == of_pad;
  });
}

}  // namespace

std::vector<std::string> help_lines(const Settings& settings, bool pad) {
  std::vector<std::string> lines;
  for (const Action action : all_actions()) {
    std::string keys = codes_in_words(settings.bindings, action, pad, max_codes);
    if (!has_codes(settings.bindings, action, pad)) continue;
    if (action == Action::grab && !settings.toggle_grab) keys = words::filled(words::help_hold, {{"keys", keys}});
    lines.push_back(words::filled(words::help_entry, {{"keys", keys}, {"action", action_title(action)}}));
  }
  return lines;
}

std::vector<std::string> help_lines_for_two(const Settings& settings, bool pad) {
  Settings half = settings;
  half.bindings = bindings_of(0, settings);
  if (pad) return help_lines(half, pad);  // the second gamepad has the same buttons
  const Bindings second = bindings_of(1, settings);
  std::vector<std::string> lines;
  for (const Action action : all_actions()) {
    if (!has_codes(half.bindings, action, pad)) continue;
    const std::string keys = codes_in_words(half.bindings, action, pad, 1);
    if (!has_codes(second, action, pad)) {
      lines.push_back(words::filled(words::help_entry, {{"keys", keys}, {"action", action_title(action)}}));
      continue;
    }
    lines.push_back(words::filled(
        words::help_of_two,
        {{"first", keys}, {"second", codes_in_words(second, action, pad, 1)}, {"action", action_title(action)}}));
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
  const bool for_two = hint.find(behind_second) != std::string::npos;
  const Bindings first = for_two ? bindings_of(0, settings) : settings.bindings;
  const Bindings second = for_two ? bindings_of(1, settings) : Bindings();
  for (const Action action : all_actions()) {
    const std::string name = name_in_braces(action);
    replace_all(words, name, codes_in_words(first, action, pad, 1));
    replace_all(words, name.substr(0, name.size() - 1) + behind_second, codes_in_words(second, action, pad, 1));
  }
  return words;
}

std::vector<std::string> signs_in_words(const Level& level, const Settings& settings, bool pad) {
  std::vector<std::string> texts;
  for (const Sign& sign : level.signs) texts.push_back(hint_in_words(sign.text, settings, pad));
  return texts;
}

}  // namespace game
