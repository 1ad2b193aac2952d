#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace baseline {

/// The work of a run by IslandReport::work, which is the same on every machine.
struct Row {
  std::string scene;    ///< or the level of a recorded run
  std::string method;   ///< cord, held, recorded run
  std::string setting;  ///< balanced; followed by the part if the scene has parts; may be empty
  int points = 0;       ///< of all cords; of a recorded run those at its start
  int ticks = 0;
  std::int64_t work = 0;        ///< of all ticks
  std::int64_t worst_tick = 0;  ///< maximum of a tick

  bool operator==(const Row&) const = default;
};

/// Returns the unique name of a row: strips cord fast with contact between strips, 9900 points.
std::string name(const Row& row);

/// Returns a header and a line per row, in their order.
std::string to_csv(const std::vector<Row>& rows);

/// Throws std::runtime_error for text that is not from to_csv, or a duplicate row, with file, line and what is
/// accepted.
std::vector<Row> read_table(const std::filesystem::path& path);
/// Throws std::runtime_error if it cannot be written.
void write_table(const std::filesystem::path& path, const std::vector<Row>& rows);

}  // namespace baseline
