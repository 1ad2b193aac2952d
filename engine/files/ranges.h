#pragma once

#include <cstdint>
#include <initializer_list>
#include <limits>
#include <string>
#include <string_view>

/// Ranges of accepted values, and values and ranges in words for error messages.
namespace engine {

/// An inclusive range; by default all finite numbers.
struct NumberRange {
  double min = std::numeric_limits<double>::lowest();
  double max = std::numeric_limits<double>::max();

  bool contains(double value) const { return value >= min && value <= max; }
};

/// An inclusive range; by default all numbers.
struct IntegerRange {
  std::int64_t min = std::numeric_limits<std::int64_t>::min();
  std::int64_t max = std::numeric_limits<std::int64_t>::max();

  bool contains(std::int64_t value) const { return value >= min && value <= max; }
};

using Choices = std::initializer_list<std::string_view>;

/// Returns the shortest digits that read back as the same number, so that different numbers have different texts.
std::string number_in_words(double value);
/// `a number from 0.1 to 20`, `a number, 0.1 or more`, …
std::string range_in_words(NumberRange range);
/// `a whole number from 1 to 8`, …
std::string range_in_words(IntegerRange range);
/// `rope, bridge, net`, or `none`.
std::string list_in_words(Choices choices);
/// Returns the text in quotes, with control characters as \xNN, cut at about 80 bytes. For texts from files.
std::string in_quotes(std::string_view text);

}  // namespace engine
