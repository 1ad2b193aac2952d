#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include "tests/extremes/table.h"

// Every length, width, load, stiffness and step.

namespace extremes {
namespace {

using ribbon::Vec2;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double cord_length = 10.0;  // m; the cord weighs 1 kg
constexpr double g = 9.81;            // m/s²
constexpr Vec2 gravity{0.0, -g};

struct Case {
  int points;
  int rows;
  double load;       // kg, of 1 kg of cord
  double stiffness;  // EA / (M·g)
  double dt;         // s
};

std::string text(const Case& c) {
  char line[96];
  std::snprintf(line, sizeof line, "%d x %d, load %g, EA/Mg %g, dt %g", c.points, c.rows, c.load, c.stiffness, c.dt);
  return line;
}

/// Cells are at most 5 cm high, but square for the thesis's method.
ribbon::CordDef cord_of(Method method, const Case& c, Vec2 along) {
  ribbon::CordDef def;
  def.points = c.points;
  def.rows = c.rows;
  def.length = cord_length;
  def.mass_per_length = 1.0 / cord_length;
  def.stretch_stiffness = c.stiffness * (1.0 + c.load) * g;
  const double link = cord_length / (c.points - 1);
  const double height = method == Method::thesis ? link : std::min(link, 0.05);
  if (c.rows > 1) {
    def.width = height * (c.rows - 1);
    def.bending_stiffness = def.stretch_stiffness * def.width * def.width / 12.0;
  }
  for (int i = 0; i < c.points; ++i) {
    for (int j = 0; j < c.rows; ++j) def.positions.push_back((i * link) * along + (j * height) * perp(along));
  }
  for (int j = 0; j < c.rows; ++j) def.pins.push_back(j);
  return def;
}

/// Of a cord that hangs straight down, relative: from (load + cord) · g at its top to load · g at its end.
double exact_stretch(const Case& c) { return (c.load + 0.5) / (1.0 + c.load) / c.stiffness; }

/// Let go from the horizontal. The scale of its energy is M·g·(L + what it is stretched by at rest).
void swing(Method method, const Case& c, int ticks, Worst& gain) {
  Subject cord(method, cord_of(method, c, {1.0, 0.0}), c.dt);
  cord.attach_load(c.load);
  const double scale = (1.0 + c.load) * g * cord_length * (1.0 + 1.0 / c.stiffness);
  const double start = cord.energy(gravity);
  double most = 0.0;
  for (int k = 0; k < ticks && most < infinity; ++k) {
    cord.step(c.dt, gravity);
    most = cord.is_finite() ? std::max(most, (cord.energy(gravity) - start) / scale) : infinity;
  }
  gain.take(most, text(c));
  gain.add(cord.counts());
}

/// How far its stretch is off what it has to be, as a share of that and of a millionth of its length, whichever is
/// more.
double stretch_error(const Subject& cord, const Case& c) {
  const double exact = exact_stretch(c);
  const double error = std::abs(cord.length() / cord_length - 1.0 - exact) / std::max(exact, 1e-6);
  return std::isfinite(error) ? error : infinity;
}

/// Brings it to rest: it is stopped whenever it becomes slower (kinetic relaxation). The direct solver's takes steps of
/// a second by implicit Euler for it.
void come_to_rest(Subject& cord, const Case& c) {
  const bool is_thesis = cord.method() == Method::thesis;
  const double dt = is_thesis ? c.dt : 1.0;
  if (!is_thesis) cord.direct().set_accuracy(ribbon::Accuracy::fast());
  const double calm = 1e-5 * cord_length * std::max(exact_stretch(c), 1e-6);  // m/s
  double before = 0.0;
  for (int k = 0, calm_steps = 0; k < (is_thesis ? 300 : 1000) && calm_steps < 3; ++k) {
    cord.step(dt, gravity);
    const double speed = cord.fastest();
    calm_steps = speed < calm ? calm_steps + 1 : 0;
    if (speed < before) cord.stop();
    before = speed < before ? 0.0 : speed;
  }
  cord.stop();
  if (!is_thesis) cord.direct().set_accuracy(accuracy_of(cord.method()));
}

constexpr std::array<double, 4> steps = {1e-5, 1e-3, 1.0 / 60.0, 1.0};  // s

/// It hangs still in steps of any length.
void hang(Method method, Case c, Worst& off) {
  const auto still = [&](Subject& cord) {
    double error = 0.0;
    for (int k = 0; k < 5; ++k) {
      cord.step(c.dt, gravity);
      error = std::max(error, stretch_error(cord, c));
    }
    off.take(error, text(c));
  };
  if (method == Method::thesis) {  // shorter steps would need hours
    for (const double dt : {steps[2], steps[3]}) {
      c.dt = dt;
      Subject cord(method, cord_of(method, c, {0.0, -1.0}), dt);
      cord.attach_load(c.load);
      come_to_rest(cord, c);
      still(cord);
      off.add(cord.counts());
    }
    return;
  }
  Subject cord(method, cord_of(method, c, {0.0, -1.0}), c.dt);
  cord.attach_load(c.load);
  come_to_rest(cord, c);
  const ribbon::Cord::State rest = cord.direct().save();
  for (const double dt : steps) {
    c.dt = dt;
    cord.direct().restore(rest);
    still(cord);
  }
  off.add(cord.counts());
}

/// All but the step. The thesis's cords have two rows at least, and as long ones take it hours.
std::vector<Case> cases(bool full, Method method) {
  const bool thesis = method == Method::thesis;
  const std::vector<int> lengths = full && !thesis ? std::vector{2, 50, 1000, 5000} : std::vector{2, 50};
  const std::vector<double> loads = full     ? std::vector{0.0, 1.0, 1e3, 1e6}
                                    : thesis ? std::vector{0.0, 1e3}
                                             : std::vector{0.0, 1e3, 1e6};
  const std::vector<double> stiffnesses = full     ? std::vector{1e-3, 1.0, 1e3, 1e6, 1e9, 1e12, infinity}
                                          : thesis ? std::vector{1e-3, 1e3}
                                                   : std::vector{1e-3, 1e3, 1e6, 1e12, infinity};
  std::vector<Case> all;
  for (const int points : lengths) {
    for (const int rows : {1, 2, 5}) {
      if (rows < 2 && thesis) continue;
      for (const double load : loads) {
        for (const double stiffness : stiffnesses) {
          const bool accepted = stiffness == infinity ? rows == 1 : stiffness * (1.0 + load) * g <= 1e18;
          if (accepted) all.push_back({points, rows, load, stiffness, 0.0});
        }
      }
    }
  }
  return all;
}

}  // namespace

std::vector<Row> run_sweep(const Scope& scope) {
  std::vector<Row> rows;
  double methods_done = 0.0;
  for (const Method method : all_methods) {
    const std::vector<Case> all = cases(scope.full, method);
    Worst gain("let go from the horizontal", "energy gained / MgL", method, 1e-6);
    Worst off("hanging at rest", "error of the stretch", method, 0.01);
    double done = 0.0;
    for (Case c : all) {
      for (const double dt : steps) {
        c.dt = dt;
        swing(method, c, scope.full ? 60 : 20, gain);
      }
      hang(method, c, off);
      scope.progress((methods_done + ++done / static_cast<double>(all.size())) / all_methods.size());
    }
    ++methods_done;
    rows.insert(rows.end(), {gain.row(), off.row()});
  }
  return rows;
}

}  // namespace extremes
