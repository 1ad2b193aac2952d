#include "engine/files/json_text.h"

#include <algorithm>

namespace engine {
namespace {

std::size_t skip_space(std::string_view text, std::size_t at) {
  return std::min(text.find_first_not_of(" \t\r\n", at), text.size());
}

/// Returns the position after the string that begins at `at`.
std::size_t end_of_string(std::string_view text, std::size_t at) {
  for (++at; at < text.size() && text[at] != '"'; ++at) {
    if (text[at] == '\\') ++at;
  }
  return std::min(at + 1, text.size());
}

/// Returns the position after the value that begins at `at`.
std::size_t end_of_value(std::string_view text, std::size_t at) {
  if (at < text.size() && text[at] == '"') return end_of_string(text, at);
  int depth = 0;
  while (at < text.size()) {
    const char c = text[at];
    if (c == '"') {
      at = end_of_string(text, at);
      continue;
    }
    if (c == '{' || c == '[') ++depth;
    if (c == '}' || c == ']') --depth;
    if (depth < 0 || (depth == 0 && (c == ',' || c == ' ' || c == '\t' || c == '\r' || c == '\n'))) return at;
    ++at;
    if (depth == 0 && (c == '}' || c == ']')) return at;
  }
  return at;
}

JsonSpan value_at(std::string_view text, std::size_t at) {
  const std::size_t begin = skip_space(text, at);
  return {begin, end_of_value(text, begin)};
}

/// Returns the position of the next item, after a comma if there is one; nothing if `bracket` follows.
std::optional<std::size_t> next_item(std::string_view text, std::size_t at, char bracket) {
  at = skip_space(text, at);
  if (at < text.size() && text[at] == ',') at = skip_space(text, at + 1);
  if (at >= text.size() || text[at] == bracket) return std::nullopt;
  return at;
}

}  // namespace

JsonSpan json_value(std::string_view text) { return value_at(text, 0); }

std::optional<JsonSpan> json_member(std::string_view text, JsonSpan object, std::string_view name) {
  if (object.of(text).empty() || text[object.begin] != '{') return std::nullopt;
  std::optional<JsonSpan> found;
  for (auto at = next_item(text, object.begin + 1, '}'); at;) {
    const JsonSpan key{*at + 1, end_of_string(text, *at) - 1};
    const JsonSpan value = value_at(text, skip_space(text, key.end + 1) + 1);  // after the colon
    if (key.of(text) == name) found = value;
    at = next_item(text, value.end, '}');
  }
  return found;
}

std::vector<JsonSpan> json_elements(std::string_view text, JsonSpan array) {
  std::vector<JsonSpan> elements;
  if (array.of(text).empty() || text[array.begin] != '[') return elements;
  for (auto at = next_item(text, array.begin + 1, ']'); at;) {
    elements.push_back(value_at(text, *at));
    at = next_item(text, elements.back().end, ']');
  }
  return elements;
}

}  // namespace engine
