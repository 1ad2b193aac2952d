#include "ribbon/direct_solver.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "ribbon/collision/motion_bounds.h"
#include "ribbon/cord_sweep.h"
#include "ribbon/geometry/quadtree.h"
#include "ribbon/island/island.h"
#include "ribbon/linear/index.h"
#include "ribbon/system/cord_parts.h"
#include "ribbon/system/fetch_cord.h"
#include "ribbon/system/tie_groups.h"

namespace ribbon {
namespace {

constexpr int min_points_per_part = 200;  // about 20 µs of work
constexpr std::size_t fetched_cords = 4;  // that are fetched from memory before they are checked

}  // namespace

DirectSolver::DirectSolver() : ties_(std::make_unique<TieGroups>()) { first_members_.push_back(0); }
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

void DirectSolver::reserve(std::size_t cords) {
  islands_of_cords_.begin(cords);
  contact_cords_.reserve(cords);
  swept_boxes_.reserve(cords);
  first_links_.reserve(cords + 1);
  points_.reserve(cords);
  members_.reserve(cords);
  member_cords_.reserve(cords);
  first_members_.reserve(cords + 1);
  next_members_.reserve(cords);
  first_of_part_.reserve(cords + 1);
  island_reports_.reserve(cords);
  member_reports_.reserve(cords);
}

void DirectSolver::step(std::span<const IslandCord> cords, std::span<RigidBody> bodies, double dt, Vec2 gravity,
                        std::span<CordReport> reports, std::span<const Tie> ties) {
  check_step(dt, gravity);
  check_bodies(bodies);
  check_cords(cords, bodies.size());
  ties_->find(ties, points_);
  total_ = {};
  island_reports_.clear();
  first_members_.assign(1, 0);
  if (cords.empty()) return;
  find_swept_boxes(cords, bodies, dt, gravity);
  find_islands(cords, bodies);
  list_members(cords);
  list_tied_points();
  island_reports_.resize(at(islands()));
  member_reports_.resize(cords.size());
  parallel_for_(divide_into_parts(), [&](int part) {
    const std::size_t p = at(part);
    for (std::size_t k = first_of_part_[p]; k < first_of_part_[p + 1]; ++k) {
      const std::size_t first = first_members_[k];
      const std::size_t count = first_members_[k + 1] - first;
      fetch_member(first + count + 2, fetch_cord);
      fetch_member(first + count + 1, fetch_parts);
      fetch_member(first + count, fetch_lists);
      const auto members = std::span<const IslandCord>(members_).subspan(first, count);
      const auto member_reports = std::span(member_reports_).subspan(first, count);
      island_reports_[k] = island_solvers_[p]->step(members, tied_points(k), bodies, dt, gravity, member_reports);
      for (const IslandCord& member : members) member.cord->parts().remember_sweep();
    }
  });
  for (std::size_t k = 0; k < island_reports_.size(); ++k) {
    total_ += island_reports_[k];  // nothing, if it sleeps
    for (std::size_t m = first_members_[k]; m < first_members_[k + 1]; ++m) {
      member_reports_[m].island = static_cast<int>(k);
      reports[member_cords_[m]] = member_reports_[m];
    }
  }
}

/// Checks the cords, and lists the sizes of all and those that meet others. So the step reads a cord, which may be far
/// from the processor, once before it solves it.
void DirectSolver::check_cords(std::span<const IslandCord> cords, std::size_t bodies) {
  points_.clear();
  contact_cords_.clear();
  for (std::size_t k = 0; k < cords.size(); ++k) {
    if (k + fetched_cords < cords.size()) fetch(*cords[k + fetched_cords].cord);
    const Cord& cord = *cords[k].cord;
    check_surroundings(cords[k].surroundings, bodies, cord.size(), cord.def().rows);
    check_axles(cord, cords[k].surroundings);
    points_.push_back(cord.size());
    if (meets_cords(cord)) contact_cords_.push_back(k);
  }
}

/// Finds the boxes of cords that may touch each other.
void DirectSolver::find_swept_boxes(std::span<const IslandCord> cords, std::span<const RigidBody> bodies, double dt,
                                    Vec2 gravity) {
  swept_boxes_.clear();
  link_boxes_.clear();
  first_links_.clear();
  for (const std::size_t k : contact_cords_) {
    first_links_.push_back(link_boxes_.size());
    swept_boxes_.push_back(add_swept_boxes(cords[k], bodies, dt, gravity));
  }
  first_links_.push_back(link_boxes_.size());
}

void DirectSolver::find_islands(std::span<const IslandCord> cords, std::span<const RigidBody> bodies) {
  islands_of_cords_.begin(cords.size());
  first_cords_.assign(bodies.size(), -1);
  for (std::size_t k = 0; k < cords.size(); ++k) {
    for (const Grip& grip : cords[k].surroundings.grips) join_by_body(k, grip.body, bodies);
    for (const Axle& axle : cords[k].surroundings.axles) join_by_body(k, axle.body, bodies);
    for (const RigidCircle& circle : cords[k].surroundings.circles) join_by_body(k, circle.body, bodies);
    for (const RigidSegment& segment : cords[k].surroundings.segments) join_by_body(k, segment.body, bodies);
    for (const Support& support : cords[k].surroundings.supports) {
      if (support.other < 0) continue;
      join_by_body(k, support.body, bodies);
      join_by_body(k, support.other, bodies);
    }
  }
  const auto tied = ties_->points();
  for (std::size_t k = 1; k < tied.size(); ++k) {
    if (tied[k].group == tied[k - 1].group) islands_of_cords_.join(at(tied[k].cord), at(tied[k - 1].cord));
  }
  join_near_cords(cords);
}

/// Joins cords with links that may come near each other.
void DirectSolver::join_near_cords(std::span<const IslandCord> cords) {
  if (contact_cords_.size() < 2) return;
  if (tree_capacity_ < contact_cords_.size()) {
    tree_capacity_ = 2 * contact_cords_.size();
    tree_ = std::make_unique<Quadtree>(static_cast<int>(tree_capacity_));
  }
  tree_->build(swept_boxes_);
  for (std::size_t b = 0; b < contact_cords_.size(); ++b) {
    tree_->query(swept_boxes_[b], [&](int other) {
      const auto a = at(other);
      if (a >= b || islands_of_cords_.root(contact_cords_[a]) == islands_of_cords_.root(contact_cords_[b])) return;
      const CordParts& cord = cords[contact_cords_[a]].cord->parts();
      if (cord.meets(cords[contact_cords_[b]].cord->parts()) && links_overlap(a, b))
        islands_of_cords_.join(contact_cords_[a], contact_cords_[b]);
    });
  }
}

/// Lists the cords by island: a counting sort in O(cords).
void DirectSolver::list_members(std::span<const IslandCord> cords) {
  next_members_.assign(cords.size(), 0);
  for (std::size_t k = 0; k < cords.size(); ++k) ++next_members_[islands_of_cords_.root(k)];
  first_members_.clear();
  std::size_t members = 0;
  for (std::size_t k = 0; k < cords.size(); ++k) {
    if (islands_of_cords_.root(k) != k) continue;
    first_members_.push_back(members);
    members += std::exchange(next_members_[k], members);
  }
  first_members_.push_back(members);
  members_.resize(cords.size());
  member_cords_.resize(cords.size());
  for (std::size_t k = 0; k < cords.size(); ++k) {
    const std::size_t index = next_members_[islands_of_cords_.root(k)]++;
    members_[index] = cords[k];
    member_cords_[index] = k;
  }
}

/// Sorts the tied points by island. From then on they refer to its members.
void DirectSolver::list_tied_points() {
  first_tied_.clear();
  const auto tied = ties_->points();
  if (tied.empty()) return;
  for (std::size_t index = 0; index < member_cords_.size(); ++index) next_members_[member_cords_[index]] = index;
  for (TiedPoint& point : tied) point.cord = static_cast<int>(next_members_[at(point.cord)]);
  const auto island_of = [&](const TiedPoint& point) {
    return std::upper_bound(first_members_.begin(), first_members_.end(), at(point.cord)) - first_members_.begin() - 1;
  };
  std::sort(tied.begin(), tied.end(), [&](const TiedPoint& a, const TiedPoint& b) {
    return std::tuple(island_of(a), a.group, a.cord) < std::tuple(island_of(b), b.group, b.cord);
  });
  std::size_t next = 0;
  for (std::size_t k = 0; k < at(islands()); ++k) {
    first_tied_.push_back(next);
    for (; next < tied.size() && at(tied[next].cord) < first_members_[k + 1]; ++next) {
      tied[next].cord -= static_cast<int>(first_members_[k]);
    }
  }
  first_tied_.push_back(next);
}

std::span<const TiedPoint> DirectSolver::tied_points(std::size_t island) const {
  if (first_tied_.empty()) return {};
  return ties_->points().subspan(first_tied_[island], first_tied_[island + 1] - first_tied_[island]);
}

/// Fetches a member that will be solved soon, if there is one with that index.
void DirectSolver::fetch_member(std::size_t member, void (*fetch)(const Cord&)) const {
  if (member < members_.size()) fetch(*members_[member].cord);
}

/// Divides the islands, in their order, into parts with similar numbers of points. Returns the number of parts.
int DirectSolver::divide_into_parts() {
  const std::size_t count = at(islands());
  std::size_t points = 0;
  for (const int of_cord : points_) points += at(of_cord);
  const int max_parts = std::min(islands(), parallel_for_.parts(static_cast<int>(points), min_points_per_part));
  first_of_part_.clear();
  std::size_t before = 0;
  for (std::size_t k = 0; k < count; ++k) {
    if (before * at(max_parts) >= points * first_of_part_.size()) first_of_part_.push_back(k);
    for (std::size_t m = first_members_[k]; m < first_members_[k + 1]; ++m) before += at(points_[member_cords_[m]]);
  }
  const int parts = static_cast<int>(first_of_part_.size());
  first_of_part_.push_back(count);
  while (island_solvers_.size() < at(parts)) island_solvers_.push_back(std::make_unique<Island>());
  return parts;
}

/// Appends the boxes that the links of a cord do not leave in the step without an impact. Returns the box around them.
Box DirectSolver::add_swept_boxes(const IslandCord& island_cord, std::span<const RigidBody> bodies, double dt,
                                  Vec2 gravity) {
  const Cord& cord = *island_cord.cord;
  const auto x = cord.positions();
  const auto v = cord.velocities();
  const double margin =
      cord.def().radius + MotionBounds::bound_of(cord.parts(), island_cord.surroundings, bodies, dt, gravity);
  const auto rows = at(cord.def().rows);
  const auto column_box = [&](std::size_t first) {
    Box box = box_around(x[first], x[first] + dt * v[first], 0.0);
    for (std::size_t p = first + 1; p < first + rows; ++p) {
      box = joined(box, box_around(x[p], x[p] + dt * v[p], 0.0));
    }
    return box;
  };
  Box previous = column_box(0);
  Box all = previous;
  for (std::size_t first = rows; first < x.size(); first += rows) {
    const Box column = column_box(first);
    link_boxes_.push_back(widened(joined(previous, column), margin));
    all = joined(all, column);
    previous = column;
  }
  return widened(all, margin);
}

/// Returns whether a link of contact cord a may come near one of contact cord b.
bool DirectSolver::links_overlap(std::size_t a, std::size_t b) const {
  for (std::size_t i = first_links_[a]; i < first_links_[a + 1]; ++i) {
    if (!overlap(link_boxes_[i], swept_boxes_[b])) continue;
    for (std::size_t j = first_links_[b]; j < first_links_[b + 1]; ++j) {
      if (overlap(link_boxes_[i], link_boxes_[j])) return true;
    }
  }
  return false;
}

/// Joins a cord with the first cord near the same body. Static and kinematic bodies do not couple cords.
void DirectSolver::join_by_body(std::size_t cord, int body, std::span<const RigidBody> bodies) {
  if (bodies[at(body)].inverse_mass == 0.0) return;
  int& first = first_cords_[at(body)];
  if (first < 0) {
    first = static_cast<int>(cord);
  } else {
    islands_of_cords_.join(at(first), cord);
  }
}

}  // namespace ribbon
