#include "tests/study/frontier.h"

#include <algorithm>
#include <cmath>

#include "tests/study/text.h"

namespace study {
namespace {

/// Returns the best by `better` of those that satisfy `meets`; the first of equals.
template <typename Meets, typename Better>
std::optional<std::size_t> best(std::span<const Point> points, Meets meets, Better better) {
  std::optional<std::size_t> found;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (is_compared(points[k]) && meets(points[k]) && (!found || better(points[k], points[*found]))) found = k;
  }
  return found;
}

std::string with_cost(const Point& point) {
  return point.method + " " + point.setting + " costs " + significant(point.cost_us, 3) + " us per tick";
}

std::vector<std::size_t> front_of(std::span<const Point> points, const std::string& group) {
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (is_compared(points[k]) && points[k].group == group) order.push_back(k);
  }
  std::stable_sort(order.begin(), order.end(), [points](std::size_t a, std::size_t b) {
    if (points[a].cost_us != points[b].cost_us) return points[a].cost_us < points[b].cost_us;
    return points[a].error_m < points[b].error_m;
  });
  std::vector<std::size_t> on_it;
  for (const std::size_t k : order) {
    if (on_it.empty() || points[k].error_m < points[on_it.back()].error_m) on_it.push_back(k);
  }
  return on_it;
}

void add_comparison(std::span<const Point> points, const std::string& group,
                    const std::function<bool(const std::string& method)>& is_ours, const std::string& prefix,
                    std::vector<std::string>& sentences) {
  const auto ours = [&](const Point& p) { return is_compared(p) && p.group == group && is_ours(p.method); };
  const auto others = [&](const Point& p) { return is_compared(p) && p.group == group && !is_ours(p.method); };
  if (std::none_of(points.begin(), points.end(), ours) || std::none_of(points.begin(), points.end(), others)) return;
  const std::size_t count_before = sentences.size();
  const Point* before = nullptr;  // the cheaper neighbour on the front
  for (const std::size_t k : front_of(points, group)) {
    const Point& p = points[k];
    if (!is_ours(p.method)) {
      const auto rival = best(
          points, [&](const Point& q) { return ours(q) && q.error_m <= p.error_m; },
          [](const Point& a, const Point& b) { return a.cost_us < b.cost_us; });
      sentences.push_back(prefix + "A baseline is better at errors from " + significant(p.error_m, 3) + " m " +
                          (before == nullptr ? "up" : "to " + significant(before->error_m, 3) + " m") + ": " +
                          with_cost(p) + ", " +
                          (rival ? with_cost(points[*rival]) : "no setting of ours is so accurate") + ".");
    }
    before = &p;
  }
  if (sentences.size() == count_before)
    sentences.push_back(prefix + "Our settings are on the Pareto front at every error.");
}

}  // namespace

bool is_compared(const Point& point) {
  return point.failure.empty() && !point.not_compared && std::isfinite(point.error_m);
}

std::vector<std::string> groups_of(std::span<const Point> points) {
  std::vector<std::string> groups;
  for (const Point& point : points) {
    if (std::find(groups.begin(), groups.end(), point.group) == groups.end()) groups.push_back(point.group);
  }
  return groups;
}

std::vector<std::size_t> front(std::span<const Point> points) {
  std::vector<std::size_t> all;
  for (const std::string& group : groups_of(points)) {
    const std::vector<std::size_t> own = front_of(points, group);
    all.insert(all.end(), own.begin(), own.end());
  }
  return all;
}

std::vector<std::string> compare_with_baselines(std::span<const Point> points,
                                                const std::function<bool(const std::string& method)>& is_ours) {
  std::vector<std::string> sentences;
  const std::vector<std::string> groups = groups_of(points);
  for (const std::string& group : groups) {
    add_comparison(points, group, is_ours, groups.size() > 1 ? group + ": " : "", sentences);
  }
  return sentences;
}

std::optional<std::size_t> cheapest_within(std::span<const Point> points, double max_error) {
  return best(
      points, [max_error](const Point& p) { return p.error_m <= usable_error_share * max_error; },
      [](const Point& a, const Point& b) { return a.cost_us < b.cost_us; });
}

std::optional<std::size_t> most_exact_within(std::span<const Point> points, double budget_us) {
  return best(
      points, [budget_us](const Point& p) { return p.cost_us <= usable_budget_share * budget_us; },
      [](const Point& a, const Point& b) { return a.error_m < b.error_m; });
}

}  // namespace study
