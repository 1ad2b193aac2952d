#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "ribbon/box.h"
#include "ribbon/cord.h"
#include "ribbon/island_cord.h"
#include "ribbon/linear/disjoint_sets.h"
#include "ribbon/parallel_for.h"
#include "ribbon/reports.h"
#include "ribbon/rigid_circle.h"
#include "ribbon/tie.h"
#include "ribbon/vec2.h"

namespace ribbon {

class Quadtree;
class TieGroups;
struct TiedPoint;

/// Steps many cords with the direct solver. Cords that share a body, are tied or may touch each other form an
/// island and are solved together; islands are independent. The solver stores no state between steps, only memory.
class DirectSolver {
 public:
  DirectSolver();
  DirectSolver(DirectSolver&&) noexcept;
  DirectSolver& operator=(DirectSolver&&) noexcept;
  ~DirectSolver();

  /// Advances all cords by dt seconds, 1e-9 ≤ dt ≤ 1, under `gravity` [m/s²]. Islands are stepped in the order of their
  /// first cords. Writes the report of cords[k] to reports[k]; there must be as many. Tied points move as one; in the
  /// first step of a tie they get one velocity, which keeps their momentum, and points that are apart are drawn
  /// together over several steps. Wake cords whose ties have changed. Throws DefinitionError, and moves nothing, if
  /// check_step, check_bodies or check_surroundings do, for a tie of an unknown cord or point, and for one that ties a
  /// cord to itself, directly or through others.
  void step(std::span<const IslandCord> cords, std::span<RigidBody> bodies, double dt, Vec2 gravity,
            std::span<CordReport> reports, std::span<const Tie> ties = {});

  /// Sets how islands are stepped in parallel. The results have the same bits. Throws DefinitionError for less than one
  /// worker.
  void use(const ParallelFor& parallel_for);

  /// Reserves memory for steps of up to this many cords, each of which is an island.
  void reserve(std::size_t cords);

  /// Returns the number of islands in the last step.
  int islands() const { return static_cast<int>(first_members_.size()) - 1; }
  /// Returns the reports of all islands in the last step; see CordReport::island.
  std::span<const IslandReport> island_reports() const { return island_reports_; }
  /// Returns the sum of the reports of all islands in the last step.
  const IslandReport& total() const { return total_; }

 private:
  void check_cords(std::span<const IslandCord> cords, std::size_t bodies);
  void find_islands(std::span<const IslandCord> cords, std::span<const RigidBody> bodies);
  void join_by_body(std::size_t cord, int body, std::span<const RigidBody> bodies);
  void find_swept_boxes(std::span<const IslandCord> cords, std::span<const RigidBody> bodies, double dt, Vec2 gravity);
  Box add_swept_boxes(const IslandCord& cord, std::span<const RigidBody> bodies, double dt, Vec2 gravity);
  void join_near_cords(std::span<const IslandCord> cords);
  bool links_overlap(std::size_t a, std::size_t b) const;
  void list_members(std::span<const IslandCord> cords);
  void list_tied_points();
  std::span<const TiedPoint> tied_points(std::size_t island) const;
  int divide_into_parts();
  void fetch_member(std::size_t member, void (*fetch)(const Cord&)) const;

  ParallelFor parallel_for_;
  DisjointSets islands_of_cords_;  // the root is the first cord of an island
  // Of the cords that meet others, in their order:
  std::vector<std::size_t> contact_cords_;  // indices of the cords
  std::vector<Box> swept_boxes_;            // m, which a cord does not leave in the step without an impact
  std::vector<Box> link_boxes_;             // m, the same of each link, cord by cord
  std::vector<std::size_t> first_links_;    // index in link_boxes_ of each cord, and the end of the last
  std::vector<int> points_;                 // by cord
  std::unique_ptr<TieGroups> ties_;
  std::unique_ptr<Quadtree> tree_;  // of swept_boxes_
  std::size_t tree_capacity_ = 0;   // boxes
  std::vector<int> first_cords_;    // by body: the first cord near it; −1: none
  // By island, in the order of their first cords:
  std::vector<IslandCord> members_;         // cords, island by island
  std::vector<std::size_t> member_cords_;   // index of the cord of each member
  std::vector<std::size_t> first_members_;  // index in members_ of each island, and the end of the last
  std::vector<std::size_t> first_tied_;     // index in ties_ of each island, and the end of the last; empty: no ties
  std::vector<std::size_t> next_members_;   // by first cord of an island: index of its next member
  std::vector<std::size_t> first_of_part_;  // first island of each part, which is one task, and the end of the last
  std::vector<IslandReport> island_reports_;
  std::vector<CordReport> member_reports_;  // of members_
  IslandReport total_;
  std::vector<std::unique_ptr<Island>> island_solvers_;  // by part; each keeps the memory that its part needs
};

}  // namespace ribbon
