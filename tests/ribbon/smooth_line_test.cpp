#include "ribbon/smooth_line.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "ribbon/cut.h"
#include "ribbon/layout.h"
#include "tests/ribbon/smooth_lines.h"
#include "tests/support/allocations.h"
#include "tests/support/dice.h"
#include "tests/support/points.h"
#include "tests/support/refusal.h"

namespace ribbon {
namespace {

using test_support::Dice;
using test_support::equally_spaced;

std::vector<Vec2> scattered(Dice& dice, int count) {
  std::vector<Vec2> points;
  for (int k = 0; k < count; ++k) points.push_back({dice(-5.0, 5.0), dice(-5.0, 5.0)});
  return points;
}

/// `count` points of the unit circle, neighbours at an angle [rad].
std::vector<Vec2> on_circle(int count, double angle) {
  std::vector<Vec2> points;
  for (int k = 0; k < count; ++k) points.push_back({std::cos(angle * k), std::sin(angle * k)});
  return points;
}

/// Fails unless all numbers are finite, normals have the length 1 and arcs do not fall.
void expect_sound(const std::vector<LineVertex>& line) {
  for (std::size_t k = 0; k < line.size(); ++k) {
    ASSERT_TRUE(is_finite(line[k].position)) << k;
    ASSERT_NEAR(length(line[k].normal), 1.0, 1e-12) << k;
    ASSERT_GE(line[k].arc, k > 0 ? line[k - 1].arc : 0.0) << k;
  }
}

TEST(SmoothLine, PassesThroughThePoints) {
  Dice dice(1);
  for (int subdivisions = 1; subdivisions <= 9; ++subdivisions) {
    const std::vector<Vec2> points = scattered(dice, 12);
    const auto line = line_of(points, subdivisions);
    ASSERT_EQ(line.size(), 11U * static_cast<std::size_t>(subdivisions) + 1U);
    for (std::size_t i = 0; i < points.size(); ++i)
      EXPECT_EQ(line[i * static_cast<std::size_t>(subdivisions)].position, points[i]);
    expect_sound(line);
  }
}

/// Between its points a spline is a cubic; that through four points by Barry and Goldman's pyramid is the definition.
TEST(SmoothLine, IsTheCentripetalCatmullRomSpline) {
  const std::vector<Vec2> p{{0.0, 0.0}, {3.0, 0.0}, {3.2, 0.3}, {2.0, 2.0}};
  const auto line = line_of(p, 10);
  std::array<double, 4> t{};
  for (std::size_t k = 1; k < 4; ++k) t[k] = t[k - 1] + std::sqrt(length(p[k] - p[k - 1]));
  for (std::size_t k = 0; k <= 10; ++k) {
    const double at = t[1] + 0.1 * static_cast<double>(k) * (t[2] - t[1]);
    const auto between = [at](Vec2 a, Vec2 b, double t_a, double t_b) {
      return a + ((at - t_a) / (t_b - t_a)) * (b - a);
    };
    const Vec2 before = between(p[0], p[1], t[0], t[1]);
    const Vec2 middle = between(p[1], p[2], t[1], t[2]);
    const Vec2 after = between(p[2], p[3], t[2], t[3]);
    const Vec2 expected = between(between(before, middle, t[0], t[2]), between(middle, after, t[1], t[3]), t[1], t[2]);
    EXPECT_NEAR(length(line[10 + k].position - expected), 0.0, 1e-12) << k;
  }
}

/// A uniform spline with unequal distances would have a cusp or a loop within a short piece.
TEST(SmoothLine, HasNoCuspInAShortPiece) {
  const auto line = line_of({{0.0, 0.0}, {3.0, 0.0}, {3.1, 0.1}, {3.0, 3.0}}, 16);
  for (std::size_t k = 17; k < 32; ++k) {
    const Vec2 in = line[k].position - line[k - 1].position;
    const Vec2 out = line[k + 1].position - line[k].position;
    EXPECT_GT(dot(in, out), 0.0) << k;
  }
}

/// Of a link between links up to 100 times longer or shorter, in any directions.
TEST(SmoothLine, StaysNearEachLink) {
  Dice dice(7);
  double farthest = 0.0;
  for (int trial = 0; trial < 20'000; ++trial) {
    std::vector<Vec2> points{{0.0, 0.0}};
    for (int k = 0; k < 3; ++k) {
      const double angle = dice(0.0, 2.0 * std::numbers::pi);
      points.push_back(points.back() + std::pow(10.0, dice(-1.0, 1.0)) * Vec2{std::cos(angle), std::sin(angle)});
    }
    const auto line = line_of(points, 16);
    for (std::size_t k = 0; k < line.size(); ++k) {
      const std::size_t i = std::min<std::size_t>(k / 16, 2);
      const std::array<Vec2, 2> link{points[i], points[i + 1]};
      const double distance = test_support::distance_to_path(line[k].position, link);
      farthest = std::max(farthest, distance / length(link[1] - link[0]));
    }
  }
  EXPECT_LT(farthest, 0.25) << "links";
  EXPECT_GT(farthest, 0.2) << "links: the trials come near the limit";
}

/// With 31 points around the circle the chords are up to 5.0e-3 away from it, and the line 3.7e-5; the ends are no
/// worse than the rest.
TEST(SmoothLine, ApproximatesACircleUpToItsEnds) {
  const std::vector<Vec2> points = on_circle(31, 0.2);
  const auto line = line_of(points, 10);
  const double sagitta = 1.0 - std::cos(0.1);
  double error = 0.0;
  for (const LineVertex& vertex : line) error = std::max(error, std::abs(length(vertex.position) - 1.0));
  EXPECT_LT(error, 0.0076 * sagitta);
  for (const StripVertex& vertex : strip_of({points}, 0.1, 10)) {
    const double radius = vertex.across == 0.0 ? 1.1 : 0.9;
    EXPECT_NEAR(length(vertex.position), radius, 5e-5);
  }
}

TEST(SmoothLine, NormalsTurnLittleFromVertexToVertex) {
  const auto line = line_of(on_circle(31, 0.2), 10);
  expect_sound(line);
  for (std::size_t k = 1; k < line.size(); ++k) {
    EXPECT_NEAR(cross(line[k - 1].normal, line[k].normal), k == 1 || k + 1 == line.size() ? 0.01 : 0.02, 2e-3) << k;
    EXPECT_LT(dot(line[k].normal, line[k].position), -0.99) << "the centre is on the left";
  }
}

/// The texture of a rope that is stretched evenly is stretched evenly, also where a short link meets a long one.
TEST(SmoothLine, ArcsFollowTheRestLengths) {
  const std::vector<Vec2> points{{0.0, 0.0}, {0.2, 0.0}, {2.2, 0.0}, {4.2, 0.0}};
  const std::array<double, 3> links{0.1, 1.0, 1.0};
  const auto line = line_of({points, 1, RestLengths(links)}, 8);
  expect_sound(line);
  for (const LineVertex& vertex : line) EXPECT_NEAR(vertex.arc, 0.5 * vertex.position.x, 1e-12);
  double start = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(line[8 * i].arc, start);
    if (i < 3) start += links[i];
  }
}

TEST(SmoothLine, ReadsTheRestLengthsOfACordThatIsReeled) {
  CordDef def;
  def.points = 11;
  def.length = 5.0;
  def.pins = {0};
  Cord cord(def);
  cord.reel(0, 4, 0.5, 2.0);
  for (int tick = 0; tick < 40; ++tick) cord.step(1.0 / 60.0, {0.0, -9.81});
  ASSERT_LT(cord.rest_length(0), 0.4 * cord.rest_length(9));
  const auto line = line_of(point_grid(cord), 4);
  double start = 0.0;
  for (int i = 0; i < 11; ++i) {
    EXPECT_EQ(line[4 * static_cast<std::size_t>(i)].arc, start);
    if (i < 10) start += cord.rest_length(i);
  }
}

TEST(SmoothLine, ReadsThePiecesOfACutCord) {
  CordDef def;
  def.points = 21;
  def.length = 2.0;
  const Cord cord(def);
  const auto [first, second] = cut(cord, cut_at(cord, 0.5));
  ASSERT_TRUE(first && second);
  EXPECT_NEAR(line_of(point_grid(*first), 3).back().arc, 0.5, 1e-12);
  EXPECT_NEAR(line_of(point_grid(*second), 3).back().arc, 1.5, 1e-12);
  EXPECT_NEAR(line_of(point_grid(*second), 3).front().position.x, 0.5, 1e-12);
}

TEST(SmoothLine, FollowsEachRowOfTheThesissCord) {
  ThesisDef def;
  def.w = 7;
  def.h = 3;
  const ThesisCord cord(def);
  for (int row = 0; row < 3; ++row) {
    const auto line = line_of(point_grid(cord), 4, row);
    for (std::size_t i = 0; i < 7; ++i) {
      EXPECT_EQ(line[4 * i].position, cord.positions()[3 * i + static_cast<std::size_t>(row)]);
      EXPECT_NEAR(line[4 * i].arc, def.spacing * static_cast<double>(i), 1e-12);
    }
  }
}

TEST(SmoothLine, TwoPointsAreALine) {
  const auto line = line_of({{1.0, 1.0}, {4.0, 5.0}}, 4);
  for (std::size_t k = 0; k <= 4; ++k) {
    const double share = static_cast<double>(k) / 4.0;
    EXPECT_NEAR(length(line[k].position - Vec2{1.0 + 3.0 * share, 1.0 + 4.0 * share}), 0.0, 1e-14);
    EXPECT_NEAR(length(line[k].normal - Vec2{-0.8, 0.6}), 0.0, 1e-14);
    EXPECT_NEAR(line[k].arc, share, 1e-14);
  }
}

/// Points in the same place, as near as numbers can be, and folds are where a division by 0 could be.
TEST(SmoothLine, DegenerateLinesHaveUnitNormals) {
  const double tiny = std::numeric_limits<double>::denorm_min();
  const std::vector<std::vector<Vec2>> lines{
      {{2.0, 2.0}, {2.0, 2.0}},
      {{0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}},
      {{0.0, 0.0}, {0.0, 0.0}, {1.0, 0.0}, {1.0, 0.0}, {1.0, 0.0}, {2.0, 1.0}, {2.0, 1.0}},
      {{0.0, 0.0}, {1.0, 0.0}, {0.0, 0.0}},
      {{0.0, 0.0}, {1.0, 0.0}, {0.0, 0.0}, {1.0, 0.0}, {0.0, 0.0}},
      {{0.0, 0.0}, {tiny, 0.0}, {0.0, tiny}, {1.0, 0.0}},
      {{0.0, 0.0}, {1e-170, 0.0}, {1e-160, 0.0}, {1e-150, 0.0}, {1.0, 0.0}, {1.0, 1e-160}},
      {{1e9, 1e9}, {-1e9, -1e9}, {1e9, -1e9}, {1e9, -1e9}},
      {{1000.0, 0.0}, {0.0, 0.0}, {1e-14, 0.0}},  // the last link is below the resolution of the first point
  };
  for (std::size_t n = 0; n < lines.size(); ++n) {
    SCOPED_TRACE(n);
    for (const int subdivisions : {1, 2, 5}) {
      expect_sound(line_of(lines[n], subdivisions));
      const auto line = line_of(lines[n], subdivisions);
      const auto strip = strip_of({lines[n]}, 0.1, subdivisions);
      for (std::size_t k = 0; k < strip.size(); ++k) {
        const Vec2 middle = line[k / 2].position;
        ASSERT_LE(length(strip[k].position - middle), 0.1415 + 1e-15 * length(middle)) << k;
        ASSERT_GE(length(strip[k].position - middle), 0.0999 - 1e-15 * length(middle)) << k;
      }
    }
  }
}

/// Points at all distances from 1 m down to 0, many of them twice.
TEST(SmoothLine, AnyPointsGiveFiniteNumbers) {
  Dice dice(5);
  for (int trial = 0; trial < 10'000; ++trial) {
    std::vector<Vec2> points;
    const int count = 2 * static_cast<int>(dice(1.0, 5.0));
    while (static_cast<int>(points.size()) < count) {
      const double scale = dice.coin() ? std::pow(10.0, dice(-320.0, 0.0)) : 1.0;
      points.push_back({dice.coin() ? dice(-scale, scale) : 0.0, dice(-scale, scale)});
      if (dice(0.0, 1.0) < 0.3)
        points.back() = points[static_cast<std::size_t>(dice(0.0, 0.99) * trial) % points.size()];
    }
    const auto line = line_of(points, 5);
    const auto rope = strip_of({points}, 0.1, 5);
    expect_sound(line);
    for (std::size_t k = 0; k < rope.size(); ++k) {
      const double distance = length(rope[k].position - line[k / 2].position);
      ASSERT_TRUE(distance > 0.1 - 1e-12 && distance < 0.1 * std::numbers::sqrt2 + 1e-12) << trial << ": " << distance;
    }
    if (count < 4) continue;
    for (const StripVertex& vertex : strip_of({points, 2}, 0.1, 5)) ASSERT_TRUE(is_finite(vertex.position)) << trial;
  }
}

/// A point that is there twice bends nothing: the line passes it straight.
TEST(SmoothLine, AZeroLengthLinkDoesNotBendTheLine) {
  const auto line = line_of({{0.0, 0.0}, {1.0, 0.2}, {1.0, 0.2}, {2.0, 0.0}}, 8);
  const auto without = line_of({{0.0, 0.0}, {1.0, 0.2}, {2.0, 0.0}}, 8);
  for (std::size_t k = 0; k < 8; ++k) EXPECT_EQ(line[k].position, without[k].position) << k;
  for (std::size_t k = 8; k <= 16; ++k) EXPECT_EQ(line[k].position, (Vec2{1.0, 0.2})) << k;
  for (std::size_t k = 17; k < line.size(); ++k) EXPECT_EQ(line[k].position, without[k - 8].position) << k;
  for (std::size_t k = 8; k <= 16; ++k) EXPECT_GT(line[k].normal.y, 0.9) << k;
}

TEST(SmoothLine, HasTheFirstDirectionBeforeItHasALength) {
  for (const LineVertex& vertex : line_of({{0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}, {0.0, 1.0}}, 3)) {
    EXPECT_EQ(vertex.normal, (Vec2{-1.0, 0.0})) << "upwards";
  }
}

TEST(SmoothLine, AllocatesNothing) {
  const Cord rope{CordDef{}};
  const ThesisCord curtain{ThesisDef{}};
  std::array<LineVertex, 401> line;
  std::array<StripVertex, 802> strip;
  const test_support::AllocationCount allocations;
  smooth_line(point_grid(rope), 0, 8, line);
  smooth_strip(point_grid(rope), 0.1, 8, strip);
  smooth_strip(point_grid(curtain), 0.1, 8, strip);
  EXPECT_EQ(allocations.so_far(), 0);
}

TEST(SmoothLine, ReturnsWhatItWrote) {
  const std::vector<Vec2> points = equally_spaced(3, {}, {1.0, 0.0});
  const LineVertex untouched{{7.0, 7.0}, {7.0, 7.0}, 7.0};
  std::vector<LineVertex> line(6, untouched);
  const auto written = smooth_line({points}, 0, 2, line);
  EXPECT_EQ(written.data(), line.data());
  EXPECT_EQ(written.size(), 5U);
  EXPECT_EQ(line[5], untouched);
}

TEST(SmoothLine, RefusesWhatItCannotDraw) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<Vec2> points = equally_spaced(6, {}, {1.0, 0.0});
  std::vector<Vec2> broken = points;
  broken[4].y = nan;
  const std::vector<double> links(4, 1.0);
  const std::vector<double> negative{1.0, 1.0, -1.0, 1.0, 1.0};
  const Cord cord{CordDef{}};
  const StripVertex untouched{{7.0, 7.0}, 7.0, 7.0};
  std::vector<StripVertex> strip(smooth_strip_size(6, 4), untouched);
  const auto said = [&](const PointGrid& grid, double radius, int subdivisions, std::size_t room) {
    return test_support::refusal<DefinitionError>(
        [&] { smooth_strip(grid, radius, subdivisions, std::span(strip).first(room)); });
  };
  using test_support::says;
  EXPECT_TRUE(says(said({points}, 0.1, 4, 41), "vertices.size is 41; accepted is 42 or more"));
  EXPECT_TRUE(says(said({points}, 0.1, 0, 42), "subdivisions is 0; accepted is 1 to 1000"));
  EXPECT_TRUE(says(said({points}, 0.1, 1001, 42), "subdivisions is 1001; accepted is 1 to 1000"));
  EXPECT_TRUE(says(said({points}, nan, 4, 42), "radius is nan; accepted is 0 to 1e+06"));
  EXPECT_TRUE(says(said({points}, infinity, 4, 42), "radius is inf; accepted is 0 to 1e+06"));
  EXPECT_TRUE(says(said({points}, -0.1, 4, 42), "radius is -0.1; accepted is 0 to 1e+06"));
  EXPECT_TRUE(says(said({broken}, 0.1, 4, 42), "positions is (4, nan); accepted are coordinates from"));
  EXPECT_TRUE(says(said({{}}, 0.1, 4, 42), "columns is 0; accepted is 2 to 1e+06"));
  EXPECT_TRUE(says(said({points, 6}, 0.1, 4, 42), "columns is 1; accepted is 2 to 1e+06"));
  EXPECT_TRUE(says(said({points, 4}, 0.1, 4, 42), "positions.size is 6; accepted is a multiple of rows"));
  EXPECT_TRUE(says(said({points, 0}, 0.1, 4, 42), "rows is 0; accepted is 1 to 64"));
  EXPECT_TRUE(says(said({points, 1, RestLengths(links)}, 0.1, 4, 42), "columns is 6; accepted is one more than"));
  EXPECT_TRUE(says(said({points, 1, RestLengths(cord)}, 0.1, 4, 42), "columns is 6; accepted is one more than"));
  EXPECT_TRUE(says(said({points, 1, RestLengths(negative)}, 0.1, 4, 42), "rest length is -1; accepted is 0 to 1e+09"));
  for (const StripVertex& vertex : strip) EXPECT_EQ(vertex, untouched) << "a refusal writes nothing";
  std::vector<LineVertex> line(21);
  EXPECT_THROW(smooth_line({points}, 1, 4, line), DefinitionError);
  EXPECT_THROW(smooth_line({points}, -1, 4, line), DefinitionError);
  EXPECT_THROW((void)smooth_line_size(1, 4), DefinitionError);
  EXPECT_THROW((void)smooth_strip_size(2, 0), DefinitionError);
  EXPECT_EQ(smooth_strip_size(1'000'000, 1000), 1'999'998'002U);
}

}  // namespace
}  // namespace ribbon
