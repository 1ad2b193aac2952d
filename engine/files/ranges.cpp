#include "engine/files/ranges.h"

#include <cstddef>

#include "engine/files/number_text.h"

namespace engine {
namespace {

std::string range_words(std::string noun, const std::string* min, const std::string* max) {
  if (min != nullptr && max != nullptr) return noun + " from " + *min + " to " + *max;
  if (min != nullptr) return noun + ", " + *min + " or more";
  if (max != nullptr) return noun + ", " + *max + " or less";
  return noun;
}

}  // namespace

std::string number_in_words(double value) { return shortest_text(value); }

std::string range_in_words(NumberRange range) {
  const std::string min = number_in_words(range.min);
  const std::string max = number_in_words(range.max);
  const NumberRange all;
  return range_words("a number", range.min > all.min ? &min : nullptr, range.max < all.max ? &max : nullptr);
}

std::string range_in_words(IntegerRange range) {
  const std::string min = std::to_string(range.min);
  const std::string max = std::to_string(range.max);
  const IntegerRange all;
  return range_words("a whole number", range.min > all.min ? &min : nullptr, range.max < all.max ? &max : nullptr);
}

std::string list_in_words(Choices choices) {
  if (choices.size() == 0) return "none";
  std::string list;
  for (const std::string_view choice : choices) list.append(list.empty() ? "" : ", ").append(choice);
  return list;
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t max_bytes = 80;
  constexpr std::string_view digits = "0123456789abcdef";
  std::string words = "\"";
  for (const char c : text.substr(0, max_bytes)) {
    const auto byte = static_cast<unsigned char>(c);
    // Bytes from 0x80 are copied: names are UTF-8.
    const bool printable = byte >= 0x20 && byte != 0x7F;
    if (printable) {
      words += c;
    } else {
      words += {'\\', 'x', digits[byte >> 4U], digits[byte & 0xFU]};
    }
  }
  if (text.size() <= max_bytes) return words + '"';
  while ((static_cast<unsigned char>(words.back()) & 0xC0U) == 0x80U) words.pop_back();
  return words + "…\"";
}

}  // namespace engine
