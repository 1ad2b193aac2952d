#include "ribbon/direct_solver.h"

#include <algorithm>
#include <cmath>

namespace ribbon {

void DirectSolver::step(std::span<const IslandCord> cords, std::span<RigidBody> bodies, double dt, Vec2 gravity,
                        std::span<CordReport> reports) {
  reaches_.clear();
  for (const IslandCord& cord : cords) {
    reaches_.push_back(cord.cord->def().cord_contact ? reach_of(*cord.cord, dt, gravity) : Box{});
  }
  find_islands(cords, bodies);
  for (std::size_t first = 0; first < cords.size(); ++first) {
    if (root(first) != first) continue;
    members_.clear();
    for (std::size_t k = first; k < cords.size(); ++k) {
      if (root(k) == first) members_.push_back(cords[k]);
    }
    const CordReport report = island_.step(members_, bodies, dt, gravity);
    for (std::size_t k = first; k < cords.size(); ++k) {
      if (root(k) == first) reports[k] = report;
    }
  }
}

void DirectSolver::find_islands(std::span<const IslandCord> cords, std::span<const RigidBody> bodies) {
  parents_.resize(cords.size());
  for (std::size_t k = 0; k < cords.size(); ++k) parents_[k] = k;
  first_cords_.assign(bodies.size(), -1);
  for (std::size_t k = 0; k < cords.size(); ++k) {
    for (const Grip& grip : cords[k].met.grips) share(k, grip.body, bodies);
    for (const RigidCircle& circle : cords[k].met.circles) share(k, circle.body, bodies);
    for (const RigidSegment& segment : cords[k].met.segments) share(k, segment.body, bodies);
  }
  for (std::size_t b = 0; b < cords.size(); ++b) {
    if (!cords[b].cord->def().cord_contact) continue;
    for (std::size_t a = 0; a < b; ++a) {
      if (cords[a].cord->def().cord_contact && overlap(reaches_[a], reaches_[b])) join(a, b);
    }
  }
}

/// The box that a cord does not leave in the step unless something hits it.
Box DirectSolver::reach_of(const Cord& cord, double dt, Vec2 gravity) {
  Box box{cord.positions()[0], cord.positions()[0]};
  const auto take = [&box](Vec2 x) {
    box.low = {std::min(box.low.x, x.x), std::min(box.low.y, x.y)};
    box.high = {std::max(box.high.x, x.x), std::max(box.high.y, x.y)};
  };
  double speed2 = 0.0;
  for (std::size_t p = 0; p < cord.positions().size(); ++p) {
    take(cord.positions()[p]);
    take(cord.positions()[p] + dt * cord.velocities()[p]);
    speed2 = std::max(speed2, dot(cord.velocities()[p], cord.velocities()[p]));
  }
  const double margin =
      cord.def().radius + 0.25 * cord.rest_length(0) + dt * (std::sqrt(speed2) + 2.0 * dt * length(gravity));
  return {box.low - Vec2{margin, margin}, box.high + Vec2{margin, margin}};
}

/// A body that nothing pushes passes nothing on.
void DirectSolver::share(std::size_t cord, int body, std::span<const RigidBody> bodies) {
  if (bodies[static_cast<std::size_t>(body)].inverse_mass == 0.0) return;
  int& first = first_cords_[static_cast<std::size_t>(body)];
  if (first < 0) {
    first = static_cast<int>(cord);
  } else {
    join(static_cast<std::size_t>(first), cord);
  }
}

/// The first cord of an island.
std::size_t DirectSolver::root(std::size_t cord) const {
  while (parents_[cord] != cord) cord = parents_[cord];
  return cord;
}

void DirectSolver::join(std::size_t a, std::size_t b) {
  const std::size_t root_a = root(a);
  const std::size_t root_b = root(b);
  parents_[std::max(root_a, root_b)] = std::min(root_a, root_b);
}

}  // namespace ribbon
