#include "game/lab_view/numbers.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "game/words/lab_words.h"
#include "game/words/words.h"

namespace game::lab {

std::string fixed_text(double number, int decimals) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, number);
  return text.data();
}

std::string short_text(double number) {
  const double size = std::abs(number);
  if (size >= 100.0 && size <= 1e7) return fixed_text(number, 0);
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

}  // namespace game::lab
