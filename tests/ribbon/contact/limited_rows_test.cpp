#include "ribbon/convex/limited_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "ribbon/convex/active_set.h"
#include "ribbon/convex/interior_point.h"
#include "tests/support/constants.h"
#include "tests/support/dice.h"

namespace ribbon {
namespace {

using constants::infinity;
using test_support::Dice;

/// Points of different masses with random forces, and limited springs between some of them.
struct Problem {
  std::vector<double> inertia;  // N/m
  std::vector<Vec2> force;      // N
  LimitedRows rows;
  ActiveSet active_set;
  InteriorPoint interior_point;
  BlockLdlt matrix;

  Problem(int points, int count, unsigned seed) {
    Dice dice(seed);
    for (int p = 0; p < points; ++p) {
      inertia.push_back(std::pow(10.0, dice(-1.0, 3.0)));
      force.push_back({dice(-100.0, 100.0), dice(-100.0, 100.0)});
    }
    for (int k = 0; k < count; ++k) {
      SlotRow row;
      for (int i = 0; i < 3; ++i) {
        row.add(static_cast<int>(dice(0.0, points)), {dice(-1.0, 1.0), dice(-1.0, 1.0)});
      }
      const bool contact = dice.coin();
      const double most = dice(0.0, 50.0) + 1e-3;
      rows.add({row, dice(-0.1, 0.1), std::pow(10.0, dice(-7.0, -4.0)), contact ? 0.0 : -most,
                contact ? infinity : most, 0.0});
    }
    std::vector<int> order(static_cast<std::size_t>(points));
    std::iota(order.begin(), order.end(), 0);
    matrix.begin_pattern(order);
    rows.couple(matrix);
    matrix.end_pattern();
  }

  std::vector<Vec2> load() {
    matrix.set_zero();
    for (std::size_t p = 0; p < inertia.size(); ++p) {
      matrix.add(static_cast<int>(p), inertia[p], 0.0, inertia[p]);
    }
    return force;
  }

  /// Solves by active sets, if these end within the given number.
  bool solve_active_sets(std::vector<Vec2>& step, int most) {
    for (int k = 0; k < most; ++k) {
      step = load();
      active_set.load(rows.rows(), matrix, step);
      EXPECT_TRUE(matrix.solve(step));
      if (active_set.update(rows.rows(), step, 0.0) == 0) return true;
    }
    return false;
  }

  /// Solves by the interior-point method; returns the number of linear systems.
  int solve_interior(std::vector<Vec2>& step, double gap) {
    interior_point.begin(rows.rows(), active_set.max_predicted_force());
    for (int k = 1; k <= 60; ++k) {
      step = load();
      interior_point.load_matrix(rows.rows(), matrix);
      interior_point.load_force(rows.rows(), step);
      EXPECT_TRUE(matrix.solve(step));
      interior_point.predict(rows.rows(), step);
      step = force;
      interior_point.load_force(rows.rows(), step);
      matrix.solve_again(step);
      interior_point.advance(rows.rows(), step);
      if (interior_point.gap() <= gap) return k;
    }
    return 61;
  }

  /// Returns the residual of the force balance after a step, with the rows' forces by their law, relative to the
  /// largest of these.
  double misfit(const std::vector<Vec2>& step) const {
    double greatest = 0.0;
    std::vector<Vec2> left = force;
    for (std::size_t p = 0; p < left.size(); ++p) left[p] -= inertia[p] * step[p];
    for (const LimitedRow& row : rows.rows()) {
      const double z = row.value + row.row.along(step);
      const double pull = std::clamp(-z / row.compliance, row.low, row.high);
      greatest = std::max(greatest, std::abs(pull));
      row.row.push(pull, left);
    }
    double most = 0.0;
    for (const Vec2 f : left) most = std::max(most, length(f));
    return most / greatest;
  }
};

TEST(LimitedRows, InteriorPointAndActiveSetAfterItSolveAnyProblem) {
  int most = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    Problem problem(20, 10 + static_cast<int>(seed % 50), seed);
    std::vector<Vec2> step;
    problem.active_set.begin(problem.rows.rows());
    problem.solve_active_sets(step, 1);
    most = std::max(most, problem.solve_interior(step, 1e-10));
    problem.interior_point.end(problem.rows.rows(), problem.active_set);
    ASSERT_TRUE(problem.solve_active_sets(step, 8)) << seed;
    EXPECT_LE(problem.misfit(step), 6e-3) << seed;  // a ten thousandth each of up to 59 rows
  }
  EXPECT_LE(most, 40);
}

/// Otherwise the friction of a contact that has separated would be limited by what is left of its force.
TEST(LimitedRows, NoForceIsLeftOfAContactThatHasSeparated) {
  Problem problem(20, 40, 5);
  std::vector<Vec2> step;
  problem.active_set.begin(problem.rows.rows());
  problem.solve_active_sets(step, 1);
  problem.solve_interior(step, 1e-10);
  problem.interior_point.end(problem.rows.rows(), problem.active_set);
  int separated = 0;
  for (const LimitedRow& row : problem.rows.rows()) {
    if (row.has_high()) continue;
    EXPECT_TRUE(row.force == 0.0 || row.force > 1e-6) << row.force;
    if (row.force == 0.0) ++separated;
  }
  EXPECT_GT(separated, 0);
}

TEST(LimitedRows, TheSlopeOfThePotentialIsTheForce) {
  Problem problem(5, 12, 3);
  Dice dice(11);
  std::vector<Vec2> step;
  for (int p = 0; p < 5; ++p) step.push_back({dice(-1e-3, 1e-3), dice(-1e-3, 1e-3)});
  const double h = 1e-6;
  const double slope = (problem.rows.potential(step, 1.0 + h) - problem.rows.potential(step, 1.0 - h)) / (2.0 * h);
  double expected = 0.0;
  for (const LimitedRow& row : problem.rows.rows()) {
    const double along = row.row.along(step);
    expected -= std::clamp(-(row.value + along) / row.compliance, row.low, row.high) * along;
  }
  EXPECT_NEAR(slope, expected, 1e-4 * std::abs(expected));
}

}  // namespace
}  // namespace ribbon
