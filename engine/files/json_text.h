#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

/// Where values stand in a text of JSON, to change some and leave every other byte as it is. The text has to be one
/// that parse_json takes.
namespace engine {

/// From its first byte to behind its last.
struct JsonSpan {
  std::size_t begin = 0;
  std::size_t end = 0;

  std::string_view of(std::string_view text) const { return text.substr(begin, end - begin); }
};

/// The whole value, without the space around it.
JsonSpan json_value(std::string_view text);
/// The value of an object's member, the last of that name; none if there is none, or if it is no object. The name is
/// compared as it is written: one without escapes is found.
std::optional<JsonSpan> json_member(std::string_view text, JsonSpan object, std::string_view name);
/// The values of an array; none of what is no array.
std::vector<JsonSpan> json_elements(std::string_view text, JsonSpan array);

}  // namespace engine
