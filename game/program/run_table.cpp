#include "game/program/run_table.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <system_error>
#include <tuple>

#include "game/screens/level_facts.h"
#include "game/view/hud.h"

namespace game {
namespace {

namespace fs = std::filesystem;

using Row = RunTable::Row;

/// The order of the table. A run without help is better than any with help; one without the flag is last.
auto rank(const Row& row) {
  const VerifiedTime& time = row.time;
  const int number = time.number == 0 ? std::numeric_limits<int>::max() : time.number;
  if (!time.fault.empty()) return std::tuple(true, 0, std::string(), false, 0, row.file);
  return std::tuple(false, number, time.level, time.assisted, time.ticks.value_or(std::numeric_limits<int>::max()),
                    row.file);
}

bool is_level(const Row& a, const Row& b) { return a.time.level == b.time.level; }

bool ties(const Row& a, const Row& b) {
  return is_level(a, b) && a.time.ticks == b.time.ticks && a.time.assisted == b.time.assisted;
}

std::string line_of(const Row& row, int place) {
  const VerifiedTime& time = row.time;
  const std::string number = time.ticks ? std::to_string(place) : "-";
  const std::string seconds = time.ticks ? seconds_in_words(*time.ticks) : "no flag";
  const std::string medal = time.assisted ? "with help" : medal_title(time.medal);
  std::array<char, 64> start{};
  std::snprintf(start.data(), start.size(), "%5s  %9s  %-9s  ", number.c_str(), seconds.c_str(), medal.c_str());
  return start.data() + row.file + "\n";
}

std::string count_in_words(std::ptrdiff_t count, const char* one, const char* several) {
  return std::to_string(count) + (count == 1 ? one : several);
}

/// A bar on the error stream, so that the output stays clean.
void show_progress(double share) {
  constexpr int width = 40;
  const int full = static_cast<int>(share * width);
  std::fprintf(stderr, "\r[%s%s] %3.0f %%", std::string(static_cast<std::size_t>(full), '#').c_str(),
               std::string(static_cast<std::size_t>(width - full), '.').c_str(), 100.0 * share);
  if (share >= 1.0) std::fputs("\r\033[K", stderr);
}

}  // namespace

std::string RunTable::text() const {
  std::string text;
  int place = 0;
  int in_level = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const Row& row = rows[k];
    if (!row.time.fault.empty()) {
      if (k == 0 || rows[k - 1].time.fault.empty()) text += "Not true\n";
      text += "  " + row.file + ": " + row.time.fault + "\n";
      continue;
    }
    const bool begins = k == 0 || !is_level(rows[k - 1], row);
    if (begins) text += row.time.title + "\n";
    in_level = begins ? 1 : in_level + 1;
    if (begins || !ties(rows[k - 1], row)) place = in_level;
    text += line_of(row, place);
  }
  const auto bad = std::count_if(rows.begin(), rows.end(), [](const Row& row) { return !row.time.fault.empty(); });
  const auto good = static_cast<std::ptrdiff_t>(rows.size()) - bad;
  text += count_in_words(good, " recording is true", " recordings are true");
  if (bad > 0) text += ", " + count_in_words(bad, " is not", " are not");
  if (other_files > 0) text += "; " + count_in_words(other_files, " other file", " other files");
  return text + "\n";
}

bool RunTable::all_are_true() const {
  return std::all_of(rows.begin(), rows.end(), [](const Row& row) { return row.time.fault.empty(); });
}

RunTable table_of(const std::string& folder, const std::function<void(double share)>& report) {
  RunTable table;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    if (entry->path().extension() == ".replay") {
      table.rows.push_back({entry->path().filename().string(), {}});
    } else if (std::error_code ignored; !entry->is_directory(ignored)) {
      ++table.other_files;
    }
  }
  if (error) {
    throw std::runtime_error(folder + ": cannot be read: " + error.message() + "; accepted is a folder of recordings");
  }
  std::sort(table.rows.begin(), table.rows.end(), [](const Row& a, const Row& b) { return a.file < b.file; });
  const auto count = static_cast<double>(table.rows.size());
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    const auto part = [&](double share) {
      if (report) report((static_cast<double>(k) + share) / count);
    };
    table.rows[k].time = verify_time((fs::path(folder) / table.rows[k].file).string(), part);
    part(1.0);
  }
  std::sort(table.rows.begin(), table.rows.end(), [](const Row& a, const Row& b) { return rank(a) < rank(b); });
  return table;
}

int print_table(const std::string& folder) {
  const RunTable table = table_of(folder, isatty(STDERR_FILENO) != 0 ? show_progress : std::function<void(double)>());
  std::fputs(table.text().c_str(), stdout);
  return table.all_are_true() ? 0 : 1;
}

}  // namespace game
