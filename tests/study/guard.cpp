#include "tests/study/guard.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "tests/study/command.h"
#include "tests/study/text.h"

namespace study {
namespace {

constexpr const char* header = "level,replay,ticks,work,most_work,error_m,work_margin_pct,error_margin_pct,failure";
constexpr double unseen = 1e-5;  // m

std::string percent_of(double now, double before) {
  return before > 0.0 ? " (+" + fixed(100.0 * (now / before - 1.0), 1) + " %)" : "";
}

/// Throws std::invalid_argument or std::out_of_range for what is not a number at or above 0.
double number_of(const std::string& text) {
  std::size_t used = 0;
  const double value = std::stod(text, &used);
  if (used != text.size() || !std::isfinite(value) || value < 0.0) throw std::invalid_argument(text);
  return value;
}

GuardRow stored_row_of(const std::vector<std::string>& cells) {
  if (cells.size() != 9 || cells[0].empty()) throw std::invalid_argument("cells");
  const auto count = [&cells](std::size_t k) { return static_cast<std::int64_t>(number_of(cells[k])); };
  return {cells[0],
          cells[1],
          static_cast<std::size_t>(count(2)),
          count(3),
          count(4),
          number_of(cells[5]),
          number_of(cells[6]),
          number_of(cells[7]),
          cells[8]};
}

GuardRow measure_row(const std::string& level, const std::string& replay) {
  StudyOptions options;
  options.quick = true;
  options.repeats = 1;
  options.grid = {present()};
  Command command;
  command.replay = replay;
  const LevelFile file(level);
  GuardRow row = guard_row_of(measure(file, replay_of(command, file), options));
  row.level = level;
  row.replay = replay;
  return row;
}

const GuardRow* find(const std::vector<GuardRow>& rows, const std::string& level) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const GuardRow& row) { return row.level == level; });
  return found == rows.end() ? nullptr : &*found;
}

std::vector<std::string> levels_of(const Guard& guard, const std::vector<GuardRow>& rows) {
  std::vector<std::string> levels = guard.levels;
  if (levels.empty()) {
    for (const GuardRow& row : rows) levels.push_back(row.level);
  }
  if (levels.empty()) {
    throw std::runtime_error(guard.file + " has no row, and no --level is given; accepted is one of the two");
  }
  return levels;
}

}  // namespace

std::vector<std::string> worse(const GuardRow& accepted, const GuardRow& measured) {
  std::vector<std::string> lines;
  if (measured.ticks != accepted.ticks) {
    lines.push_back("its recording has " + std::to_string(measured.ticks) + " ticks instead of " +
                    std::to_string(accepted.ticks));
  }
  const auto add_work = [&](const char* what, std::int64_t now, std::int64_t before) {
    const auto a = static_cast<double>(now);
    const auto b = static_cast<double>(before);
    if (a <= b * (1.0 + 0.01 * accepted.work_margin)) return;
    lines.push_back(std::string(what) + " " + std::to_string(now) + " instead of " + std::to_string(before) +
                    percent_of(a, b));
  };
  add_work("work", measured.work, accepted.work);
  add_work("work of the greatest tick", measured.most_work, accepted.most_work);
  const double most = std::max(accepted.error_m * (1.0 + 0.01 * accepted.error_margin), accepted.error_m + unseen);
  if (!(measured.error_m <= most)) {
    lines.push_back("error " + significant(measured.error_m, 3) + " m instead of " + significant(accepted.error_m, 3) +
                    " m" + percent_of(measured.error_m, accepted.error_m));
  }
  if (!measured.failure.empty() && measured.failure != accepted.failure)
    lines.push_back("it fails: " + measured.failure);
  return lines;
}

std::vector<GuardRow> read_guard(const std::string& path) {
  std::ifstream in(path);
  const std::string wanted = "; accepted is a file that --check FILE --accept has written";
  std::string line;
  if (!in || !std::getline(in, line)) throw std::runtime_error("cannot read " + path + wanted);
  if (line != header) throw std::runtime_error(path + ", line 1: has another header than " + header + wanted);
  std::vector<GuardRow> rows;
  for (int number = 2; std::getline(in, line); ++number) {
    const auto refuse = [&](const std::string& why) {
      throw std::runtime_error(std::string(path).append(", line ").append(std::to_string(number)).append(why) + wanted);
    };
    GuardRow row;
    try {
      row = stored_row_of(csv_cells(line));
    } catch (const std::logic_error&) {
      refuse(": is not a row");
    }
    if (find(rows, row.level) != nullptr) refuse(": has " + row.level + " again");
    rows.push_back(row);
  }
  return rows;
}

void write_guard(const std::string& path, const std::vector<GuardRow>& rows) {
  for (const GuardRow& row : rows) {
    if ((row.level + row.replay).find_first_of("\r\n") == std::string::npos) continue;
    throw std::runtime_error("a path has a line end: " + row.level + ' ' + row.replay + "; accepted in " + path +
                             " are levels and replays in one line");
  }
  const std::string beside = path + ".new";
  {
    std::ofstream out(beside);
    out << header << '\n';
    for (const GuardRow& row : rows) {
      out << csv_cell(row.level) << ',' << csv_cell(row.replay) << ',' << row.ticks << ',' << row.work << ','
          << row.most_work << ',' << significant(row.error_m, 6) << ',' << significant(row.work_margin, 6) << ','
          << significant(row.error_margin, 6) << ',' << csv_cell(row.failure) << '\n';
    }
    out.flush();
    if (!out) throw std::runtime_error("cannot write " + path + "; accepted is a file that can be written (--check)");
  }
  std::error_code error;
  std::filesystem::rename(beside, path, error);
  if (error) throw std::runtime_error("cannot write " + path + "; accepted is a file that can be written (--check)");
}

GuardRow guard_row_of(const Study& study) {
  const auto own = std::find_if(study.settings.begin(), study.settings.end(),
                                [](const Measured& m) { return is_present(m.setting); });
  if (own == study.settings.end()) throw std::logic_error("the study has no present setting");
  GuardRow row;
  row.level = study.level;
  row.ticks = study.ticks;
  row.work = own->work.work;
  row.most_work = static_cast<std::int64_t>(own->tick_work.most);
  row.error_m = applicable(study)[static_cast<std::size_t>(own - study.settings.begin())].error_m;
  row.failure = own->failure;
  return row;
}

int check(const Guard& guard) {
  const std::vector<GuardRow> rows = read_guard(guard.file);
  int status = 0;
  const std::vector<std::string> levels = levels_of(guard, rows);
  for (std::size_t k = 0; k < levels.size(); ++k) {
    if (!guard.shard.has(k, levels.size())) continue;
    const std::string& level = levels[k];
    const GuardRow* accepted = find(rows, level);
    if (accepted == nullptr) {
      throw std::runtime_error(guard.file + " has no row of " + level +
                               "; accepted is a level that --accept has added");
    }
    const GuardRow now = measure_row(level, guard.replay.empty() ? accepted->replay : guard.replay);
    const std::vector<std::string> lines = worse(*accepted, now);
    for (const std::string& line : lines) std::printf("worse: %s: %s\n", level.c_str(), line.c_str());
    if (!lines.empty()) status = 1;
    if (lines.empty()) {
      std::printf("%s: work %lld, greatest tick %lld, error %s m: as accepted\n", level.c_str(),
                  static_cast<long long>(now.work), static_cast<long long>(now.most_work),
                  significant(now.error_m, 3).c_str());
    }
    std::fflush(stdout);
  }
  if (status != 0) std::printf("if that is intended: the same command with --accept\n");
  return status;
}

int accept(const Guard& guard) {
  std::error_code ignored;
  std::vector<GuardRow> rows;
  if (std::filesystem::exists(guard.file, ignored)) rows = read_guard(guard.file);
  for (const std::string& level : levels_of(guard, rows)) {
    const GuardRow* known = find(rows, level);
    GuardRow now = measure_row(level, guard.replay.empty() && known != nullptr ? known->replay : guard.replay);
    if (known == nullptr) {
      rows.push_back(now);
    } else {
      now.work_margin = known->work_margin;
      now.error_margin = known->error_margin;
      rows[static_cast<std::size_t>(known - rows.data())] = now;
    }
    write_guard(guard.file, rows);  // an interrupted command has accepted those before
    std::printf("accepted: %s: work %lld, greatest tick %lld, error %s m\n", level.c_str(),
                static_cast<long long>(now.work), static_cast<long long>(now.most_work),
                significant(now.error_m, 3).c_str());
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace study
