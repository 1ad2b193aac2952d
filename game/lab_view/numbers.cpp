#include "game/lab_view/numbers.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "game/words/lab_words.h"
#include "game/words/words.h"

namespace game::lab {
namespace {

/// Returns a whole number as an exponent.
std::string raised(int exponent) {
  constexpr std::array digits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "⁻" : "";
  for (const char digit : std::to_string(std::abs(exponent))) text += digits[static_cast<std::size_t>(digit - '0')];
  return text;
}

std::string with_power(double number) {
  const int exponent = static_cast<int>(std::floor(std::log10(std::abs(number))));
  return words::filled(words::lab::power,
                       {{"number", fixed_text(number / std::pow(10.0, exponent), 1)}, {"exponent", raised(exponent)}});
}

}  // namespace

std::string fixed_text(double number, int decimals) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, number);
  return text.data();
}

std::string short_text(double number) {
  const double size = std::abs(number);
  if (size >= 100.0 && size < 1e7) return fixed_text(number, 0);
  if (size != 0.0 && std::isfinite(size) && (size < 1e-3 || size >= 1e7)) return with_power(number);
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.3g", number == 0.0 ? 0.0 : number);  // not −0
  return text.data();
}

std::string energy_text(double joules) {
  const double size = std::abs(joules);
  if (size >= 1e6) return words::filled(words::lab::megajoules_value, {{"number", short_text(1e-6 * joules)}});
  if (size >= 1e3) return words::filled(words::lab::kilojoules_value, {{"number", short_text(1e-3 * joules)}});
  return words::filled(words::lab::joules_value, {{"number", short_text(joules)}});
}

std::string length_text(double metres) {
  const bool small = std::abs(metres) < 1.0;
  return words::filled(small ? words::lab::millimetres_value : words::lab::metres_value,
                       {{"number", short_text(small ? 1e3 * metres : metres)}});
}

}  // namespace game::lab
