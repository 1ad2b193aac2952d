#include "tests/baseline/compare.h"

#include <cmath>
#include <map>

#include "tests/study/text.h"

namespace baseline {
namespace {

/// Formats with thousands separators: 12,345,678.
std::string grouped(std::int64_t value) {
  const std::string digits = std::to_string(value);
  std::string text;
  for (std::size_t k = 0; k < digits.size(); ++k) {
    if (k > 0 && (digits.size() - k) % 3 == 0) text += ',';
    text += digits[k];
  }
  return text;
}

/// Returns the increase in percent of the previous value.
double percent_more(std::int64_t now, std::int64_t before) {
  if (now == before) return 0.0;
  return 100.0 * (static_cast<double>(now) / static_cast<double>(before) - 1.0);
}

/// Returns "12 % more"; without a number if there was no work before.
std::string in_words(double percent) {
  if (std::isinf(percent)) return "more than none";
  return study::significant(std::abs(percent), 3) + (percent > 0.0 ? " % more" : " % less");
}

void compare(const std::string& what, std::int64_t before, std::int64_t now, Comparison& found) {
  const double percent = percent_more(now, before);
  if (std::abs(percent) <= allowed_percent) return;
  std::string sentence = what + " " + grouped(now) + ", baseline " + grouped(before) + ": " + in_words(percent);
  if (percent > 0.0) {
    found.worse.push_back(sentence + " (" + study::significant(allowed_percent, 3) + " % allowed)");
  } else {
    found.better.push_back(std::move(sentence));
  }
}

void compare(const Row& before, const Row& now, Comparison& found) {
  if (now.ticks != before.ticks) {
    found.worse.push_back(name(now) + ": " + std::to_string(now.ticks) + " ticks, baseline " +
                          std::to_string(before.ticks) + "; accepted are as many");
    return;
  }
  compare(name(now) + ": work", before.work, now.work, found);
  compare(name(now) + ": worst tick", before.worst_tick, now.worst_tick, found);
}

}  // namespace

Comparison compare(const std::vector<Row>& baseline, const std::vector<Row>& counted) {
  std::map<std::string, const Row*> left;
  for (const Row& row : baseline) left[name(row)] = &row;
  Comparison found;
  for (const Row& row : counted) {
    const auto before = left.find(name(row));
    if (before == left.end()) {
      found.worse.push_back(name(row) + ": counted, and not in the baseline");
      continue;
    }
    compare(*before->second, row, found);
    left.erase(before);
  }
  for (const Row& row : baseline) {
    if (left.count(name(row)) != 0) found.worse.push_back(name(row) + ": in the baseline, and not counted");
  }
  return found;
}

}  // namespace baseline
