#include "ribbon/direct_solver.h"

#include <algorithm>
#include <cmath>

#include "ribbon/island.h"

namespace ribbon {

DirectSolver::DirectSolver() : island_(std::make_unique<Island>()) {}
DirectSolver::DirectSolver(DirectSolver&&) noexcept = default;
DirectSolver& DirectSolver::operator=(DirectSolver&&) noexcept = default;
DirectSolver::~DirectSolver() = default;

void DirectSolver::step(std::span<const IslandCord> cords, std::span<RigidBody> bodies, double dt, Vec2 gravity,
                        std::span<CordReport> reports) {
  check_step(dt, gravity);
  check_bodies(bodies);
  for (const IslandCord& cord : cords) check_met(cord.met, bodies.size(), cord.cord->size(), cord.cord->def().rows);
  parents_.clear();
  total_ = {};
  if (cords.empty()) return;
  reaches_.clear();
  links_.clear();
  first_links_.clear();
  for (const IslandCord& cord : cords) {
    first_links_.push_back(links_.size());
    reaches_.push_back(cord.cord->def().cord_contact ? take_reach(cord, bodies, dt, gravity) : Box{});
  }
  first_links_.push_back(links_.size());
  find_islands(cords, bodies);
  for (std::size_t first = 0; first < cords.size(); ++first) {
    if (parents_[first] != first) continue;
    members_.clear();
    for (std::size_t k = first; k < cords.size(); ++k) {
      if (parents_[k] == first) members_.push_back(cords[k]);
    }
    reports[first] = island_->step(members_, bodies, dt, gravity);
    total_ += reports[first];
  }
  for (std::size_t k = 0; k < cords.size(); ++k) reports[k] = reports[parents_[k]];
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
      if (!cords[a].cord->def().cord_contact || !overlap(reaches_[a], reaches_[b])) continue;
      if (root(a) != root(b) && links_meet(a, b)) join(a, b);
    }
  }
  for (std::size_t k = 0; k < cords.size(); ++k) parents_[k] = root(k);
}

/// The box that a cord does not leave in the step unless something hits it, and those of its links.
Box DirectSolver::take_reach(const IslandCord& island_cord, std::span<const RigidBody> bodies, double dt,
                             Vec2 gravity) {
  const Cord& cord = *island_cord.cord;
  const auto x = cord.positions();
  const auto v = cord.velocities();
  const double margin = cord.def().radius + Island::room_of(island_cord, bodies, dt, gravity);
  const auto rows = static_cast<std::size_t>(cord.def().rows);
  const auto column_at = [&](std::size_t first) {
    Box box = box_around(x[first], x[first] + dt * v[first], 0.0);
    for (std::size_t p = first + 1; p < first + rows; ++p) {
      box = joined(box, box_around(x[p], x[p] + dt * v[p], 0.0));
    }
    return box;
  };
  Box before = column_at(0);
  Box all = before;
  for (std::size_t first = rows; first < x.size(); first += rows) {
    const Box column = column_at(first);
    links_.push_back(widened(joined(before, column), margin));
    all = joined(all, column);
    before = column;
  }
  return widened(all, margin);
}

/// Whether a link of the one may come near one of the other.
bool DirectSolver::links_meet(std::size_t a, std::size_t b) const {
  for (std::size_t i = first_links_[a]; i < first_links_[a + 1]; ++i) {
    if (!overlap(links_[i], reaches_[b])) continue;
    for (std::size_t j = first_links_[b]; j < first_links_[b + 1]; ++j) {
      if (overlap(links_[i], links_[j])) return true;
    }
  }
  return false;
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

int DirectSolver::islands() const {
  int count = 0;
  for (std::size_t k = 0; k < parents_.size(); ++k) count += parents_[k] == k;
  return count;
}

}  // namespace ribbon
