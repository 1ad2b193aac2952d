#include "tests/study/frontier.h"

#include <gtest/gtest.h>

#include <cmath>

// A scene with known errors and costs: 1 m / n in n microseconds.

namespace study {
namespace {

Point point(double cost_us, double error_m, std::string failure = {}) {
  return {"direct", "some", cost_us, 2.0 * cost_us, error_m, std::move(failure)};
}

std::vector<Point> scene() {
  std::vector<Point> points;
  for (const double n : {8.0, 1.0, 4.0, 2.0, 16.0}) points.push_back(point(n, 1.0 / n));
  points.push_back(point(5.0, 0.3));              // dominated by 4 µs
  points.push_back(point(0.5, 0.01, "blew up"));  // would dominate all
  points.push_back(point(0.4, std::nan("")));     // without a number
  points.push_back(point(4.0, 0.25));             // as good as the first of that cost
  return points;
}

TEST(Frontier, HasThePointsThatNoOtherDominates) {
  EXPECT_EQ(front(scene()), (std::vector<std::size_t>{1, 3, 2, 0, 4}));
  EXPECT_TRUE(front(std::vector<Point>{}).empty());
  EXPECT_TRUE(front(std::vector{point(1.0, 1.0, "failed")}).empty());
}

TEST(Frontier, ExcludesPointsThatAreNotCompared) {
  std::vector<Point> points = scene();
  points[1].not_compared = true;
  EXPECT_EQ(front(points), (std::vector<std::size_t>{3, 2, 0, 4}));
  EXPECT_EQ(cheapest_within(points, 100.0), 3U);
}

TEST(Frontier, GroupsAreNotCompared) {
  std::vector<Point> points = {point(1.0, 0.5), point(2.0, 0.1), point(3.0, 0.4), point(4.0, 0.3)};
  for (const std::size_t k : {0U, 2U, 3U}) points[k].group = "heavy";
  points[1].group = "light";  // would dominate the other two
  EXPECT_EQ(groups_of(points), (std::vector<std::string>{"heavy", "light"}));
  EXPECT_EQ(front(points), (std::vector<std::size_t>{0, 2, 3, 1}));
}

TEST(Frontier, OfEqualCostItHasTheMoreExact) {
  const std::vector<Point> points = {point(1.0, 0.5), point(1.0, 0.2), point(2.0, 0.2)};
  EXPECT_EQ(front(points), std::vector<std::size_t>{1});
}

bool is_direct(const std::string& method) { return method == "direct"; }

TEST(Frontier, ReportsTheErrorsAtWhichABaselineIsBetter) {
  std::vector<Point> points = scene();
  EXPECT_TRUE(compare_with_baselines(points, is_direct).empty());  // nothing to compare with
  points.push_back(point(4.0, 0.3));
  points.back().method = "chain";
  EXPECT_EQ(compare_with_baselines(points, is_direct),
            std::vector<std::string>{"Our settings are on the Pareto front at every error."});

  points.push_back(point(3.0, 0.25));
  points.back().method = "chain";
  for (const double cost_us : {0.25, 0.5}) {
    points.push_back(point(cost_us, 1.0 / cost_us));
    points.back().method = "chain";
  }
  points.push_back(point(32.0, 0.001));
  points.back().method = "chain";
  points.push_back(point(0.1, 0.0, "failed"));
  points.back().method = "chain";
  EXPECT_EQ(
      compare_with_baselines(points, is_direct),
      (std::vector<std::string>{
          "A baseline is better at errors from 4 m up: chain some costs 0.25 us per tick, direct some costs 1 us "
          "per tick.",
          "A baseline is better at errors from 2 m to 4 m: chain some costs 0.5 us per tick, direct some costs 1 us "
          "per tick.",
          "A baseline is better at errors from 0.25 m to 0.5 m: chain some costs 3 us per tick, direct some costs 4 "
          "us per tick.",
          "A baseline is better at errors from 0.001 m to 0.0625 m: chain some costs 32 us per tick, no setting of "
          "ours is so accurate."}));
}

TEST(Frontier, TheCheapestMeetsTheErrorWithItsMargin) {
  EXPECT_EQ(cheapest_within(scene(), 0.25 / usable_error_share), 2U);
  EXPECT_EQ(cheapest_within(scene(), 0.99 * 0.25 / usable_error_share), 0U);
  EXPECT_EQ(cheapest_within(scene(), 100.0), 1U);
  EXPECT_FALSE(cheapest_within(scene(), 0.01));
}

TEST(Frontier, TheMostExactMeetsTheBudgetWithItsMargin) {
  EXPECT_EQ(most_exact_within(scene(), 8.0 / usable_budget_share), 0U);
  EXPECT_EQ(most_exact_within(scene(), 0.99 * 8.0 / usable_budget_share), 2U);
  EXPECT_FALSE(most_exact_within(scene(), 0.9));
}

}  // namespace
}  // namespace study
