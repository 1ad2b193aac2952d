#include "tests/study/figures.h"

#include <algorithm>

#include "ribbon/box2d/convert.h"
#include "ribbon/cord_forces.h"

namespace study {
namespace {

using ribbon::Vec2;
using ribbon::box2d::to_double;

/// Returns the greater value; NaN is less than any number.
double greater(double a, double b) { return b > a || a != a ? b : a; }

bool is_direct(const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord) {
  return coupling.cord(cord).solver() == ribbon::box2d::Solver::direct;
}

double mass_of_point(const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord, int point) {
  return is_direct(coupling, cord) ? coupling.cord(cord).direct().mass(point)
                                   : coupling.cord(cord).thesis().def().point_mass;
}

std::span<const Vec2> velocities_of(const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord) {
  return is_direct(coupling, cord) ? coupling.cord(cord).direct().velocities()
                                   : coupling.cord(cord).thesis().velocities();
}

/// Returns the greatest tension of a rope's links, or of the bars behind a ribbon's cells, N.
double tension_of(const ribbon::Cord& cord) {
  const ribbon::CordDef& def = cord.def();
  const bool has_cells = def.rows > 1 && def.elements == ribbon::Elements::cells;
  const auto cells = static_cast<std::size_t>(has_cells ? (def.points - 1) * (def.rows - 1) : 0);
  double most = unavailable;
  for (const double tension : cord.tensions().subspan(cells)) most = greater(most, tension);
  return most;
}

struct Motion {
  double mass = 0.0;  // kg
  double kinetic = 0.0;
  double potential = 0.0;
  Vec2 momentum{};

  void add(double m, Vec2 x, Vec2 v, Vec2 gravity) {
    mass += m;
    kinetic += 0.5 * m * dot(v, v);
    potential -= m * dot(gravity, x);
    momentum += m * v;
  }
};

Motion motion_of_bodies(const b2World& world, const ribbon::box2d::Coupling& coupling) {
  Motion motion;
  for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
    if (body->GetType() != b2_dynamicBody) continue;
    const double mass = static_cast<double>(body->GetMass());
    motion.add(mass, to_double(body->GetWorldCenter()), coupling.body(*body).velocity(), to_double(world.GetGravity()));
    // Box2D gives the inertia about the body's origin; Steiner's term moves it to the centre of mass.
    const Vec2 from_origin = to_double(body->GetLocalCenter());
    const double inertia = static_cast<double>(body->GetInertia()) - mass * dot(from_origin, from_origin);
    const double turning = static_cast<double>(body->GetAngularVelocity());
    motion.kinetic += 0.5 * inertia * turning * turning;
  }
  return motion;
}

Motion motion_of_cord(const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord, Vec2 gravity) {
  Motion motion;
  const auto x = coupling.cord(cord).positions();
  const auto v = velocities_of(coupling, cord);
  for (std::size_t p = 0; p < x.size(); ++p) {
    motion.add(mass_of_point(coupling, cord, static_cast<int>(p)), x[p], v[p], gravity);
  }
  return motion;
}

}  // namespace

double mass_of(const b2World& world, const ribbon::box2d::Coupling& coupling) {
  double mass = motion_of_bodies(world, coupling).mass;
  for (const ribbon::box2d::CordId c : coupling.cords()) mass += motion_of_cord(coupling, c, {}).mass;
  return mass;
}

Figures figures_of(const b2World& world, const ribbon::box2d::Coupling& coupling, const b2Filter& filter) {
  const Vec2 gravity = to_double(world.GetGravity());
  const Motion bodies = motion_of_bodies(world, coupling);
  Figures figures;
  figures.kinetic = bodies.kinetic;
  figures.momentum = bodies.momentum;
  figures.energy = bodies.kinetic + bodies.potential;
  for (const ribbon::box2d::CordId c : coupling.cords()) {
    const Motion motion = motion_of_cord(coupling, c, gravity);
    figures.kinetic += motion.kinetic;
    figures.momentum += motion.momentum;
    if (!is_direct(coupling, c)) {
      figures.energy = unavailable;
      continue;
    }
    const ribbon::Cord& cord = coupling.cord(c).direct();
    figures.energy += energy_of(cord, gravity).total();
    figures.tension = greater(figures.tension, tension_of(cord));
    const double radius = cord.def().radius;
    if (radius == 0.0) continue;
    const double deepest = test_support::penetration(world, outline_of(coupling, c), filter);
    figures.penetration = greater(figures.penetration, deepest / radius);
  }
  return figures;
}

test_support::Outline outline_of(const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord) {
  const int rows = coupling.cord(cord).shape().rows;
  const double radius = is_direct(coupling, cord) ? coupling.cord(cord).direct().def().radius : 0.0;
  return {test_support::outline_of(coupling.cord(cord).positions(), rows), rows > 1, radius};
}

}  // namespace study
