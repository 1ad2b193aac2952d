#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "ribbon/box.h"
#include "ribbon/cord.h"
#include "ribbon/island_cord.h"
#include "ribbon/rigid_circle.h"
#include "ribbon/vec2.h"

namespace ribbon {

/// Steps many cords of the direct solver that share bodies or meet each other: those that do are one island, solved at
/// once; the others are solved one by one. It keeps memory only.
class DirectSolver {
 public:
  DirectSolver();
  DirectSolver(DirectSolver&&) noexcept;
  DirectSolver& operator=(DirectSolver&&) noexcept;
  ~DirectSolver();

  /// Advances all cords by dt seconds, 1e-9 ≤ dt ≤ 1, under `gravity` [m/s²], the islands in the order of their first
  /// cords; all meet the same `bodies`. reports[k] is what happened in the island of cords[k]. Throws DefinitionError,
  /// and moves none, where check_step, check_bodies or check_met do.
  void step(std::span<const IslandCord> cords, std::span<RigidBody> bodies, double dt, Vec2 gravity,
            std::span<CordReport> reports);

  /// How many islands the cords of the last step made.
  int islands() const;
  /// What happened in the last step, each island counted once.
  const CordReport& total() const { return total_; }

 private:
  void find_islands(std::span<const IslandCord> cords, std::span<const RigidBody> bodies);
  void share(std::size_t cord, int body, std::span<const RigidBody> bodies);
  Box take_reach(const IslandCord& cord, std::span<const RigidBody> bodies, double dt, Vec2 gravity);
  bool links_meet(std::size_t a, std::size_t b) const;
  std::size_t root(std::size_t cord) const;
  void join(std::size_t a, std::size_t b);

  std::vector<std::size_t> parents_;  // by cord: another of its island, in the end its first one, or itself
  std::vector<Box> reaches_;          // by cord, of those that meet others
  std::vector<Box> links_;            // of their links; and the first of each cord's, and the end of the last's
  std::vector<std::size_t> first_links_;
  std::vector<int> first_cords_;  // by body: the first cord that it is near, −1 if none
  std::vector<IslandCord> members_;
  CordReport total_;
  std::unique_ptr<Island> island_;
};

}  // namespace ribbon
