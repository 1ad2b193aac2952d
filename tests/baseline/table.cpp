#include "tests/baseline/table.h"

#include <array>
#include <charconv>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace baseline {
namespace {

constexpr std::string_view header = "scene,method,setting,points,ticks,work,worst_tick";
constexpr std::size_t columns = 7;

/// A line of a file and its place, for error messages.
struct Line {
  const std::filesystem::path& path;
  int number;
  std::string_view text;

  [[noreturn]] void refuse(const std::string& what) const {
    throw std::runtime_error(path.string() + ":" + std::to_string(number) + ": " + what);
  }
};

std::string in_quotes(std::string_view text) { return std::string("'").append(text).append("'"); }

std::array<std::string_view, columns> cells_of(const Line& line) {
  std::array<std::string_view, columns> cells;
  std::string_view left = line.text;
  std::size_t count = 0;
  for (bool more = true; more; ++count) {
    const std::size_t comma = left.find(',');
    if (count < columns) cells[count] = left.substr(0, comma);
    more = comma != std::string_view::npos;
    if (more) left.remove_prefix(comma + 1);
  }
  if (count != columns) {
    line.refuse(std::to_string(count) + " columns; accepted are " + std::to_string(columns) + ": " +
                std::string(header));
  }
  return cells;
}

template <typename Number>
Number number_in(const Line& line, std::string_view cell, Number least) {
  Number value{};
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size() || value < least) {
    line.refuse(in_quotes(cell) + " is not accepted; accepted is a whole number of " + std::to_string(least) +
                " or more");
  }
  return value;
}

Row row_in(const Line& line) {
  const auto cells = cells_of(line);
  if (cells[0].empty() || cells[1].empty()) line.refuse("no scene or no method; accepted is a name of each");
  return {std::string(cells[0]),
          std::string(cells[1]),
          std::string(cells[2]),
          number_in(line, cells[3], 0),
          number_in(line, cells[4], 1),
          number_in(line, cells[5], std::int64_t{0}),
          number_in(line, cells[6], std::int64_t{0})};
}

}  // namespace

std::string name(const Row& row) {
  std::string words = row.scene;
  words.append(" ").append(row.method);
  if (!row.setting.empty()) words.append(" ").append(row.setting);
  return words.append(", ").append(std::to_string(row.points)).append(" points");
}

std::string to_csv(const std::vector<Row>& rows) {
  std::ostringstream out;
  out << header << '\n';
  for (const Row& row : rows) {
    out << row.scene << ',' << row.method << ',' << row.setting << ',' << row.points << ',' << row.ticks << ','
        << row.work << ',' << row.worst_tick << '\n';
  }
  return out.str();
}

std::vector<Row> read_table(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + path.string() + "; accepted is a table that --accept has written");
  std::vector<Row> rows;
  std::set<std::string> names;
  std::string text;
  std::getline(in, text);
  if (text != header)
    Line{path, 1, text}.refuse(in_quotes(text) + " is not accepted; accepted is " + std::string(header));
  for (int number = 2; std::getline(in, text); ++number) {
    const Line line{path, number, text};
    rows.push_back(row_in(line));
    if (!names.insert(name(rows.back())).second) {
      line.refuse(in_quotes(name(rows.back())) + " is there twice; accepted is one row of a name");
    }
  }
  return rows;
}

void write_table(const std::filesystem::path& path, const std::vector<Row>& rows) {
  std::ofstream out(path, std::ios::binary);
  out << to_csv(rows);
  out.flush();
  if (!out) throw std::runtime_error("cannot write " + path.string() + "; accepted is a file that can be written");
}

}  // namespace baseline
