#include "tests/support/towed_line.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "tests/support/constants.h"
#include "tests/support/points.h"

namespace test_support {
namespace {

using constants::g;
using ribbon::Cord;
using ribbon::CordDef;
using ribbon::Vec2;

CordDef line_def(const ribbon::Accuracy& accuracy, double mass_per_length) {
  CordDef def;
  def.points = 41;
  def.length = 4.0;
  def.mass_per_length = mass_per_length;
  def.drag_across = 1.2;
  def.drag_along = 0.01;
  def.accuracy = accuracy;
  return def;
}

CordDef towed_def(const ribbon::Accuracy& accuracy, bool level) {
  CordDef def = line_def(accuracy, 0.01);
  def.pins = {0};
  if (!level) def.positions = equally_spaced(def.points, {0.0, 0.0}, {0.0, -0.1});
  return def;
}

ribbon::WeatherDef uniform(double speed) {
  ribbon::WeatherDef def;
  def.wind = {speed, 0.0};
  return def;
}

/// N/m at 1 m/s.
double pressure(const CordDef& def) {
  return 0.5 * ribbon::WeatherDef{}.air_density * def.drag_across * 2.0 * def.radius;
}

/// The positive root of R·(1 − c²) = w·c.
Vec2 critical_direction(const CordDef& def, double speed) {
  const double weight = def.mass_per_length * g;
  const double drag = pressure(def) * speed * speed;
  const double c = (std::sqrt(weight * weight + 4.0 * drag * drag) - weight) / (2.0 * drag);
  return {c, -std::sqrt(1.0 - c * c)};
}

}  // namespace

TowedLine::TowedLine(const ribbon::Accuracy& accuracy, double speed, bool level)
    : flow_(uniform(speed)), cord_(towed_def(accuracy, level)), direction_(critical_direction(cord_.def(), speed)) {}

ribbon::IslandReport TowedLine::step() {
  ribbon::Surroundings surroundings;
  surroundings.medium = &flow_;
  surroundings.time = time_;
  time_ += dt;
  return cord_.step(dt, {0.0, -g}, surroundings);
}

double TowedLine::error() const {
  double largest = 0.0;
  for (std::size_t p = 0; p < cord_.positions().size(); ++p) {
    const double arc = cord_.def().length * static_cast<double>(p) / (cord_.def().points - 1.0);
    largest = std::max(largest, length(cord_.positions()[p] - arc * direction_));
  }
  return largest / cord_.def().length;
}

double TowedLine::degrees() const { return std::atan2(-direction_.y, direction_.x) * 180.0 / std::numbers::pi; }

double error_of_a_fall(const ribbon::Accuracy& accuracy) {
  const CordDef def = line_def(accuracy, 0.1);
  const double terminal = std::sqrt(def.mass_per_length * g / pressure(def));
  const ribbon::Weather still{ribbon::WeatherDef{}};
  Cord cord(def);
  double worst = 0.0;
  for (int k = 0; k < 300; ++k) {
    ribbon::Surroundings surroundings;
    surroundings.medium = &still;
    cord.step(TowedLine::dt, {0.0, -g}, surroundings);
    const double expected = terminal * std::tanh(g * (k + 1) * TowedLine::dt / terminal);
    worst = std::max(worst, std::abs(-cord.velocities()[20].y - expected));
  }
  return worst / terminal;
}

}  // namespace test_support
