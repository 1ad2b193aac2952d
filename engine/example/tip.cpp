// A cord without Box2D and without a window. It swings for two seconds with a weight at its end; the program prints the
// position of its tip. Links only ribbon::ribbon.
#include <cstdio>
#include <exception>

#include "ribbon/cord.h"
#include "ribbon/layout.h"

namespace {

void print_tip(const ribbon::Cord& cord, int tick) {
  const ribbon::Vec2 tip = cord.positions().back();  // m, positions by point, in the order of the path
  std::printf("%.1f s: tip at (%.4f, %.4f) m\n", tick / 60.0, tip.x, tip.y);
}

void swing() {
  ribbon::CordDef def;                          // by default an inextensible rope
  def.points = 41;                              // more points bend more smoothly; the cost is O(points)
  def.mass_per_length = 0.2;                    // kg/m
  def.accuracy = ribbon::Accuracy::balanced();  // fast, balanced, accurate, or your own values
  def.pins = {0};                               // the first point is fixed
  ribbon::lay_along(def, {{0.0, 0.0}, {2.0, 0.0}, {2.0, -1.0}});  // m, from the pin to the tip; sets the length too

  ribbon::Cord cord(def);
  cord.attach_mass(def.points - 1, 5.0);  // kg, at the last point
  for (int tick = 0; tick <= 120; ++tick) {
    if (tick % 30 == 0) print_tip(cord, tick);
    cord.step(1.0 / 60.0, {0.0, -9.81});  // s, m/s²
  }
}

}  // namespace

int main() try { swing(); } catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());  // names the field, its value and the accepted range
  return 1;
}
