#include "engine/files/number_text.h"

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <system_error>

namespace engine {
namespace {

constexpr int max_digits = 17;  // enough for every double

std::string scientific_text(int digits, double value) {
  char text[32];
  return {text, static_cast<std::size_t>(std::snprintf(text, sizeof text, "%.*e", digits - 1, value))};
}

std::string fixed_text(int decimals, double value) {
  char text[400];  // -1.8e308 with all its digits fits, and 5e-324 with one
  return {text, static_cast<std::size_t>(std::snprintf(text, sizeof text, "%.*f", decimals, value))};
}

/// Returns the decimals that a number with these digits and this power of ten has.
int decimals_of(int digits, const std::string& scientific) {
  const int power = std::atoi(scientific.c_str() + scientific.find('e') + 1);
  return digits - 1 > power ? digits - 1 - power : 0;
}

/// Returns whether the text is digits with at most one point between or beside them, and a minus before at most.
bool is_fixed(std::string_view text) {
  if (text.starts_with('-')) text.remove_prefix(1);
  const std::size_t point = text.find('.');
  if (point != std::string_view::npos && text.find('.', point + 1) != std::string_view::npos) return false;
  return text.find_first_not_of("0123456789.") == std::string_view::npos &&
         text.find_first_of("0123456789") != std::string_view::npos;
}

}  // namespace

std::string shortest_text_by_search(double value) {
  int digits = 1;
  while (digits < max_digits && std::strtod(scientific_text(digits, value).c_str(), nullptr) != value) ++digits;
  const std::string scientific = scientific_text(digits, value);
  const std::string fixed = fixed_text(decimals_of(digits, scientific), value);
  return fixed.size() <= scientific.size() ? fixed : scientific;
}

std::optional<double> fixed_number_by_strtod(std::string_view text) {
  if (!is_fixed(text)) return std::nullopt;
  const double value = std::strtod(std::string(text).c_str(), nullptr);
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

#ifdef __cpp_lib_to_chars

std::string shortest_text(double value) {
  char digits[32];
  return {digits, std::to_chars(std::begin(digits), std::end(digits), value).ptr};
}

std::optional<double> fixed_number(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
  const bool is_all = error == std::errc() && end == text.data() + text.size();
  return is_all && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

#else

std::string shortest_text(double value) { return shortest_text_by_search(value); }

std::optional<double> fixed_number(std::string_view text) { return fixed_number_by_strtod(text); }

#endif

}  // namespace engine
