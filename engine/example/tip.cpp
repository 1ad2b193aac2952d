// A cord by itself, without Box2D or a window: it swings for two seconds with a weight on its end, and its tip is
// printed. Links with ribbon::ribbon alone.
#include <cstdio>
#include <exception>

#include "ribbon/cord.h"
#include "ribbon/layout.h"

namespace {

void print_tip(const ribbon::Cord& cord, int tick) {
  const ribbon::Vec2 tip = cord.positions().back();  // m, one a point, in the order of the path
  std::printf("%.1f s: tip at (%.4f, %.4f) m\n", tick / 60.0, tip.x, tip.y);
}

void swing() {
  ribbon::CordDef def;                                            // an inextensible rope, unless it says otherwise
  def.points = 41;                                                // along it: more bend finer and cost more, O(points)
  def.mass_per_length = 0.2;                                      // kg/m
  def.accuracy = ribbon::Accuracy::balanced();                    // the tuning: fast, balanced, accurate, or numbers
  def.pins = {0};                                                 // the first point stays where it is
  ribbon::lay_along(def, {{0.0, 0.0}, {2.0, 0.0}, {2.0, -1.0}});  // from there to the tip; this sets its length

  ribbon::Cord cord(def);
  cord.attach_mass(def.points - 1, 5.0);  // kg, on the last point
  for (int tick = 0; tick <= 120; ++tick) {
    if (tick % 30 == 0) print_tip(cord, tick);
    cord.step(1.0 / 60.0, {0.0, -9.81});  // s, m/s²
  }
}

}  // namespace

int main() try { swing(); } catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());  // which field, what it was, and what is accepted
  return 1;
}
