#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <random>

#include "ribbon/elastic/bends.h"
#include "ribbon/elastic/cells.h"
#include "ribbon/elastic/links.h"
#include "ribbon/elastic/spine.h"

namespace ribbon {
namespace {

/// Every energy, in a random shape: the forces are minus the gradient, the matrix is the derivative of the forces, and
/// neither depends on position and orientation.
struct Case {
  const char* name;
  CordDef def;
  std::unique_ptr<Term> (*make)(const CordDef&);
  double disorder;  // m, maximum displacement of points from their rest positions
};

CordDef rope() {
  CordDef def;
  def.points = 6;
  def.length = 1.5;
  def.stretch_stiffness = 300.0;
  def.bending_stiffness = 2.0;
  return def;
}

CordDef strip(int rows, double area_stiffness) {
  CordDef def;
  def.points = 5;
  def.rows = rows;
  def.length = 1.2;
  def.width = 0.2 * (rows - 1);
  def.stretch_stiffness = 300.0;
  def.bending_stiffness = 0.4;
  def.poisson_ratio = 0.3;
  def.area_stiffness = area_stiffness;
  return def;
}

CordDef bars() {
  CordDef def = strip(3, 0.0);
  def.elements = Elements::bars;
  return def;
}

std::unique_ptr<Term> make_links(const CordDef& def) { return std::make_unique<Links>(def); }
std::unique_ptr<Term> make_bends(const CordDef& def) { return std::make_unique<Bends>(def); }
std::unique_ptr<Term> make_cells(const CordDef& def) { return std::make_unique<Cells>(def, 900.0, 0.4); }
std::unique_ptr<Term> make_spine(const CordDef& def) { return std::make_unique<Spine>(def, 250.0); }

class Terms : public testing::TestWithParam<int> {
 protected:
  static Case the_case(int k) {
    switch (k) {
      case 0: return {"links of a rope", rope(), make_links, 0.03};
      case 1: return {"bends", rope(), make_bends, 0.2};
      case 2: return {"links of a ribbon", bars(), make_links, 0.01};
      case 3: return {"cells", strip(2, 0.0), make_cells, 0.02};
      case 4: return {"spine of odd rows", strip(3, 0.0), make_spine, 0.02};
      case 5: return {"spine of even rows", strip(4, 0.0), make_spine, 0.02};
      default: return {"cells with squashed corners", strip(2, 1.0), make_cells, 0.2};
    }
  }

  Terms() : Terms(0.0) {}
  explicit Terms(double time) : damping(time) {
    tested.def.damping = time;
    term = tested.make(tested.def);
  }

  void SetUp() override {
    SCOPED_TRACE(tested.name);
    std::mt19937 random(7);
    const auto uniform = [&] { return 2.0 * static_cast<double>(random()) / 4294967296.0 - 1.0; };
    const int rows = tested.def.rows;
    const double link = tested.def.length / (tested.def.points - 1);
    // Stretched by a tenth: every tension is positive, and the geometric stiffness is complete.
    for (int i = 0; i < tested.def.points; ++i) {
      for (int j = 0; j < rows; ++j) {
        const Vec2 at{1.1 * link * i, rows > 1 ? 1.1 * tested.def.width * j / (rows - 1) : 0.0};
        here.push_back(at + tested.disorder * Vec2{uniform(), uniform()});
        predicted.push_back(at);
        rates.push_back({uniform(), uniform()});
        direction.push_back({uniform(), uniform()});
      }
    }
    inertia.assign(here.size(), 1.0);
    no_force.resize(here.size());
    constrained.resize(here.size());
    term->set_rest_lengths(std::vector<double>(static_cast<std::size_t>(tested.def.points) - 1, link));
    most.assign(term->tension_count(), 1e9);
  }

  Stage stage() const { return {q, predicted, rates, inertia, no_force, constrained}; }
  std::vector<Vec2> damped(const std::vector<Vec2>& x) const {
    std::vector<Vec2> y;
    for (std::size_t p = 0; p < x.size(); ++p) y.push_back(x[p] + damping * stage().velocity_at(p, x[p]));
    return y;
  }
  Shape shape(const Stage& stage, const std::vector<Vec2>& x, const std::vector<Vec2>& y) const {
    return {stage, x, y, 1.0 + damping / q};
  }

  double potential(const std::vector<Vec2>& x) const {
    const Stage at = stage();
    const std::vector<Vec2> y = damped(x);
    return term->potential(shape(at, x, y), most);
  }
  struct Loaded {
    std::vector<Vec2> force;
    BandedMatrix matrix;
  };
  Loaded load(const std::vector<Vec2>& x, const std::vector<double>& tensions) const {
    const Stage at = stage();
    const std::vector<Vec2> y = damped(x);
    const int n = 2 * static_cast<int>(x.size());
    Loaded out{std::vector<Vec2>(x.size()), BandedMatrix(n, 2 * tested.def.rows + 3)};
    BandedMatrix constant(n, 2 * tested.def.rows + 3);
    term->add_constant(constant);
    out.matrix.set_scaled(constant, 1.0 + damping / q);
    term->load({shape(at, x, y), out.matrix, out.force}, tensions);
    return out;
  }
  /// The tensions at x: those after a step of zero length.
  std::vector<double> tensions(const std::vector<Vec2>& x) const {
    const Stage at = stage();
    const std::vector<Vec2> y = damped(x);
    const std::vector<Vec2> nothing(x.size());
    std::vector<Vec2> force(x.size());
    BandedMatrix matrix(2 * static_cast<int>(x.size()), 2 * tested.def.rows + 3);
    std::vector<double> found(term->tension_count());
    const std::vector<double> before(found.size(), 1.0);
    const NewtonSystem system{shape(at, x, y), matrix, force};
    term->load(system, before);
    term->update(system, before, nothing, found);
    return found;
  }
  /// Expects that force_on returns the forces that a stage is solved with.
  void expect_the_same_force_on_each_point() const {
    const std::vector<double> stretched = tensions(here);
    const std::vector<Vec2> loaded = load(here, stretched).force;
    std::vector<Vec2> velocities;
    for (std::size_t p = 0; p < here.size(); ++p) velocities.push_back(stage().velocity_at(p, here[p]));
    if (damping == 0.0) velocities.clear();
    for (std::size_t p = 0; p < here.size(); ++p) {
      const Vec2 force = term->force_on(p, {here, velocities}, stretched);
      EXPECT_NEAR(length(force - loaded[p]), 0.0, 1e-9 * (1.0 + length(loaded[p]))) << tested.name << ", point " << p;
    }
  }
  std::vector<Vec2> moved(double share) const {
    std::vector<Vec2> there = here;
    for (std::size_t p = 0; p < there.size(); ++p) there[p] += share * direction[p];
    return there;
  }
  static double along(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
    double sum = 0.0;
    for (std::size_t p = 0; p < a.size(); ++p) sum += dot(a[p], b[p]);
    return sum;
  }

  Case tested = the_case(GetParam());
  std::unique_ptr<Term> term;
  double damping;
  double q = 0.01;
  std::vector<Vec2> here, predicted, rates, direction, no_force;
  std::vector<double> inertia, most;
  std::vector<char> constrained;
};

class ExactTerms : public Terms {};

class DampedTerms : public Terms {
 protected:
  DampedTerms() : Terms(0.02) {}
  void SetUp() override {
    Terms::SetUp();
    predicted = here;
    for (Vec2& v : rates) v = 0.01 * v;
  }
};

TEST_P(Terms, ForcesAreMinusTheGradient) {
  constexpr double h = 1e-6;
  const double slope = (potential(moved(h)) - potential(moved(-h))) / (2.0 * h);
  EXPECT_NEAR(-along(load(here, tensions(here)).force, direction), slope, 1e-6 * (1.0 + std::abs(slope)))
      << tested.name;
}

TEST_P(Terms, ForceOnAPointIsThatOfTheStage) { expect_the_same_force_on_each_point(); }

TEST_P(DampedTerms, ForceOnAPointIsThatOfTheStageToo) { expect_the_same_force_on_each_point(); }

TEST_P(ExactTerms, MatrixIsTheDerivativeOfTheForces) {
  constexpr double h = 1e-6;
  const Loaded loaded = load(here, tensions(here));
  const auto plus = load(moved(h), tensions(moved(h))).force;
  const auto minus = load(moved(-h), tensions(moved(-h))).force;
  for (int r = 0; r < loaded.matrix.size(); ++r) {
    double sum = 0.0;
    for (int c = std::max(0, r - loaded.matrix.half_bandwidth());
         c < std::min(loaded.matrix.size(), r + loaded.matrix.half_bandwidth() + 1); ++c) {
      const Vec2 d = direction[static_cast<std::size_t>(c / 2)];
      sum += loaded.matrix.at(r, c) * (c % 2 == 0 ? d.x : d.y);
    }
    const Vec2 change = (-0.5 / h) * (plus[static_cast<std::size_t>(r / 2)] - minus[static_cast<std::size_t>(r / 2)]);
    // The cells of a column share one geometric stiffness, so only a single row of cells is exact.
    EXPECT_NEAR(sum, r % 2 == 0 ? change.x : change.y, 1e-4 * (1.0 + std::abs(sum))) << tested.name << ", row " << r;
  }
}

TEST_P(Terms, MatrixIsPositiveSemidefiniteFromAnyShape) {
  std::mt19937 random(11);
  const auto uniform = [&] { return 2.0 * static_cast<double>(random()) / 4294967296.0 - 1.0; };
  for (int k = 0; k < 100; ++k) {
    for (Vec2& point : here) point = {uniform(), uniform()};
    std::vector<double> any(term->tension_count());
    for (double& tension : any) tension = 1000.0 * uniform();
    const Loaded loaded = load(here, any);
    BandedMatrix shifted = loaded.matrix;
    double largest = 0.0;
    for (int r = 0; r < shifted.size(); ++r) largest = std::max(largest, shifted.at(r, r));
    for (int r = 0; r < shifted.size(); ++r) shifted.row(r)[0] += 1e-9 * largest;
    std::vector<double> b(static_cast<std::size_t>(shifted.size()), 1.0);
    EXPECT_TRUE(BandedLdlt().solve(shifted, b)) << tested.name << ", try " << k;
  }
}

TEST_P(Terms, AreInvariantUnderRotationAndTranslation) {
  const double before = potential(here);
  const Vec2 turn{std::cos(0.7), std::sin(0.7)};
  std::vector<Vec2> elsewhere;
  for (const Vec2 p : here) elsewhere.push_back(p.x * turn + p.y * perp(turn) + Vec2{5.0, -3.0});
  EXPECT_NEAR(potential(elsewhere), before, 1e-9 * (1.0 + before)) << tested.name;
  const auto force = load(here, tensions(here)).force;
  const auto turned = load(elsewhere, tensions(elsewhere)).force;
  Vec2 sum;
  double moment = 0.0;
  for (std::size_t p = 0; p < force.size(); ++p) {
    EXPECT_NEAR(length(turned[p] - (force[p].x * turn + force[p].y * perp(turn))), 0.0, 1e-8) << tested.name;
    sum += force[p];
    moment += cross(here[p], force[p]);
  }
  EXPECT_NEAR(length(sum), 0.0, 1e-9);
  EXPECT_NEAR(moment, 0.0, 1e-9);
}

TEST_P(DampedTerms, ForcesAreMinusTheGradientToo) {
  constexpr double h = 1e-6;
  const double slope = (potential(moved(h)) - potential(moved(-h))) / (2.0 * h);
  const double found = -along(load(here, tensions(here)).force, direction);
  // The direction of a bar's damping force is constant while the bar turns: an error of first order in the rates, which
  // are small.
  EXPECT_NEAR(found, slope, 1e-3 * (1.0 + std::abs(slope))) << tested.name;
}

INSTANTIATE_TEST_SUITE_P(All, Terms, testing::Range(0, 7));
INSTANTIATE_TEST_SUITE_P(All, ExactTerms, testing::Range(0, 6));  // the last's is that of Gauss and Newton
INSTANTIATE_TEST_SUITE_P(All, DampedTerms, testing::Range(0, 6));

}  // namespace
}  // namespace ribbon
