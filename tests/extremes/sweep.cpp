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
  gain.take(most, text(c), "gains energy");
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
/// a second for it.
void come_to_rest(Subject& cord, const Case& c) {
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

/// It hangs still in steps of this length.
void hang(Subject& cord, const Case& c, Worst& off) {
  double error = 0.0;
  for (int k = 0; k < 5; ++k) {
    cord.step(c.dt, gravity);
    error = std::max(error, stretch_error(cord, c));
  }
  off.take(error, text(c), cord.length() > cord_length * (1.0 + exact_stretch(c)) ? "stretched" : "collapsed");
  off.add(cord.counts());
}

/// The presets rest alike: by the same steps of a second.
void hang_direct(Case c, const Scope& scope, std::array<Worst, 4>& off) {
  Subject resting(Method::fast, cord_of(Method::fast, c, {0.0, -1.0}), 1.0);
  resting.attach_load(c.load);
  come_to_rest(resting, c);
  const ribbon::Cord::State rest = resting.direct().save();
  for (const Method method : {Method::fast, Method::balanced, Method::accurate}) {
    for (const double dt : steps) {
      c.dt = dt;
      if (!scope.wants(text(c))) continue;
      Subject cord(method, cord_of(method, c, {0.0, -1.0}), dt);
      cord.direct().restore(rest);
      hang(cord, c, off[static_cast<std::size_t>(method)]);
    }
  }
}

/// Shorter steps would need hours.
void hang_thesis(Case c, const Scope& scope, Worst& off) {
  for (const double dt : {steps[2], steps[3]}) {
    c.dt = dt;
    if (!scope.wants(text(c))) continue;
    Subject cord(Method::thesis, cord_of(Method::thesis, c, {0.0, -1.0}), dt);
    cord.attach_load(c.load);
    come_to_rest(cord, c);
    hang(cord, c, off);
  }
}

/// Whether the thesis's method has such a case: two rows at least, and not so many points, which take it hours.
bool has_thesis(const Case& c, bool full) {
  return c.rows > 1 && c.points <= 50 && (full || (c.load != 1e6 && (c.stiffness == 1e-3 || c.stiffness == 1e3)));
}

/// Whether it is one of the part that takes seconds.
bool is_short(const Case& c) {
  if (c.load == 1.0 || c.stiffness == 1.0 || c.stiffness == 1e9) return false;
  if (c.points <= 50) return true;
  return c.rows == 1 && c.load != 1e3 && (c.stiffness == 1e3 || c.stiffness == infinity);
}

/// All but the step.
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
  const auto of_all_methods = [](const char* what, const char* figure, double bar) {
    return std::array{Worst(what, figure, Method::fast, bar), Worst(what, figure, Method::balanced, bar),
                      Worst(what, figure, Method::accurate, bar), Worst(what, figure, Method::thesis, bar)};
  };
  std::array<Worst, 4> gain = of_all_methods("let go from the horizontal", "energy gained / MgL", 1e-6);
  std::array<Worst, 4> off = of_all_methods("hanging at rest", "error of the stretch", 0.01);
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
