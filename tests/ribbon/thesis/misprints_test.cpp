// The misprints of Goto 2017, one by one, so that no later change restores them. Each test runs the printed form and
// the form in ribbon/.

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "ribbon/thesis/contact.h"
#include "ribbon/thesis/corrections.h"
#include "ribbon/thesis/mesh.h"
#include "tests/support/dense.h"
#include "tests/support/thesis_scenes.h"

namespace ribbon {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using test_support::earth_gravity;
using test_support::eigenvalues;
using test_support::frame_dt;
using test_support::thesis_conditions;

/// The global matrix M1 of Eqs. 3.12–3.14 for bars of stiffness k.
MatrixXd global_matrix(const std::vector<Connection>& bars, const std::vector<Vec2>& x, double k) {
  MatrixXd m = MatrixXd::Zero(static_cast<Eigen::Index>(2 * x.size()), static_cast<Eigen::Index>(2 * x.size()));
  for (const Connection& bar : bars) {
    const Vec2 ab = x[static_cast<std::size_t>(bar.b)] - x[static_cast<std::size_t>(bar.a)];
    const Eigen::Vector2d d = Eigen::Vector2d(ab.x, ab.y).normalized();
    const Eigen::Matrix2d block = k * d * d.transpose();
    const Eigen::Index a = 2 * bar.a;
    const Eigen::Index b = 2 * bar.b;
    m.block<2, 2>(a, a) += block;
    m.block<2, 2>(b, b) += block;
    m.block<2, 2>(a, b) -= block;
    m.block<2, 2>(b, a) -= block;
  }
  return m;
}

/// A cord of 8 × 2 points whose first two are constrained, which come first: c = 0 … 3, f = 4 … 31.
struct Pinned {
  Mesh mesh = make_mesh(8, 2, 0.05);
  std::vector<Vec2> x = lay_along(std::array{Vec2{0.0, 0.0}, Vec2{1.0, 0.0}}, 8, 2, 0.05);
  Eigen::Index constrained = 4;
  Eigen::Index all = 32;

  /// M2 of Eq. 3.15: rows and columns of constrained points zeroed, their diagonal set to 1.
  MatrixXd m2(double k) const {
    MatrixXd m = global_matrix(mesh.connections, x, k);
    m.topRows(constrained).setZero();
    m.leftCols(constrained).setZero();
    m.topLeftCorner(constrained, constrained).setIdentity();
    return m;
  }

  /// U′ of Eqs. 3.17 and 3.18, with the printed sign (+1) or the restoring one (−1).
  VectorXd moved(const VectorXd& u, double k, double sign) const {
    VectorXd f2 = sign * global_matrix(mesh.connections, x, k) * u;
    f2.head(constrained).setZero();
    return test_support::solve_dense(m2(k), f2);
  }
};

TEST(Misprint1Sign, TheFreeDisplacementDoublesEveryIteration) {
  const Pinned cord;
  VectorXd u = 1e-3 * VectorXd::Random(cord.all);
  u.head(cord.constrained).setZero();
  const VectorXd start = u;
  for (int iteration = 0; iteration < 8; ++iteration) u += cord.moved(u, 100.0, +1.0);
  EXPECT_NEAR((u - 256.0 * start).norm() / u.norm(), 0.0, 1e-9);
}

TEST(Misprint1Sign, ADraggedAnchorPushesItsNeighboursTheOtherWay) {
  const Pinned cord;
  VectorXd u = VectorXd::Zero(cord.all);
  u(1) = u(3) = 0.01;  // both anchors go up
  const Eigen::Index neighbour_y = cord.constrained + 1;
  EXPECT_LT(cord.moved(u, 100.0, +1.0)(neighbour_y), -0.005);
  EXPECT_GT(cord.moved(u, 100.0, -1.0)(neighbour_y), 0.005);

  ThesisDef def = test_support::thesis_def(thesis_conditions[0]);
  def.spring_stiffness = 0.0;  // the FEM alone
  def.pins = {0, 1};
  ThesisCord ours(def);
  for (const int p : {0, 1}) ours.constrain(p, ours.positions()[static_cast<std::size_t>(p)] + Vec2{0.0, 0.01});
  const Vec2 before = ours.positions()[2];
  ours.step(frame_dt, {});
  EXPECT_GT(ours.positions()[2].y - before.y, 0.002);
}

TEST(Misprint2Inertia, WithTheSignAloneCorrectedNothingMovesAndStiffnessCancels) {
  const Pinned cord;
  VectorXd fall = VectorXd::Zero(cord.all);
  for (Eigen::Index k = cord.constrained + 1; k < cord.all; k += 2) fall(k) = -0.02;
  for (const double k : {1.0, 1000.0}) {
    const VectorXd end = fall + cord.moved(fall, k, -1.0);
    EXPECT_NEAR(end.norm(), 0.0, 1e-12);  // P′ = R: the fall is cancelled for every stiffness
  }
  ThesisCord ours(test_support::hanging(thesis_conditions[0]));
  ours.release(0);
  ours.release(1);
  ours.step(frame_dt, earth_gravity);
  EXPECT_LT(ours.positions()[20].y, -0.5 * 9.81 * frame_dt * frame_dt);
}

TEST(LongMisprint2Inertia, TheRepairedFemAloneIsADamperAndPoursLikeAFluid) {
  ThesisDef def = test_support::hanging(thesis_conditions[0]);
  def.spring_stiffness = 0.0;
  def.area_stiffness = 0.0;
  def.self_collision = false;
  ThesisCord cord(def);
  for (int frame = 0; frame < 20 * 60; ++frame) cord.step(frame_dt, earth_gravity);
  EXPECT_GT(test_support::length_ratio(cord), 10.0);
}

TEST(Misprint3UnitDiagonal, SpoilsTheConditioning) {
  const Pinned cord;
  const double k = 1e6;
  const auto condition = [](const MatrixXd& m) {
    const VectorXd values = eigenvalues(m);
    return values.maxCoeff() / values.minCoeff();
  };
  MatrixXd own_diagonal = cord.m2(k);
  for (Eigen::Index i = 0; i < cord.constrained; ++i) {
    own_diagonal(i, i) = global_matrix(cord.mesh.connections, cord.x, k)(i, i);
  }
  EXPECT_GT(condition(cord.m2(k)), 100.0 * condition(own_diagonal));
}

TEST(Misprint4Singular, AStraightSingleRowAndTooFewPinsHaveNoInverse) {
  const auto smallest = [](const MatrixXd& m) { return eigenvalues(m)(0); };
  std::vector<Connection> chain;
  std::vector<Vec2> line;
  for (int p = 0; p < 6; ++p) {
    line.push_back({0.1 * p, 0.0});
    if (p > 0) chain.push_back({p - 1, p, 0.1});
  }
  // One row with its first point constrained has no stiffness across the chain.
  EXPECT_NEAR(smallest(global_matrix(chain, line, 1.0).bottomRightCorner(10, 10)), 0.0, 1e-14);

  const Pinned ribbon;
  const MatrixXd whole = global_matrix(ribbon.mesh.connections, ribbon.x, 1.0);
  EXPECT_NEAR(smallest(whole.bottomRightCorner(30, 30)), 0.0, 1e-14);  // one pin: the cord turns about it
  EXPECT_GT(smallest(whole.bottomRightCorner(28, 28)), 1e-5);          // two pins

  // With the inertia in the matrix both have a solution, pinned or not.
  for (int pins = 0; pins <= 2; ++pins) {
    ThesisDef def = test_support::thesis_def(thesis_conditions[0]);
    for (int p = 0; p < pins; ++p) def.pins.push_back(p);
    ThesisCord cord(def);
    for (int frame = 0; frame < 30; ++frame) EXPECT_EQ(cord.step(frame_dt, earth_gravity).fem_skipped, 0);
  }
}

TEST(Misprint5Springs, UnnormalisedTheyDivergeWhereCoefficientTimesSpacingExceedsTwo) {
  // Eq. 3.20 on one spring: U_a = ½·k·(d − |ab|)·(P_a − P_b), and the opposite for b.
  const auto stretch_after = [](double k, double rest, double stretch) {
    Vec2 a{0.0, 0.0};
    Vec2 b{rest * (1.0 + stretch), 0.0};
    for (int n = 0; n < 12; ++n) {
      const Vec2 u = (0.5 * k * (rest - length(b - a))) * (a - b);
      a += u;
      b -= u;
    }
    return std::abs(length(b - a) / rest - 1.0);
  };
  EXPECT_LT(stretch_after(0.45, 1.0, 0.01), 0.01);
  EXPECT_GT(stretch_after(2.2, 1.0, 0.01), 0.05);   // k·spacing = 2.2
  EXPECT_GT(stretch_after(22.0, 0.1, 0.01), 0.05);  // so k is a stiffness per length
}

TEST(Misprint5Springs, EqualSharesMoveAHeavyLoadAndLoseMomentum) {
  const Vec2 a{0.0, 0.0};  // 1 kg
  const Vec2 b{0.0, 1.5};  // 1000 kg
  const Vec2 u = (0.5 * 0.45 * (1.0 - length(b - a))) * (a - b);
  EXPECT_GT(length(1.0 * u - 1000.0 * u), 100.0);  // Σ m·Δx, kg·m

  std::vector<Vec2> x = {a, b};
  correct_springs(std::vector<Connection>{{0, 1, 1.0}}, 1e3, 0.1, std::vector<double>{1.0, 0.001}, x);
  EXPECT_NEAR(length(1.0 * (x[0] - a) + 1000.0 * (x[1] - b)), 0.0, 1e-12);
}

TEST(Misprint5Springs, AFixedCoefficientTurnsTheCordStifferWithEveryIteration) {
  // Same stretch, same time: a fixed k leaves (1 − k)^N of it; ribbon/ leaves the same fraction for every N.
  const auto left_fixed = [](int n) { return std::pow(1.0 - 0.45, n); };
  EXPECT_LT(left_fixed(32), 1e-6 * left_fixed(4));

  const auto hanging_stretch = [](int substeps) {
    ThesisDef def = test_support::hanging(thesis_conditions[0]);
    def.substeps = substeps;
    ThesisCord cord(def);
    for (int frame = 0; frame < 900; ++frame) cord.step(frame_dt, earth_gravity);
    return test_support::length_ratio(cord) - 1.0;
  };
  EXPECT_NEAR(hanging_stretch(32) / hanging_stretch(16), 1.0, 0.1);  // it converges
}

/// Eq. 3.20 summed over all neighbours at once (Jacobi), normalised, without FEM, with `share` in place of the printed
/// ½. Returns the frame in which it becomes unstable, or −1.
int frame_of_explosion(const test_support::ThesisCondition& condition, double share) {
  const ThesisDef def = test_support::hanging(condition);
  const Mesh mesh = make_mesh(def.w, def.h, def.spacing);
  std::vector<Vec2> x = def.positions;
  std::vector<Vec2> before = x;
  const double dt = frame_dt / condition.substeps;
  for (int frame = 1; frame <= 1000; ++frame) {
    for (int iteration = 0; iteration < condition.substeps; ++iteration) {
      const std::vector<Vec2> r = x;
      for (std::size_t p = 2; p < x.size(); ++p) x[p] += (x[p] - before[p]) + (dt * dt) * earth_gravity;
      std::vector<Vec2> u(x.size());
      for (const Connection& bar : mesh.connections) {
        const auto a = static_cast<std::size_t>(bar.a);
        const auto b = static_cast<std::size_t>(bar.b);
        const double now = length(x[b] - x[a]);
        const Vec2 pull = (share * condition.printed_k * (now - bar.rest_length) / now) * (x[b] - x[a]);
        u[a] += pull;
        u[b] -= pull;
      }
      for (std::size_t p = static_cast<std::size_t>(def.h); p < x.size(); ++p) x[p] += u[p];
      for (std::size_t p = 0; p < static_cast<std::size_t>(def.h); ++p) x[p] = def.positions[p];
      before = r;
    }
    if (!is_finite(x.back()) || length(x.back()) > 100.0 * def.w * def.spacing) return frame;
  }
  return -1;
}

/// With the printed ½ the wide cord B is unstable at once. Cords of two rows have fewer neighbours per point and stay
/// stable with ½, but not with 1, which a relaxed k means if each end takes its whole share.
TEST(Misprint5Springs, SummedAtOnceTheyExplode) {
  EXPECT_GT(frame_of_explosion(thesis_conditions[1], 0.5), 0);
  for (const auto& condition : thesis_conditions) {
    EXPECT_GT(frame_of_explosion(condition, 1.0), 0) << condition.name;

    ThesisDef one_by_one = test_support::hanging(condition);
    one_by_one.bar_damping = 0.0;
    one_by_one.spring_stiffness *= 1e6;  // a share of 1 each
    ThesisCord cord(one_by_one);
    for (int frame = 0; frame < 1000; ++frame) cord.step(frame_dt, earth_gravity);
    EXPECT_LT(test_support::worst_stretch(cord), 0.3) << condition.name;
  }
}

TEST(Misprint6ContactSign, PushesThePairDeeperAndTheHeavierSideFurther) {
  // A circle of radius 1 and 3 kg, with its centre 0.6 above a point of 1 kg that represents the triangle: d points up.
  const double r = 1.0;
  const double distance = 0.6;
  const double m_c = 3.0;
  const double m_t = 1.0;
  const double i = distance - r;              // 3.24: −0.4
  const double n_c = m_c / (m_c + m_t) * i;   // 3.26: the circle goes down,
  const double n_t = -m_t / (m_c + m_t) * i;  // 3.27: and the triangle up
  EXPECT_LT(distance + n_c - n_t, distance);
  EXPECT_GT(std::abs(n_c), std::abs(n_t));

  const Contact contact{{0.0, 1.0}, r - distance, {0, 0, 0}, {1.0, 0.0, 0.0}};
  std::vector<Vec2> triangle = {{0.0, 0.0}};
  const double lambda = push_apart(contact, 1.0 / m_c, r, std::vector<double>{1.0 / m_t}, triangle);
  const double circle = distance + lambda / m_c;
  EXPECT_NEAR(circle - triangle[0].y, r, 1e-15);
  EXPECT_LT(circle - distance, -triangle[0].y);  // the lighter side moves more
}

TEST(Misprint7Inside, ACentreInsideATriangleHasNoDirection) {
  const Mesh mesh = make_mesh(6, 2, 1.0);
  const std::vector<Vec2> x = lay_along(std::array{Vec2{0.0, 0.0}, Vec2{1.0, 0.0}}, 6, 2, 1.0);
  const Vec2 c{2.7, 0.1};
  const Vec2 t_c = c;  // the nearest point of the triangle that contains c
  const double size = length(c - t_c);
  EXPECT_TRUE(std::isnan((c - t_c).x / size));
  int inside = 0;
  for (const Triangle& triangle : mesh.triangles) {
    const auto contact = find_contact(mesh, triangle, x, {c, c, 0.3});
    if (!contact) continue;
    ++inside;
    EXPECT_NEAR(length(contact->direction), 1.0, 1e-15);
    EXPECT_GT(contact->depth, 0.0);
  }
  EXPECT_GT(inside, 0);
}

TEST(Misprint8Memory, LengthsAloneAcceptAMirroredCord) {
  const Mesh mesh = make_mesh(6, 2, 1.0);
  std::vector<Vec2> x = lay_along(std::array{Vec2{0.0, 0.0}, Vec2{1.0, 0.0}}, 6, 2, 1.0);
  for (Vec2& p : x) p.y = -p.y;
  const std::vector<Vec2> mirrored = x;
  const std::vector<double> w(x.size(), 1.0);
  correct_springs(mesh.connections, 1e3, 0.1, w, x);
  for (std::size_t p = 0; p < x.size(); ++p) EXPECT_NEAR(length(x[p] - mirrored[p]), 0.0, 1e-14);
  correct_areas(mesh.triangles, 0.3, 0.5, w, x);  // the correction that the thesis asks for reacts
  EXPECT_NE(x, mirrored);
}

TEST(LongMisprint8Damping, NothingOfTheThesisDampsASwing) {
  const auto amplitude_after = [](double drag) {
    ThesisDef def = test_support::thesis_def(thesis_conditions[0]);
    def.drag = drag;
    def.pins = {0, 1};
    ThesisCord cord(def);
    double widest = 0.0;
    for (int frame = 0; frame < 60 * 20; ++frame) {
      cord.step(frame_dt, earth_gravity);
      if (frame > 60 * 16) widest = std::max(widest, std::abs(cord.positions().back().x));
    }
    return widest;
  };
  EXPECT_GT(amplitude_after(0.0), 0.4);  // a third of its 1.2 m, after twenty seconds
  EXPECT_LT(amplitude_after(1.0), 0.5 * amplitude_after(0.0));
}

}  // namespace
}  // namespace ribbon
