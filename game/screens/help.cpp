#include "game/screens/help.h"

namespace game {

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
