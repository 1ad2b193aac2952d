#pragma once

#include <string>

namespace game::lab {

/// Returns a number with so many decimals.
std::string fixed_text(double number, int decimals);
/// Returns a number with three significant digits, without an exponent up to a million.
std::string short_text(double number);
/// Returns an energy with its unit: J, kJ or MJ.
std::string energy_text(double joules);

}  // namespace game::lab
