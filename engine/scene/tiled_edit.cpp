#include "engine/scene/tiled_edit.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "engine/files/json_text.h"

namespace engine {
namespace {

using nlohmann::json;

json parsed(std::string_view text, const std::optional<JsonSpan>& span) {
  return span ? json::parse(span->of(text), nullptr, false) : json();
}

std::optional<JsonSpan> find_object(std::string_view text, JsonSpan owner, int id) {
  const auto layers = json_member(text, owner, "layers");
  if (!layers) return std::nullopt;
  for (const JsonSpan& layer : json_elements(text, *layers)) {
    const auto objects = json_member(text, layer, "objects");
    for (const JsonSpan& object : objects ? json_elements(text, *objects) : std::vector<JsonSpan>{}) {
      if (parsed(text, json_member(text, object, "id")) == id) return object;
    }
    if (const auto found = find_object(text, layer, id)) return found;
  }
  return std::nullopt;
}

JsonSpan owner_of(std::string_view text, int object) {
  const JsonSpan map = json_value(text);
  if (object == map_itself) return map;
  const auto found = find_object(text, map, object);
  if (!found) throw MapError("the map has no object " + std::to_string(object) + "; accepted is the id of one it has");
  return *found;
}

std::string json_string(std::string_view plain_text) {
  std::string made(1, '"');
  made += plain_text;
  return made += '"';
}

struct Token {
  std::string type;
  std::string value;
};

Token token_of(const Properties::Value& value) {
  if (const bool* flag = std::get_if<bool>(&value)) return {"bool", *flag ? "true" : "false"};
  if (const std::int64_t* whole = std::get_if<std::int64_t>(&value)) return {"int", std::to_string(*whole)};
  if (const std::string* text = std::get_if<std::string>(&value)) return {"string", json(*text).dump()};
  const double number = std::get<double>(value);
  if (!std::isfinite(number))
    throw MapError("a property cannot be " + number_in_words(number) + "; accepted is a finite number");
  return {"float", number_in_words(number)};
}

std::string replaced(std::string_view text, JsonSpan span, std::string_view by) {
  std::string changed(text.substr(0, span.begin));
  changed += by;
  return changed += text.substr(span.end);
}

/// Returns the white space that begins at `at`.
std::string_view space_at(std::string_view text, std::size_t at) {
  const std::size_t end = text.find_first_not_of(" \t\r\n", at);
  return text.substr(at, (end == std::string_view::npos ? text.size() : end) - at);
}

/// Returns the white space that ends at `end`.
std::string_view space_before(std::string_view text, std::size_t end) {
  const std::size_t last = text.find_last_not_of(" \t\r\n", end - 1);
  return text.substr(last + 1, end - last - 1);
}

/// Returns the JSON of a property with the white space of the property `like`.
std::string entry(std::string_view name, const Token& token, std::string_view text, JsonSpan like) {
  const std::string_view before = space_at(text, like.begin + 1);
  const std::string_view colon = text.substr(text.find(':', like.begin));
  const std::string_view after_colon = space_at(colon, 1);
  std::string made = "{";
  const auto add = [&](std::string_view key, const std::string& value) {
    if (made.size() > 1) made += ',';
    made += before;
    made += '"';
    made += key;
    made += "\":";
    made += after_colon;
    made += value;
  };
  add("name", json(name).dump());
  add("type", json_string(token.type));
  add("value", token.value);
  made += space_before(text, like.end - 1);
  return made += '}';
}

constexpr std::string_view plain = R"({"a": 0})";

std::string list_of(const std::string& only) {
  std::string list(1, '[');
  list += only;
  return list += ']';
}

std::string added(std::string_view text, JsonSpan owner, std::string_view name, const Token& token) {
  const auto properties = json_member(text, owner, "properties");
  const std::string list = list_of(entry(name, token, plain, {0, plain.size()}));
  if (!properties) {
    const std::string_view space = space_at(text, owner.begin + 1);
    std::string member(space);
    member += "\"properties\": ";
    member += list;
    if (text[owner.begin + 1 + space.size()] != '}') member += ',';
    return replaced(text, {owner.begin + 1, owner.begin + 1}, member);
  }
  const auto known = json_elements(text, *properties);
  if (known.empty()) return replaced(text, *properties, list);
  std::string next(1, ',');
  next += space_before(text, known.back().begin);
  next += entry(name, token, text, known.back());
  return replaced(text, {known.back().end, known.back().end}, next);
}

/// Returns the index of the property with that name; nothing if there is none.
std::optional<std::size_t> index_of(std::string_view text, const std::vector<JsonSpan>& known, std::string_view name) {
  for (std::size_t k = 0; k < known.size(); ++k) {
    if (parsed(text, json_member(text, known[k], "name")) == name) return k;
  }
  return std::nullopt;
}

std::vector<JsonSpan> properties_of(std::string_view text, JsonSpan owner) {
  const auto properties = json_member(text, owner, "properties");
  return properties ? json_elements(text, *properties) : std::vector<JsonSpan>{};
}

}  // namespace

std::string with_property(std::string_view text, int object, std::string_view name, const Properties::Value& value) {
  const JsonSpan owner = owner_of(text, object);
  const Token token = token_of(value);
  const auto known = properties_of(text, owner);
  const auto index = index_of(text, known, name);
  if (!index) return added(text, owner, name, token);
  const auto type = json_member(text, known[*index], "type");
  const auto old = json_member(text, known[*index], "value");
  if (!type || !old) return replaced(text, known[*index], entry(name, token, text, known[*index]));
  const bool stays_float = token.type == "int" && type->of(text) == "\"float\"";
  const std::string new_type = stays_float ? json_string("float") : json_string(token.type);
  // The later span is replaced first, so that the earlier one stays valid.
  const bool type_first = type->begin < old->begin;
  const std::string once = type_first ? replaced(text, *old, token.value) : replaced(text, *type, new_type);
  return type_first ? replaced(once, *type, new_type) : replaced(once, *old, token.value);
}

std::string without_property(std::string_view text, int object, std::string_view name) {
  const auto known = properties_of(text, owner_of(text, object));
  const auto index = index_of(text, known, name);
  if (!index) return std::string(text);
  const std::size_t k = *index;
  if (k + 1 < known.size()) return replaced(text, {known[k].begin, known[k + 1].begin}, "");
  const std::size_t begin = k > 0 ? known[k - 1].end : known[k].begin;
  return replaced(text, {begin, known[k].end}, "");
}

void replace_file(const std::string& path, std::string_view text) {
  const std::string temporary = path + ".new";
  std::error_code failed;
  {
    std::ofstream out(temporary, std::ios::binary);
    out << text << std::flush;
    if (!out) failed = std::make_error_code(std::errc::io_error);
  }
  if (!failed) std::filesystem::rename(temporary, path, failed);
  if (!failed) return;
  std::error_code ignored;
  std::filesystem::remove(temporary, ignored);
  throw std::runtime_error("cannot write " + path + "; the file is as it was");
}

}  // namespace engine
