#include "tests/baseline/check.h"

#include <cstdio>

#include "tests/baseline/compare.h"
#include "tests/baseline/count.h"
#include "tests/study/progress_bar.h"

namespace baseline {
namespace {

std::vector<Row> count_with_progress(const std::vector<tradeoff::Scene>& scenes) {
  return count_all(scenes, [](double share) { study::show_progress("counting", share); });
}

std::string command(const std::filesystem::path& table) {
  return "build/release/bin/tradeoff --baseline " + table.string() + " --accept";
}

}  // namespace

int check(const std::vector<tradeoff::Scene>& scenes, const std::filesystem::path& table) {
  const std::vector<Row> before = read_table(table);  // fails early, before minutes of counting
  const std::vector<Row> now = count_with_progress(scenes);
  const Comparison found = compare(before, now);
  for (const std::string& sentence : found.better) std::printf("better: %s\n", sentence.c_str());
  for (const std::string& sentence : found.worse) std::printf("worse: %s\n", sentence.c_str());
  std::printf("%zu rows, %zu worse, %zu better", now.size(), found.worse.size(), found.better.size());
  if (!found.worse.empty()) {
    std::printf("; accept what is meant with: %s\n", command(table).c_str());
    return 1;
  }
  if (!found.better.empty()) std::printf("; hold on to it with: %s", command(table).c_str());
  std::printf("\n");
  return 0;
}

void accept(const std::vector<tradeoff::Scene>& scenes, const std::filesystem::path& table) {
  const std::vector<Row> rows = count_with_progress(scenes);
  write_table(table, rows);
  std::printf("%zu rows written to %s\n", rows.size(), table.string().c_str());
}

}  // namespace baseline
