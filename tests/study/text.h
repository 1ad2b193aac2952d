#pragma once

#include <string>

namespace study {

/// Returns a number with a number of significant digits: 0.00123, 1e+08.
std::string significant(double value, int digits);
/// Returns a number with a number of decimals: 8.45.
std::string fixed(double value, int decimals);
/// Returns a count with its unit: 1 tick, 2 ticks.
std::string count_of(int count, const std::string& what);
/// Returns the content of a file; empty if it cannot be read.
std::string read_file(const std::string& path);

}  // namespace study
