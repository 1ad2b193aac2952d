#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "ribbon/box.h"
#include "ribbon/cord.h"
#include "ribbon/island_cord.h"
#include "ribbon/parallel_for.h"
#include "ribbon/rigid_circle.h"
#include "ribbon/vec2.h"

namespace ribbon {

class Quadtree;

/// Steps many cords with the direct solver. Cords that share a body or may touch each other form an island and are
/// solved together; islands are independent. The solver stores no state between steps, only memory.
class DirectSolver {
 public:
  DirectSolver();
  DirectSolver(DirectSolver&&) noexcept;
  DirectSolver& operator=(DirectSolver&&) noexcept;
  ~DirectSolver();

  /// Advances all cords by dt seconds, 1e-9 ≤ dt ≤ 1, under `gravity` [m/s²]. Islands are stepped in the order of their
  /// first cords. Writes the report of the island of cords[k] to reports[k]. Throws DefinitionError, and moves nothing,
  /// if check_step, check_bodies or check_met do.
  void step(std::span<const IslandCord> cords, std::span<RigidBody> bodies, double dt, Vec2 gravity,
            std::span<CordReport> reports);

  /// Sets how islands are stepped in parallel. The results have the same bits. Throws DefinitionError for less than one
  /// worker.
  void use(const ParallelFor& parallel_for);

  /// Returns the number of islands in the last step.
  int islands() const { return static_cast<int>(first_members_.size()) - 1; }
  /// Returns the sum of the reports of all islands in the last step.
  const CordReport& total() const { return total_; }

 private:
  void find_islands(std::span<const IslandCord> cords, std::span<const RigidBody> bodies);
  void share(std::size_t cord, int body, std::span<const RigidBody> bodies);
  void find_reaches(std::span<const IslandCord> cords, std::span<const RigidBody> bodies, double dt, Vec2 gravity);
  Box take_reach(const IslandCord& cord, std::span<const RigidBody> bodies, double dt, Vec2 gravity);
  void join_near();
  bool links_meet(std::size_t a, std::size_t b) const;
  std::size_t root(std::size_t cord);
  void join(std::size_t a, std::size_t b);
  void list_members(std::span<const IslandCord> cords);
  int divide();

  ParallelFor parallel_for_;
  std::vector<std::size_t> parents_;  // by cord: another of its island, in the end its first one, or itself
  // Of cords that meet others: which, their boxes, those of their links, and the first of each one's links, and the end
  // of the last's.
  std::vector<std::size_t> meeting_;
  std::vector<Box> reaches_;
  std::vector<Box> links_;
  std::vector<std::size_t> first_links_;
  std::unique_ptr<Quadtree> tree_;  // of reaches_
  std::size_t tree_room_ = 0;       // that it has, boxes
  std::vector<int> first_cords_;    // by body: the first cord that it is near, −1 if none
  // By island, in the order of their first cords: the cords, and the first of each island, and the end of the last.
  std::vector<IslandCord> members_;
  std::vector<std::size_t> cords_of_members_;
  std::vector<std::size_t> first_members_;
  std::vector<std::size_t> places_;       // by first cord of an island: where its next member goes
  std::vector<std::size_t> first_parts_;  // islands: the first of each part that is done by one task, and the end
  CordReport total_;
  std::vector<std::unique_ptr<Island>> workplaces_;  // by part, so that each has the memory that it needs
};

}  // namespace ribbon
