#include "game/settings/settings_file.h"

#include <cstdio>
#include <exception>

#include "engine/files/json_object.h"
#include "engine/window/input_names.h"
#include "game/settings/user_files.h"
#include "game/words/words.h"

namespace game {
namespace {

using engine::JsonObject;
using nlohmann::ordered_json;

constexpr int settings_depth = 4;

/// Calls visit(name, value) for each boolean setting.
template <typename AnySettings, typename Visit>
void each_switch(AnySettings& settings, Visit visit) {
  visit("toggle_grab", settings.toggle_grab);
  visit("long_reach", settings.long_reach);
  visit("no_fall", settings.no_fall);
  visit("reduced_motion", settings.reduced_motion);
  visit("colour_safe", settings.colour_safe);
  visit("strain_tint", settings.strain_tint);
  visit("ghost", settings.ghost);
  visit("help", settings.help);
  visit("fullscreen", settings.fullscreen);
  visit("muted", settings.sound.muted);
}

ordered_json bindings_json(const Bindings& bindings) {
  ordered_json json = ordered_json::object();
  for (const Action action : all_actions()) {
    ordered_json& names = json[std::string(action_name(action))] = ordered_json::array();
    for (const engine::InputCode& code : bindings.codes(action)) names.push_back(engine::input_name(code));
  }
  return json;
}

/// Reads the bindings. Actions that are not in the file get their default codes, unless these are bound to others.
Bindings read_bindings(const JsonObject& object, const Bindings& defaults) {
  Bindings bindings;
  for (const Action action : all_actions()) {
    const std::string name(action_name(action));
    if (!object.has(name)) continue;
    for (const auto& entry : object.array(name)) {
      const auto code = entry.is_string() ? engine::input_of_name(entry.get<std::string>()) : std::nullopt;
      if (!code) object.fail(name + " has " + engine::json_in_words(entry) + "; accepted are names as \"key_a\"");
      bindings.bind(action, *code);
    }
  }
  for (const Action action : all_actions()) {
    if (object.has(std::string(action_name(action)))) continue;
    for (const engine::InputCode& code : defaults.codes(action)) {
      if (!bindings.action_of(code)) bindings.bind(action, code);
    }
  }
  return bindings;
}

int integer_or(const JsonObject& object, const char* key, int fallback, engine::IntegerRange accepted) {
  return object.has(key) ? static_cast<int>(object.integer(key, accepted)) : fallback;
}

}  // namespace

std::string settings_text(const Settings& settings) {
  ordered_json json;
  json["speed"] = settings.speed;
  json["volume"] = settings.sound.volume;
  json["music_volume"] = settings.sound.music;
  each_switch(settings, [&json](const char* name, bool on) { json[name] = on; });
  json["bindings"] = bindings_json(settings.bindings);
  json["second_bindings"] = bindings_json(settings.second_bindings);
  return json.dump(2) + "\n";
}

Settings parse_settings(const std::string& text, const std::string& where) {
  const nlohmann::json json = engine::parse_json(text, where, settings_depth);
  const JsonObject object(json, where);
  Settings settings;
  settings.speed = integer_or(object, "speed", settings.speed, {Settings::min_speed, 100});
  settings.sound.volume = integer_or(object, "volume", settings.sound.volume, {0, 100});
  settings.sound.music = integer_or(object, "music_volume", settings.sound.music, {0, 100});
  each_switch(settings, [&object](const char* name, bool& on) { on = object.boolean_or(name, on); });
  if (object.has("bindings")) settings.bindings = read_bindings(object.object("bindings"), Bindings::defaults());
  if (object.has("second_bindings"))
    settings.second_bindings = read_bindings(object.object("second_bindings"), Bindings::second_defaults());
  return settings;
}

Settings SettingsFile::load(std::string& notice) {
  saved_ = {};
  if (path_.empty()) return saved_;
  try {
    if (const auto text = read_user_file(path_)) saved_ = parse_settings(*text, path_);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "ropeswing: %s\n", error.what());
    rename_broken(path_);
    notice = words::settings_unreadable;
  }
  return saved_;
}

void SettingsFile::save(const Settings& settings, std::string& notice) {
  if (path_.empty() || settings == saved_) return;
  saved_ = settings;
  try {
    write_user_file(path_, settings_text(settings));
  } catch (const std::exception& error) {
    if (failed_) return;
    failed_ = true;
    std::fprintf(stderr, "ropeswing: %s\n", error.what());
    notice = words::settings_not_written;
  }
}

}  // namespace game
