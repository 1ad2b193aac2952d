#pragma once

#include <string>

namespace game::lab {

/// Returns a number with so many decimals.
std::string fixed_text(double number, int decimals);
/// Returns a number with three significant digits; a very small or large one with a power of ten: "8.7·10⁻⁹".
std::string short_text(double number);
/// Returns a length with its unit: mm or m.
std::string length_text(double metres);
/// Returns an energy with its unit: J, kJ or MJ.
std::string energy_text(double joules);

}  // namespace game::lab
