#include "tests/study/cord_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace study {

namespace {

/// Returns the settings that count, by increasing work.
std::vector<std::size_t> by_work(const Study& study, const std::vector<Point>& points) {
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (is_compared(points[k])) order.push_back(k);
  }
  std::stable_sort(order.begin(), order.end(), [&study](std::size_t a, std::size_t b) {
    return study.settings[a].tick_work.mean < study.settings[b].tick_work.mean;
  });
  return order;
}

}  // namespace

CordBound bound_of(const Study& study, double max_error_m, std::size_t cords) {
  const std::vector<Point> points = applicable(study);
  CordBound bound;
  for (const std::size_t k : by_work(study, points)) {
    const Measured& m = study.settings[k];
    if (is_present(m.setting) || m.setting.max_work == ample_work) continue;
    if (std::isnan(bound.least_work)) bound.least_work = m.tick_work.mean;
    if (points[k].error_m > max_error_m) continue;
    bound.common = name_of(m.setting);
    bound.common_work = m.tick_work.mean;
    if (study.least_work_by_cord > bound.least_work) bound.least_work = study.least_work_by_cord;
    bound.most_gain = cords < 2 ? 1.0 : bound.common_work / bound.least_work;
    break;
  }
  return bound;
}

std::optional<CordSearch> search_of(const Study& study, double max_error_m, std::vector<int> cords) {
  constexpr double least_gain = 1.2;
  const std::vector<Point> points = applicable(study);
  std::vector<std::size_t> order = by_work(study, points);
  std::erase_if(order, [&study](std::size_t k) {
    return is_present(study.settings[k].setting) || study.settings[k].setting.max_work == ample_work;
  });
  const auto work = [&study](std::size_t k) { return study.settings[k].tick_work.mean; };
  const auto common =
      std::find_if(order.begin(), order.end(), [&](std::size_t k) { return points[k].error_m <= max_error_m; });
  if (cords.size() < 2 || common == order.end() || work(*common) < least_gain * work(order.front()))
    return std::nullopt;
  CordSearch search{
      std::move(cords), {}, max_error_m, study.settings[*common].setting, {points[*common].error_m, work(*common), {}}};
  for (auto k = order.begin(); k != common; ++k) search.cheaper.push_back(study.settings[*k].setting);
  return search;
}

double least_work_within(const Study& study, double max_error_m) {
  const std::vector<Point> points = applicable(study);
  for (const std::size_t k : by_work(study, points)) {
    if (points[k].error_m <= max_error_m) return study.settings[k].tick_work.mean;
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace study
