#include "tests/support/reference_scenes.h"

#include <cmath>
#include <numbers>
#include <span>

#include "tests/support/slot.h"

namespace test_support {
namespace {

using ribbon::Cord;
using ribbon::CordDef;
using ribbon::Vec2;

constexpr double gravity = 9.81;    // m/s²
constexpr double span = 4.0;        // m, of the catenary
constexpr double swing_out = 1e-4;  // m; ten times as much would make the third mode slower by 1e-4

using test_support::slot;

Vec2 at(const Cord& cord, int point) { return cord.positions()[slot(point)]; }

/// Returns the rows of the two middle points of a column; the same one twice if the number of rows is odd.
struct MiddleRows {
  int low, high;
};

MiddleRows middle_rows(const CordDef& def) { return {(def.rows - 1) / 2, def.rows / 2}; }

Vec2 middle(const Cord& cord, int column) {
  const MiddleRows rows = middle_rows(cord.def());
  return 0.5 * (at(cord, cord.index(column, rows.low)) + at(cord, cord.index(column, rows.high)));
}

/// Returns the amplitudes of the points from the pin down. That of the k-th mass from below is the Laguerre polynomial
/// L_k at x = ω²·l/g: k·L_k = (2k − 1 − x)·L_{k−1} − (k − 1)·L_{k−2}.
std::array<double, hanging_masses + 1> mode_shape(int mode) {
  const double omega = hanging_frequencies[slot(mode)];
  const double x = omega * omega / hanging_masses;
  std::array<double, hanging_masses + 1> shape{};
  double value = 1.0;
  double before = 0.0;
  for (int k = 0; k < hanging_masses; ++k) {
    shape[slot(hanging_masses - k)] = value;
    const double next = ((2.0 * k + 1.0 - x) * value - k * before) / (k + 1.0);
    before = value;
    value = next;
  }
  return shape;
}

}  // namespace

void come_to_rest(Cord& cord, Vec2 g, int steps) {
  for (int k = 0; k < steps; ++k) cord.step(1.0, g);
}

/// A slack cord starts as a V, so that no link is compressed; a taut one starts straight.
CordDef hanging_between_pins(const Catenary& catenary, int links) {
  CordDef def;
  def.points = links + 1;
  def.length = catenary.slackness * span;
  def.mass_per_length = 0.5;
  const double weight = def.mass_per_length * def.length * gravity;
  if (catenary.give > 0.0) def.stretch_stiffness = weight / catenary.give;
  const double depth = std::sqrt(std::fmax(0.0, def.length * def.length - span * span)) / 2.0;
  for (int p = 0; p <= links; ++p) {
    const double share = static_cast<double>(p) / links;
    def.positions.push_back({span * share, -depth * (1.0 - std::abs(2.0 * share - 1.0))});
  }
  def.pins = {0, links};
  return def;
}

HangingShape shape_of(const Cord& cord) {
  const int links = cord.def().points - 1;
  const double weight = cord.def().mass_per_length * cord.def().length * gravity;
  const Vec2 link = at(cord, 1) - at(cord, 0);
  const Vec2 pull = (cord.tensions()[0] / length(link)) * link - Vec2{0.0, 0.5 * weight / links};
  return {-at(cord, links / 2).y / span, length(pull) / weight};
}

HangingShape lumped_shape(const Catenary& catenary, int links) {
  // In units of the span and of the weight.
  struct Reach {
    double across, down;
  };
  const auto reach = [&](double h) {
    Reach sum{0.0, 0.0};
    for (int i = 0; i < links; ++i) {
      const double v = 0.5 - (i + 0.5) / links;
      const double tension = std::hypot(h, v);
      const double along = catenary.slackness / links * (1.0 + catenary.give * tension);
      sum.across += along * h / tension;
      if (2 * i < links) sum.down += along * v / tension;
    }
    return sum;
  };
  double low = 0.0;
  double high = 100.0;
  for (int k = 0; k < 200; ++k) {
    const double h = 0.5 * (low + high);
    (reach(h).across < 1.0 ? low : high) = h;
  }
  return {reach(low).down, std::hypot(low, 0.5)};
}

Cord clamped_beam(int columns, int rows, double width, const Cantilever& cantilever, const ribbon::Accuracy& accuracy) {
  CordDef def;
  def.points = columns;
  def.rows = rows;
  def.bending_stiffness = 1.0;
  def.mass_per_length = 0.1;
  def.accuracy = accuracy;
  if (rows == 1) {
    const double link = 1.0 / (columns - 1.5);
    def.length = link * (columns - 1);
    for (int p = 0; p < columns; ++p) def.positions.push_back({(p - 0.5) * link, 0.0});
    def.pins = {0, 1};
  } else {
    def.length = 1.0;
    def.width = width;
    def.stretch_stiffness = 12.0 * def.bending_stiffness / (width * width);
    for (int j = 0; j < rows; ++j) def.pins.push_back(j);
  }
  Cord cord(def);
  const MiddleRows middle = middle_rows(def);
  const int tip_low = cord.index(columns - 1, middle.low);
  const int tip_high = cord.index(columns - 1, middle.high);
  const double load = cantilever.load * def.bending_stiffness;
  for (const int tip : {tip_low, tip_high}) cord.set_load(tip, {0.0, tip_low == tip_high ? -load : -0.5 * load});
  return cord;
}

Cantilever bent(const Cord& cord, double load) {
  const Vec2 tip = middle(cord, cord.def().points - 1);
  return {load, middle(cord, 0).y - tip.y, 1.0 - tip.x};
}

Cord swung_chain(int mode, const ribbon::Accuracy& accuracy) {
  CordDef def;
  def.points = hanging_masses + 1;
  def.length = 1.0;
  def.mass_per_length = 1.0;
  def.accuracy = accuracy;
  def.pins = {0};
  const double link = def.length / hanging_masses;
  double y = 0.0;
  double last = 0.0;
  for (const double share : mode_shape(mode)) {
    const double x = swing_out * share;
    if (!def.positions.empty()) y -= std::sqrt(link * link - (x - last) * (x - last));
    def.positions.push_back({x, y});
    last = x;
  }
  Cord cord(def);
  cord.attach_mass(hanging_masses, 0.5 * def.mass_per_length * link);  // the last point has half a link's
  return cord;
}

double measured_frequency(Cord& chain, int mode, int periods, double dt) {
  const auto shape = mode_shape(mode);
  const auto of_mode = [&](std::span<const Vec2> values) {
    double sum = 0.0;
    for (std::size_t p = 1; p < shape.size(); ++p) sum += shape[p] * values[p].x;
    return sum;
  };
  const double omega = hanging_frequencies[slot(mode)] * std::sqrt(gravity);  // rad/s, for the interpolation of zeros
  double before = of_mode(chain.positions());
  double first = 0.0;
  int zeros = 0;
  constexpr int longest = 1000000;  // a chain that never swings ends too
  for (int k = 1; k < longest; ++k) {
    chain.step(dt, {0.0, -gravity});
    const double now = of_mode(chain.positions());
    if (before * now < 0.0) {
      // x = A·sin(ω(t − zero)), v = A·ω·cos(ω(t − zero))
      const double zero = k * dt - std::atan(omega * now / of_mode(chain.velocities())) / omega;
      if (zeros == 0) first = zero;
      if (zeros == 2 * periods) return 2.0 * std::numbers::pi * periods / (zero - first) / std::sqrt(gravity);
      ++zeros;
    }
    before = now;
  }
  return 0.0;
}

Cord thrown(const CordDef& def, double speed, double heavy_mass) {
  Cord cord(def);
  cord.attach_mass(cord.size() / 2, heavy_mass);
  for (int p = 0; p < cord.size(); ++p) cord.set_velocity(p, {speed * std::sin(3.0 * p), speed * std::cos(5.0 * p)});
  return cord;
}

Vec2 momentum(const Cord& cord) {
  Vec2 sum;
  for (int p = 0; p < cord.size(); ++p) sum += cord.mass(p) * cord.velocities()[slot(p)];
  return sum;
}

}  // namespace test_support
