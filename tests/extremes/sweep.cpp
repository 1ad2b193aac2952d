#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "tests/extremes/table.h"
#include "tests/support/constants.h"

// All combinations of length, width, load, stiffness and step.

namespace extremes {
namespace {

using constants::infinity;
using ribbon::Vec2;
constexpr double cord_length = 10.0;  // m; the cord weighs 1 kg
using constants::g;
using constants::gravity;

struct Case {
  int points;
  int rows;
  double load;       // kg, for a cord of 1 kg
  double stiffness;  // EA / (M·g)
  double dt;         // s
};

std::string text(const Case& c) {
  char line[96];
  std::snprintf(line, sizeof line, "%d x %d, load %g, EA/Mg %g, dt %g", c.points, c.rows, c.load, c.stiffness, c.dt);
  return line;
}

/// Returns a cord with cells at most 5 cm high; cells are square for the thesis's method.
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

/// Relative stretch of a hanging cord. The tension falls from (load + cord) · g at its top to load · g at its end.
double exact_stretch(const Case& c) { return (c.load + 0.5) / (1.0 + c.load) / c.stiffness; }

/// Swings the cord from the horizontal. The energy's scale is M·g·(L + static stretch).
void swing(Method method, const Case& c, int ticks, WorstCase& gain) {
  TestedCord cord(method, cord_of(method, c, {1.0, 0.0}), c.dt);
  cord.attach_load(c.load);
  const double scale = (1.0 + c.load) * g * cord_length * (1.0 + 1.0 / c.stiffness);
  const double start = cord.energy(gravity);
  double most = 0.0;
  for (int k = 0; k < ticks && most < infinity; ++k) {
    cord.step(c.dt, gravity);
    most = cord.is_finite() ? std::max(most, (cord.energy(gravity) - start) / scale) : infinity;
  }
  gain.take(most, text(c), "gains energy");
  gain.add(cord.counts());
}

/// Returns the error of the stretch, divided by the exact stretch or by a millionth of the length, whichever is
/// greater.
double stretch_error(const TestedCord& cord, const Case& c) {
  const double exact = exact_stretch(c);
  const double error = std::abs(cord.length() / cord_length - 1.0 - exact) / std::max(exact, 1e-6);
  return std::isfinite(error) ? error : infinity;
}

/// Brings the cord to rest by kinetic relaxation: sets velocities to zero when the cord slows down. The direct solver
/// uses steps of a second.
void come_to_rest(TestedCord& cord, const Case& c) {
  const bool is_thesis = cord.method() == Method::thesis;
  const double dt = is_thesis ? c.dt : 1.0;
  const double rest_speed = 1e-5 * cord_length * std::max(exact_stretch(c), 1e-6);  // m/s
  double before = 0.0;
  for (int k = 0, steps_at_rest = 0; k < (is_thesis ? 300 : 1000) && steps_at_rest < 3; ++k) {
    cord.step(dt, gravity);
    const double speed = cord.fastest();
    steps_at_rest = speed < rest_speed ? steps_at_rest + 1 : 0;
    if (speed < before) cord.stop();
    before = speed < before ? 0.0 : speed;
  }
  cord.stop();
}

constexpr std::array<double, 4> steps = {1e-5, 1e-3, 1.0 / 60.0, 1.0};  // s

/// Checks that the cord hangs still in steps of this length.
void hang(TestedCord& cord, const Case& c, WorstCase& off) {
  double error = 0.0;
  for (int k = 0; k < 5; ++k) {
    cord.step(c.dt, gravity);
    error = std::max(error, stretch_error(cord, c));
  }
  off.take(error, text(c), cord.length() > cord_length * (1.0 + exact_stretch(c)) ? "stretched" : "collapsed");
  off.add(cord.counts());
}

/// All presets start from the same rest state, found in steps of a second.
void hang_direct(Case c, const Scope& scope, std::array<WorstCase, 4>& off) {
  TestedCord resting(Method::fast, cord_of(Method::fast, c, {0.0, -1.0}), 1.0);
  resting.attach_load(c.load);
  come_to_rest(resting, c);
  const ribbon::Cord::State rest = resting.direct().save();
  for (const Method method : {Method::fast, Method::balanced, Method::accurate}) {
    for (const double dt : steps) {
      c.dt = dt;
      if (!scope.wants(text(c))) continue;
      TestedCord cord(method, cord_of(method, c, {0.0, -1.0}), dt);
      cord.direct().restore(rest);
      hang(cord, c, off[static_cast<std::size_t>(method)]);
    }
  }
}

/// Omits shorter steps, which would take hours.
void hang_thesis(Case c, const Scope& scope, WorstCase& off) {
  for (const double dt : {steps[2], steps[3]}) {
    c.dt = dt;
    if (!scope.wants(text(c))) continue;
    TestedCord cord(Method::thesis, cord_of(Method::thesis, c, {0.0, -1.0}), dt);
    cord.attach_load(c.load);
    come_to_rest(cord, c);
    hang(cord, c, off);
  }
}

/// Returns whether the thesis's method runs this case: at least two rows, and at most 50 points to limit the time.
bool has_thesis(const Case& c, bool full) {
  return c.rows > 1 && c.points <= 50 && (full || (c.load != 1e6 && (c.stiffness == 1e-3 || c.stiffness == 1e3)));
}

/// Returns whether the case is in the part that takes seconds.
bool is_short(const Case& c) {
  if (c.load == 1.0 || c.stiffness == 1.0 || c.stiffness == 1e9) return false;
  if (c.points <= 50) return true;
  return c.rows == 1 && c.load != 1e3 && (c.stiffness == 1e3 || c.stiffness == infinity);
}

/// Returns all cases, without the step.
std::vector<Case> cases(bool full) {
  std::vector<Case> all;
  for (const int points : {2, 50, 1000, 5000}) {
    for (const int rows : {1, 2, 5}) {
      for (const double load : {0.0, 1.0, 1e3, 1e6}) {
        for (const double stiffness : {1e-3, 1.0, 1e3, 1e6, 1e9, 1e12, infinity}) {
          const bool accepted = stiffness == infinity ? rows == 1 : stiffness * (1.0 + load) * g <= 1e18;
          const Case c{points, rows, load, stiffness, 0.0};
          if (accepted && (full || is_short(c))) all.push_back(c);
        }
      }
    }
  }
  return all;
}

}  // namespace

std::vector<Row> run_sweep(const Scope& scope) {
  const auto of_all_methods = [](const char* what, const char* figure, double limit) {
    return std::array{WorstCase(what, figure, Method::fast, limit), WorstCase(what, figure, Method::balanced, limit),
                      WorstCase(what, figure, Method::accurate, limit), WorstCase(what, figure, Method::thesis, limit)};
  };
  std::array<WorstCase, 4> gain = of_all_methods("let go from the horizontal", "energy gained / MgL", 1e-6);
  std::array<WorstCase, 4> off = of_all_methods("hanging at rest", "error of the stretch", 0.01);
  const std::vector<Case> all = cases(scope.full);
  double done = 0.0;
  for (Case c : all) {
    bool wanted = false;
    for (const double dt : steps) {
      c.dt = dt;
      if (!scope.wants(text(c))) continue;
      wanted = true;
      for (const Method method : all_methods) {
        if (method == Method::thesis && !has_thesis(c, scope.full)) continue;
        swing(method, c, scope.full ? 60 : 20, gain[static_cast<std::size_t>(method)]);
      }
    }
    if (wanted) hang_direct(c, scope, off);
    if (wanted && has_thesis(c, scope.full)) hang_thesis(c, scope, off[static_cast<std::size_t>(Method::thesis)]);
    scope.progress(++done / static_cast<double>(all.size()));
  }
  std::vector<Row> rows;
  for (const Method method : all_methods) {
    const auto k = static_cast<std::size_t>(method);
    rows.insert(rows.end(), {gain[k].row(), off[k].row()});
  }
  return rows;
}

}  // namespace extremes
