#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

/// Finds the bytes of values in a JSON text, to change some and leave every other byte as it is. The text must be valid
/// for parse_json.
namespace engine {

/// The bytes [begin, end) of a text.
struct JsonSpan {
  std::size_t begin = 0;
  std::size_t end = 0;

  std::string_view of(std::string_view text) const { return text.substr(begin, end - begin); }
};

/// Returns the root value, without the white space around it.
JsonSpan json_value(std::string_view text);
/// Returns the value of the last member with that name; nothing if there is none or `object` is not an object. Names
/// are compared as they are written, so a name with escapes is not found.
std::optional<JsonSpan> json_member(std::string_view text, JsonSpan object, std::string_view name);
/// Returns the elements of an array; none if the value is not an array.
std::vector<JsonSpan> json_elements(std::string_view text, JsonSpan array);

}  // namespace engine
