#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace baseline {

/// The work of a run, in a unit that is the same on every machine: CordReport::work.
struct Row {
  std::string scene;    ///< or the level of a recorded run
  std::string method;   ///< cord, held, recorded run
  std::string setting;  ///< balanced; what it simulates behind it, if the scene has several such; may be empty
  int points = 0;       ///< of all cords; of a recorded run those at its start
  int ticks = 0;
  std::int64_t work = 0;        ///< of all ticks
  std::int64_t worst_tick = 0;  ///< of the tick that takes the most

  bool operator==(const Row&) const = default;
};

/// What tells it from others: strips cord fast meeting each other, 9900 points.
std::string name(const Row& row);

/// A header and a line a row, in their order.
std::string to_csv(const std::vector<Row>& rows);

/// Throws std::runtime_error for what to_csv has not written, or a row that is there twice: file, line, what is
/// accepted.
std::vector<Row> read_table(const std::filesystem::path& path);
/// Throws std::runtime_error if it cannot.
void write_table(const std::filesystem::path& path, const std::vector<Row>& rows);

}  // namespace baseline
