#pragma once

#include <string>
#include <vector>

namespace study {

/// Returns a number with a number of significant digits: 0.00123, 1e+08.
std::string significant(double value, int digits);
/// Returns a number with four significant digits, as plots and reports show it.
inline std::string four_digits(double value) { return significant(value, 4); }
/// Returns a number with a number of decimals: 8.45.
std::string fixed(double value, int decimals);
/// Returns a count with its unit: 1 tick, 2 ticks.
std::string count_of(int count, const std::string& what);
/// Returns the content of a file; empty if it cannot be read.
std::string read_file(const std::string& path);
/// Returns a cell of a CSV file: in quotes if it has commas, quotes or line ends (RFC 4180).
std::string csv_cell(const std::string& text);
/// Returns the cells of a line of a CSV file. Throws std::invalid_argument for quotes that do not enclose a cell.
std::vector<std::string> csv_cells(const std::string& line);

}  // namespace study
