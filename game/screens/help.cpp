#include "game/screens/help.h"

#include "game/settings/two_players.h"

namespace game {
namespace {

constexpr const char* behind_second = "_2}";  // the end of an action's name in braces: of the second player

void replace_all(std::string& words, const std::string& name, const std::string& by) {
  for (std::size_t at = words.find(name); at != std::string::npos; at = words.find(name, at + by.size())) {
    words.replace(at, name.size(), by);
  }
}

}  // namespace

std::vector<std::string> help_lines(const Settings& settings, bool pad) {
  const auto keys = [&](Action action, std::size_t max_codes = 2) {
    return codes_in_words(settings.bindings, action, pad, max_codes);
  };
  const auto both = [&](Action one, Action other) { return keys(one, 1) + " " + keys(other, 1); };
  std::vector<std::string> lines = {both(Action::left, Action::right) + ": run, swing",
                                    keys(Action::jump) + ": jump, let go",
                                    (settings.toggle_grab ? "" : "Hold ") + keys(Action::grab) + ": grab a rope",
                                    both(Action::up, Action::down) + ": climb",
                                    keys(Action::throw_line, 1) + ": throw a line   " + keys(Action::cut, 1) + ": cut",
                                    both(Action::reel_in, Action::reel_out) + ": reel in, out",
                                    keys(Action::restart) + ": restart   " + keys(Action::retry, 1) + ": checkpoint",
                                    keys(Action::pause, 1) + ": pause"};
  if (pad) return lines;
  lines.back() += "   " + keys(Action::step) + ": one tick   " + keys(Action::slow_motion) + ": slow";
  lines.push_back(keys(Action::debug_view) + ": debug view, drag   " + keys(Action::panel) + ": parameters");
  lines.push_back(keys(Action::film) + ": film   " + keys(Action::fullscreen) + ": full screen   " +
                  keys(Action::screenshot) + ": picture");
  lines.push_back(keys(Action::mute) + ": sound   " + keys(Action::help) + ": hide this");
  return lines;
}

std::vector<std::string> help_lines_for_two(const Settings& settings, bool pad) {
  Settings half = settings;
  half.bindings = bindings_of(0, settings);
  std::vector<std::string> lines = help_lines(half, pad);
  if (pad) return lines;  // the second gamepad has the same buttons
  const Bindings second = bindings_of(1, settings);
  const auto key = [&second](Action action) { return codes_in_words(second, action, false, 1); };
  lines.push_back("Second player: " + key(Action::left) + " " + key(Action::right) + ": run   " + key(Action::jump) +
                  ": jump   " + key(Action::grab) + ": grab   " + key(Action::up) + " " + key(Action::down) +
                  ": climb");
  lines.push_back("   " + key(Action::throw_line) + ": throw a line   " + key(Action::reel_in) + ", " +
                  key(Action::reel_out) + ": reel in, out");
  return lines;
}

std::vector<std::string> help_line(const Settings& settings, bool pad) {
  if (pad) return {};
  return {codes_in_words(settings.bindings, Action::help, false, 1) + ": help"};
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
