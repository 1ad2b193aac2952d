#pragma once

#include <string>

namespace study {

/// A number with so many significant digits: 0.00123, 1e+08.
std::string significant(double value, int digits);
/// With so many decimals: 8.45.
std::string fixed(double value, int decimals);
/// 1 tick, 2 ticks.
std::string count_of(int count, const std::string& what);
/// What a file has in it; empty if it cannot be read.
std::string content_of(const std::string& path);

}  // namespace study
