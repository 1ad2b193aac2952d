#include "tests/study/cord_search.h"

#include <algorithm>
#include <cmath>

namespace study {

std::optional<CordSearch> search_of(const Study& study, double max_error_m, std::vector<int> cords) {
  constexpr double least_gain = 1.2;
  const std::vector<Point> points = applicable(study);
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (!points[k].not_compared && points[k].failure.empty() && std::isfinite(points[k].error_m)) order.push_back(k);
  }
  const auto work = [&study](std::size_t k) { return study.settings[k].tick_work.mean; };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return work(a) < work(b); });
  const auto common =
      std::find_if(order.begin(), order.end(), [&](std::size_t k) { return points[k].error_m <= max_error_m; });
  if (cords.size() < 2 || common == order.end() || work(*common) < least_gain * work(order.front()))
    return std::nullopt;
  CordSearch search{
      std::move(cords), {}, max_error_m, study.settings[*common].setting, {points[*common].error_m, work(*common), {}}};
  for (auto k = order.begin(); k != common; ++k) {
    if (!is_present(study.settings[*k].setting)) search.cheaper.push_back(study.settings[*k].setting);
  }
  return search;
}

}  // namespace study
