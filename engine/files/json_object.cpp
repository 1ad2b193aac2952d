#include "engine/files/json_object.h"

#include <algorithm>
#include <limits>

namespace engine {

using nlohmann::json;

namespace {

/// The nesting depth of the brackets of a JSON text; unspecified for other texts.
int depth_of(std::string_view text) {
  int depth = 0;
  int max_depth = 0;
  bool quoted = false;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    if (c == '"') quoted = !quoted;
    if (quoted && c == '\\') ++k;  // an escaped quote does not end the string
    if (quoted) continue;
    if (c == '[' || c == '{') max_depth = std::max(max_depth, ++depth);
    if (c == ']' || c == '}') --depth;
  }
  return max_depth;
}

}  // namespace

json parse_json(std::string_view text, const std::string& where, int max_depth) {
  // The parser's callback could check this too, but makes parsing quadratic: it visits all values so far at the end of
  // each object or array.
  if (depth_of(text) > max_depth) {
    throw JsonError(where + ": nested more than the " + std::to_string(max_depth) + " levels deep accepted");
  }
  try {
    return json::parse(text);
  } catch (const json::exception& error) {
    // Drops the library's prefix "[json.exception.…] " and limits the length: the rest may quote the whole file.
    const std::string what = error.what();
    const std::size_t prefix_end = what.find("] ");
    const std::string sentence = what.substr(prefix_end == std::string::npos ? 0 : prefix_end + 2, 200);
    throw JsonError(where + ": not valid JSON: " + sentence);
  }
}

std::string json_in_words(const json& value) {
  if (value.is_object()) return "an object";
  if (value.is_array()) return "an array";
  if (value.is_string()) return in_quotes(value.get_ref<const std::string&>());
  return value.dump();
}

JsonObject::JsonObject(const json& value, std::string where) : value_(&value), where_(std::move(where)) {
  if (!value.is_object()) fail("found is " + json_in_words(value) + ", accepted is an object");
}

double JsonObject::number(std::string_view key, NumberRange accepted) const {
  const json& value = require(key, range_in_words(accepted));
  if (!value.is_number() || !accepted.contains(value.get<double>())) refuse(key, range_in_words(accepted));
  return value.get<double>();
}

double JsonObject::number_or(std::string_view key, double fallback, NumberRange accepted) const {
  return has(key) ? number(key, accepted) : fallback;
}

std::int64_t JsonObject::integer(std::string_view key, IntegerRange accepted) const {
  const json& value = require(key, range_in_words(accepted));
  const bool fits = value.is_number_unsigned()
                        ? value.get<std::uint64_t>() <= std::uint64_t{std::numeric_limits<std::int64_t>::max()}
                        : value.is_number_integer();
  if (!fits || !accepted.contains(value.get<std::int64_t>())) refuse(key, range_in_words(accepted));
  return value.get<std::int64_t>();
}

bool JsonObject::boolean_or(std::string_view key, bool fallback) const {
  if (!has(key)) return fallback;
  if (!value_->at(key).is_boolean()) refuse(key, "true or false");
  return value_->at(key).get<bool>();
}

std::string JsonObject::text(std::string_view key) const {
  const json& value = require(key, "a text");
  if (!value.is_string()) refuse(key, "a text");
  return value.get<std::string>();
}

std::string JsonObject::text_or(std::string_view key, std::string_view fallback) const {
  return has(key) ? text(key) : std::string(fallback);
}

const json& JsonObject::array(std::string_view key) const {
  const json& value = require(key, "an array");
  if (!value.is_array()) refuse(key, "an array");
  return value;
}

JsonObject JsonObject::object(std::string_view key) const {
  const json& value = require(key, "an object");
  if (!value.is_object()) refuse(key, "an object");
  return {value, where_ + ": " + std::string(key)};
}

void JsonObject::refuse(std::string_view key, const std::string& accepted) const {
  fail(in_quotes(key) + " is " + json_in_words(value_->at(key)) + ", accepted is " + accepted);
}

const json& JsonObject::require(std::string_view key, const std::string& accepted) const {
  const auto found = value_->find(key);
  if (found == value_->end()) fail(in_quotes(key) + " is missing, accepted is " + accepted);
  return *found;
}

}  // namespace engine
