#pragma once

#include <optional>
#include <string>
#include <string_view>

/// Numbers as texts, without the locale. The library of Debian's emscripten has no std::to_chars and std::from_chars
/// for double; elsewhere these functions call them.
namespace engine {

/// Returns the shortest decimal text that reads as this number again, as std::to_chars writes it. Finite numbers only.
std::string shortest_text(double value);
/// The same without std::to_chars: it tries one digit after the other.
std::string shortest_text_by_search(double value);

/// Reads a number without an exponent, such as -0.25; nothing for any other text.
std::optional<double> fixed_number(std::string_view text);
/// The same without std::from_chars.
std::optional<double> fixed_number_by_strtod(std::string_view text);

}  // namespace engine
