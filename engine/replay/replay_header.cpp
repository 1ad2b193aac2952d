#include "engine/replay/replay_header.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <variant>

#include "engine/files/json_object.h"
#include "engine/files/ranges.h"
#include "engine/replay/replay_format.h"
#include "ribbon/box2d/state_hash.h"

namespace engine {
namespace {

using namespace replay_format;
using nlohmann::json;

json settings_json(const std::map<std::string, Setting>& settings) {
  json object = json::object();
  for (const auto& [key, value] : settings) {
    if (const double* number = std::get_if<double>(&value)) {
      // JSON has no such numbers; the library would write null.
      if (!std::isfinite(*number)) throw ReplayError("setting " + in_quotes(key) + " is not a finite number");
      object[key] = *number;
    } else {
      object[key] = std::get<std::string>(value);
    }
  }
  return object;
}

std::map<std::string, Setting> parse_settings(const JsonObject& object) {
  std::map<std::string, Setting> settings;
  for (const auto& [key, value] : object.value().items()) {
    if (value.is_number()) {
      settings.emplace(key, value.get<double>());
    } else if (value.is_string()) {
      settings.emplace(key, value.get<std::string>());
    } else {
      object.refuse(key, "a number or a text");
    }
  }
  return settings;
}

std::uint64_t parse_hash(const JsonObject& header, const char* key) {
  constexpr std::string_view hexadecimal = "0123456789abcdef";
  const std::string digits = header.text(key);
  if (digits.size() != 16 || digits.find_first_not_of(hexadecimal) != std::string::npos) {
    header.refuse(key, "16 lower-case hexadecimal digits");
  }
  std::uint64_t hash = 0;
  for (const char digit : digits) hash = hash << 4 | hexadecimal.find(digit);
  return hash;
}

ReplayHeader parse(std::string_view line) {
  constexpr int max_depth = 4;
  const json root = parse_json(line, "the header", max_depth);
  const JsonObject header(root, "the header");
  const Choices known = {"level", "level_hash", "tick_rate", "settings", "players"};
  for (const auto& [key, value] : root.items()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    header.fail(in_quotes(key) + " is unknown, accepted are: " + list_in_words(known));
  }
  return {.level = header.text("level"),
          .level_hash = parse_hash(header, "level_hash"),
          .tick_rate = static_cast<int>(header.integer("tick_rate", {1, max_tick_rate})),
          .settings = parse_settings(header.object("settings")),
          .players = header.has("players") ? static_cast<int>(header.integer("players", {1, max_players})) : 1};
}

}  // namespace

std::string replay_header_line(const ReplayHeader& header) {
  if (header.tick_rate < 1 || header.tick_rate > max_tick_rate) {
    throw ReplayError("tick rate is " + std::to_string(header.tick_rate) + ", accepted is 1 to " +
                      std::to_string(max_tick_rate));
  }
  if (header.players < 1 || header.players > max_players) {
    throw ReplayError("the number of players is " + std::to_string(header.players) + ", accepted is 1 to " +
                      std::to_string(max_players));
  }
  json object = {{"level", header.level},
                 {"level_hash", ribbon::box2d::to_hex(header.level_hash)},
                 {"tick_rate", header.tick_rate},
                 {"settings", settings_json(header.settings)}};
  if (header.players != 1) object["players"] = header.players;
  std::string line;
  try {
    line = object.dump() + "\n";
  } catch (const json::type_error&) {
    throw ReplayError("a text in the header is not UTF-8");
  }
  if (line.size() > max_header_bytes) {
    throw ReplayError("the header takes " + std::to_string(line.size()) + " bytes, accepted is up to " +
                      std::to_string(max_header_bytes));
  }
  return line;
}

ReplayHeader parse_replay_header(std::string_view line) {
  try {
    return parse(line);
  } catch (const JsonError& error) {
    throw ReplayError(error.what());
  }
}

}  // namespace engine
