#pragma once

#include <string>
#include <string_view>

#include "engine/scene/tiled_properties.h"

/// Changes to a map's file that leave every other byte of it as it is: order, layout and what the loader does not know.
namespace engine {

/// The map's own properties, in place of an object's id.
inline constexpr int map_itself = 0;

/// The text of a map with a custom property of one object set, whether it had it or not. The text has to be one that
/// parse_tiled_map takes. Throws MapError if it has no such object, or for a number that is not finite.
std::string with_property(std::string_view text, int object, std::string_view name, const Properties::Value& value);

/// The same without it. Nothing changes where there is none.
std::string without_property(std::string_view text, int object, std::string_view name);

/// Puts a text in place of a file at once: whoever reads it finds the old one or the new one. Throws
/// std::runtime_error, and leaves the file as it was, if it cannot be written.
void replace_file(const std::string& path, std::string_view text);

}  // namespace engine
