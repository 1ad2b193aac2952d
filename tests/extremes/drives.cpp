#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "tests/extremes/table.h"
#include "tests/support/constants.h"

// Anchors, rest lengths and gravity that change more abruptly than in any level.

namespace extremes {
namespace {

using constants::dt;
using constants::infinity;
using ribbon::Vec2;
constexpr double cord_length = 5.0;
constexpr Vec2 earth{0.0, -9.81};
/// The energy that the solver's energy guard may return, divided by M·g·L; see ribbon's README.
constexpr double guarded_gain = 5e-4;

enum class Kind : unsigned char { rope, elastic, pulling, bending, ribbon };
constexpr Kind all_kinds[] = {Kind::rope, Kind::elastic, Kind::pulling, Kind::bending, Kind::ribbon};

std::string name(Kind kind) {
  constexpr const char* names[] = {"rope", "elastic rope", "rope that cannot push", "bending rope", "ribbon"};
  return names[static_cast<std::size_t>(kind)];
}

/// Returns a cord of 1 kg that hangs straight down from its first column, with ten times its weight at its end.
ribbon::CordDef cord_of(Kind kind) {
  ribbon::CordDef def;
  def.points = 26;
  def.rows = kind == Kind::ribbon ? 3 : 1;
  def.length = cord_length;
  def.mass_per_length = 1.0 / cord_length;
  def.tension_only = kind == Kind::pulling;
  if (kind == Kind::elastic || kind == Kind::pulling) def.stretch_stiffness = 1e5;
  if (kind == Kind::bending) def.bending_stiffness = 0.1;
  if (kind == Kind::ribbon) {
    def.width = 0.4;
    ribbon::solid(1e7, 0.0, 0.05, def.width).apply_to(def);
    def.area_stiffness = 1.0;
  }
  for (int i = 0; i < def.points; ++i) {
    for (int j = 0; j < def.rows; ++j) def.positions.push_back({0.2 * j, -0.2 * i});
  }
  for (int j = 0; j < def.rows; ++j) def.pins.push_back(j);
  return def;
}

/// A drive of a cord, called before each tick. It drives the cord and sets gravity; it returns false at its end.
struct Event {
  std::string what;
  std::function<bool(TestedCord&, int tick, Vec2& gravity)> drive;
};

void move_anchor(TestedCord& cord, Vec2 by) {
  for (int j = 0; j < cord.rows(); ++j) cord.operate(j, cord.positions()[static_cast<std::size_t>(j)] + by);
}

Event yank() {
  return {"anchor yanked at 100 m/s", [](TestedCord& cord, int tick, Vec2&) {
            constexpr Vec2 ways[] = {{1.0, 0.0}, {-0.6, 0.8}, {0.0, -1.0}, {-0.8, 0.6}};
            move_anchor(cord, (100.0 * dt) * ways[tick / 10 % 4]);
            return tick < 39;
          }};
}

Event teleport() {
  return {"anchor put a kilometre away", [](TestedCord& cord, int, Vec2&) {
            move_anchor(cord, {800.0, 600.0});
            return false;
          }};
}

Event gravity_of(const std::string& what, Vec2 gravity) {
  return {what, [gravity](TestedCord&, int tick, Vec2& now) {
            now = gravity;
            return tick < 60;
          }};
}

Event reel() {
  return {"reeled to 1 % and back", [](TestedCord& cord, int tick, Vec2&) {
            if (tick == 0) cord.direct().reel(0, cord.columns() - 1, 0.01 * cord_length, 10.0);
            if (tick == 60) cord.direct().reel(0, cord.columns() - 1, cord_length, 10.0);
            return tick < 120;
          }};
}

/// Runs the event, then two seconds without a drive under the initial gravity, then two seconds of damped motion.
void run(Method method, Kind kind, const Event& event, WorstCase& gain, WorstCase& strain) {
  TestedCord cord(method, cord_of(kind), dt);
  cord.attach_load(10.0);
  const double scale = 11.0 * 9.81 * cord_length;
  bool finite = true;
  Vec2 gravity = earth;
  const auto step = [&] {
    cord.step(dt, gravity);
    finite = finite && cord.is_finite();
  };
  for (int tick = 0; event.drive(cord, tick, gravity) && finite; ++tick) step();
  step();
  gravity = earth;
  const double start = cord.energy(gravity);
  double most = 0.0;
  for (int k = 0; k < 120 && finite; ++k) {
    step();
    most = std::max(most, (cord.energy(gravity) - start) / std::max(scale, std::abs(start)));
  }
  gain.take(finite ? most : infinity, name(kind), "gains energy");
  for (int k = 0; k < 240 && finite; ++k) {
    for (int p = 0; p < cord.columns() * cord.rows(); ++p) {
      cord.set_velocity(p, 0.9 * cord.velocities()[static_cast<std::size_t>(p)]);
    }
    step();
  }
  strain.take(finite ? cord.worst_strain(kind == Kind::pulling) : infinity, name(kind), cord.shape());
  for (WorstCase* figure : {&gain, &strain}) figure->add(cord.counts());
}

}  // namespace

std::vector<Row> run_drives(const Scope& scope) {
  const std::vector<Event> events = {yank(),
                                     teleport(),
                                     reel(),
                                     gravity_of("gravity times 100", 100.0 * earth),
                                     gravity_of("gravity turned over", -1.0 * earth),
                                     gravity_of("gravity set to 0", {})};
  std::vector<Row> rows;
  double done = 0.0;
  for (const Method method : all_methods) {
    for (const Event& event : events) {
      if (method == Method::thesis && event.what.starts_with("reel")) continue;  // that method has no reel
      WorstCase gain(event.what, "energy gained after / MgL", method, guarded_gain);
      WorstCase strain(event.what, "strain at the end", method, method == Method::thesis ? 0.1 : 0.01);
      for (const Kind kind : all_kinds) {
        if (method == Method::thesis && kind != Kind::rope && kind != Kind::ribbon) continue;
        if (scope.wants(name(kind))) run(method, kind, event, gain, strain);
      }
      rows.insert(rows.end(), {gain.row(), strain.row()});
      scope.progress(++done / (4.0 * static_cast<double>(events.size())));
    }
  }
  return rows;
}

}  // namespace extremes
