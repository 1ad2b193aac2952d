#include <algorithm>
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

/// Cells are at most 5 cm high.
ribbon::CordDef cord_of(const Case& c, Vec2 along) {
  ribbon::CordDef def;
  def.points = c.points;
  def.rows = c.rows;
  def.length = cord_length;
  def.mass_per_length = 1.0 / cord_length;
  def.stretch_stiffness = c.stiffness * (1.0 + c.load) * g;
  const double link = cord_length / (c.points - 1);
  const double height = std::min(link, 0.05);
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

/// Let go from the horizontal.
struct Swing {
  double gain = 0.0;  // of M·g·(L + its own stretch at rest)
  bool finite = true;
  Counts counts;
};

Swing swing(Method method, const Case& c, int ticks) {
  Subject cord(method, cord_of(c, {1.0, 0.0}), c.dt);
  cord.attach_load(c.load);
  Swing swing;
  const double scale = (1.0 + c.load) * g * cord_length * (1.0 + 1.0 / c.stiffness);
  const double start = cord.energy(gravity);
  for (int k = 0; k < ticks && swing.finite; ++k) {
    cord.step(c.dt, gravity);
    swing.finite = cord.is_finite();
    swing.gain = std::max(swing.gain, (cord.energy(gravity) - start) / scale);
  }
  swing.counts = cord.counts();
  return swing;
}

/// How far its stretch is off what it has to be, as a share of that and of a millionth of its length, whichever is
/// more: in a few steps of dt after steps of a second in which it is stopped whenever it becomes slower (kinetic
/// relaxation).
double error_at_rest(Method method, const Case& c, Counts& counts) {
  Subject cord(method, cord_of(c, {0.0, -1.0}), c.dt);
  cord.attach_load(c.load);
  double before = 0.0;
  int stops = 0;
  for (int k = 0; k < 1000 && stops < 12; ++k) {
    cord.step(1.0, gravity);
    const double speed = cord.fastest();
    if (speed < before) {
      cord.stop();
      ++stops;
      before = 0.0;
    } else {
      before = speed;
    }
  }
  cord.stop();
  double worst = 0.0;
  const double exact = exact_stretch(c);
  for (int k = 0; k < 5; ++k) {
    cord.step(c.dt, gravity);
    const double error = std::abs(cord.length() / cord_length - 1.0 - exact) / std::max(exact, 1e-6);
    worst = std::max(worst, std::isfinite(error) ? error : infinity);
  }
  counts += cord.counts();
  return worst;
}

std::vector<Case> cases(bool full, Method method) {
  std::vector<Case> all;
  for (const int points : full ? std::vector{2, 50, 1000, 5000} : std::vector{2, 50}) {
    for (const int rows : {1, 2, 5}) {
      if (method == Method::thesis && rows == 1) continue;  // its ropes are strips of two rows
      for (const double load : {0.0, 1.0, 1e3, 1e6}) {
        for (const double stiffness : {1e-3, 1.0, 1e3, 1e6, 1e9, 1e12, infinity}) {
          if (rows > 1 && stiffness * (1.0 + load) * g > 1e18) continue;  // is refused
          if (rows == 1 && stiffness < infinity && stiffness * (1.0 + load) * g > 1e18) continue;
          for (const double dt : {1e-5, 1e-3, 1.0 / 60.0, 1.0}) all.push_back({points, rows, load, stiffness, dt});
        }
      }
    }
  }
  return all;
}

}  // namespace

std::vector<Row> run_sweep(const Scope& scope) {
  std::vector<Row> rows;
  for (const Method method : all_methods) {
    const std::vector<Case> all = cases(scope.full, method);
    Worst gain("let go from the horizontal", "energy gained / MgL", method, 1e-6);
    Worst off("hanging at rest", "error of the stretch", method, 0.01);
    Worst unconverged("both", "unconverged a step", method, 0.0);
    for (std::size_t k = 0; k < all.size(); ++k) {
      const Swing result = swing(method, all[k], scope.full ? 60 : 30);
      gain.take(result.finite ? result.gain : infinity, text(all[k]));
      gain.add(result.counts);
      Counts counts;
      off.take(error_at_rest(method, all[k], counts), text(all[k]));
      off.add(counts);
      unconverged.take(result.counts.direct.unconverged + counts.direct.unconverged, text(all[k]));
      scope.progress(static_cast<double>(k) / static_cast<double>(all.size()));
      if (getenv("DETAIL")) printf("%s %s gain %g unc %d | rest unc %d steps %ld\n", name(method).data(), text(all[k]).c_str(), result.gain, result.counts.direct.unconverged, counts.direct.unconverged, counts.steps);
    }
    rows.insert(rows.end(), {gain.row(), off.row(), unconverged.row()});
  }
  return rows;
}

}  // namespace extremes
