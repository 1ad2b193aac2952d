#pragma once

#include <string>
#include <string_view>

#include "engine/scene/tiled_properties.h"

/// Edits the text of a map and leaves every other byte as it is: order, layout and fields that the loader ignores.
namespace engine {

/// In place of an object's id: the properties of the map itself.
inline constexpr int map_itself = 0;

/// Returns the text of a map with a custom property of one object set or added. The text must be valid for
/// parse_tiled_map. Throws MapError if there is no such object, or for a number that is not finite.
std::string with_property(std::string_view text, int object, std::string_view name, const Properties::Value& value);

/// Returns the text without the property, unchanged if there is none. Throws MapError if there is no such object.
std::string without_property(std::string_view text, int object, std::string_view name);

/// Replaces a file atomically: readers find the old text or the new one. Throws std::runtime_error, and leaves the file
/// as it was, if it cannot be written.
void replace_file(const std::string& path, std::string_view text);

}  // namespace engine
