#include "ribbon/direct_solver.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ribbon/collision/motion_bounds.h"
#include "ribbon/geometry/quadtree.h"
#include "ribbon/island/island.h"

namespace ribbon {
namespace {

constexpr int least_points = 200;  // of cords, that are one task: some 20 µs

std::size_t at(int index) { return static_cast<std::size_t>(index); }

}  // namespace

DirectSolver::DirectSolver() { first_members_.push_back(0); }
DirectSolver::DirectSolver(DirectSolver&&) noexcept = default;
DirectSolver& DirectSolver::operator=(DirectSolver&&) noexcept = default;
DirectSolver::~DirectSolver() = default;

void check(const ParallelFor& parallel_for) {
  if (parallel_for.workers < 1) refuse("workers", parallel_for.workers, "1 or more");
}

void DirectSolver::use(const ParallelFor& parallel_for) {
  check(parallel_for);
  parallel_for_ = parallel_for;
}

void DirectSolver::step(std::span<const IslandCord> cords, std::span<RigidBody> bodies, double dt, Vec2 gravity,
                        std::span<CordReport> reports) {
  check_step(dt, gravity);
  check_bodies(bodies);
  for (const IslandCord& cord : cords) check_met(cord.met, bodies.size(), cord.cord->size(), cord.cord->def().rows);
  total_ = {};
  first_members_.assign(1, 0);
  if (cords.empty()) return;
  find_reaches(cords, bodies, dt, gravity);
  find_islands(cords, bodies);
  list_members(cords);
  parallel_for_(divide(), [&](int part) {
    const std::size_t p = at(part);
    for (std::size_t k = first_parts_[p]; k < first_parts_[p + 1]; ++k) {
      const std::size_t first = first_members_[k];
      const auto members = std::span<const IslandCord>(members_).subspan(first, first_members_[k + 1] - first);
      reports[cords_of_members_[first]] = workplaces_[p]->step(members, bodies, dt, gravity);
      for (const IslandCord& member : members) member.cord->remember_sweep();
    }
  });
  for (std::size_t k = 0; k < cords.size(); ++k) {
    if (parents_[k] == k) {
      if (!cords[k].cord->is_asleep()) total_ += reports[k];
    } else {
      reports[k] = reports[parents_[k]];
    }
  }
}

/// Those of cords that meet each other.
void DirectSolver::find_reaches(std::span<const IslandCord> cords, std::span<const RigidBody> bodies, double dt,
                                Vec2 gravity) {
  meeting_.clear();
  reaches_.clear();
  links_.clear();
  first_links_.clear();
  for (std::size_t k = 0; k < cords.size(); ++k) {
    if (!cords[k].cord->def().cord_contact) continue;
    meeting_.push_back(k);
    first_links_.push_back(links_.size());
    reaches_.push_back(take_reach(cords[k], bodies, dt, gravity));
  }
  first_links_.push_back(links_.size());
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
  join_near();
  for (std::size_t k = 0; k < cords.size(); ++k) parents_[k] = root(k);
}

/// Those whose links may come near each other.
void DirectSolver::join_near() {
  if (meeting_.size() < 2) return;
  if (tree_room_ < meeting_.size()) {
    tree_room_ = 2 * meeting_.size();
    tree_ = std::make_unique<Quadtree>(static_cast<int>(tree_room_));
  }
  tree_->build(reaches_);
  for (std::size_t b = 0; b < meeting_.size(); ++b) {
    tree_->query(reaches_[b], [&](int other) {
      const auto a = static_cast<std::size_t>(other);
      if (a < b && root(meeting_[a]) != root(meeting_[b]) && links_meet(a, b)) join(meeting_[a], meeting_[b]);
    });
  }
}

/// By island.
void DirectSolver::list_members(std::span<const IslandCord> cords) {
  places_.assign(cords.size(), 0);
  for (std::size_t k = 0; k < cords.size(); ++k) ++places_[parents_[k]];
  first_members_.clear();
  std::size_t members = 0;
  for (std::size_t k = 0; k < cords.size(); ++k) {
    if (parents_[k] != k) continue;
    first_members_.push_back(members);
    members += std::exchange(places_[k], members);
  }
  first_members_.push_back(members);
  members_.resize(cords.size());
  cords_of_members_.resize(cords.size());
  for (std::size_t k = 0; k < cords.size(); ++k) {
    const std::size_t place = places_[parents_[k]]++;
    members_[place] = cords[k];
    cords_of_members_[place] = k;
  }
}

/// Divides the islands into parts of about as many points, in their order, and returns how many.
int DirectSolver::divide() {
  const std::size_t count = at(islands());
  std::size_t points = 0;
  for (const IslandCord& member : members_) points += at(member.cord->size());
  const int most = std::min(islands(), parallel_for_.parts(static_cast<int>(points), least_points));
  first_parts_.clear();
  std::size_t before = 0;
  for (std::size_t k = 0; k < count; ++k) {
    if (before * at(most) >= points * first_parts_.size()) first_parts_.push_back(k);
    for (std::size_t m = first_members_[k]; m < first_members_[k + 1]; ++m) before += at(members_[m].cord->size());
  }
  const int parts = static_cast<int>(first_parts_.size());
  first_parts_.push_back(count);
  while (workplaces_.size() < at(parts)) workplaces_.push_back(std::make_unique<Island>());
  return parts;
}

/// The box that a cord does not leave in the step unless something hits it, and those of its links.
Box DirectSolver::take_reach(const IslandCord& island_cord, std::span<const RigidBody> bodies, double dt,
                             Vec2 gravity) {
  const Cord& cord = *island_cord.cord;
  const auto x = cord.positions();
  const auto v = cord.velocities();
  const double margin = cord.def().radius + MotionBounds::bound_of(cord.parts(), island_cord.met, bodies, dt, gravity);
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
std::size_t DirectSolver::root(std::size_t cord) {
  while (parents_[cord] != cord) cord = parents_[cord] = parents_[parents_[cord]];
  return cord;
}

void DirectSolver::join(std::size_t a, std::size_t b) {
  const std::size_t root_a = root(a);
  const std::size_t root_b = root(b);
  parents_[std::max(root_a, root_b)] = std::min(root_a, root_b);
}

}  // namespace ribbon
