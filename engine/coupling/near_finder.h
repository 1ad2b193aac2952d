#pragma once

#include <box2d/box2d.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "ribbon/box.h"
#include "ribbon/box2d/coupling_types.h"
#include "ribbon/parallel_for.h"
#include "ribbon/vec2.h"

namespace ribbon::box2d {

/// A search for one cord.
struct Look {
  Box reach;                     ///< m, box that the cord can reach in the tick
  b2Filter filter;               ///< filter of the cord, as between two Box2D fixtures
  bool circles;                  ///< find circles only, for the thesis's solver
  std::vector<NearShape>* near;  ///< results are appended here, in any order and possibly twice
};

/// Returns whether all values of a body are finite and in range.
bool is_sound(const b2Body& body);
/// Returns whether in addition the body is not a dynamic body without mass.
bool can_be_met(const b2Body& body);

/// Finds the fixtures that cords may touch in a tick, by queries of the world's broad phase. Static fixtures are found
/// where they are, others along their motion. Box2D moves a body by at most b2_maxTranslation per tick, so fixtures
/// that are further away are left to later ticks. The finder stores no state between ticks, only memory.
class NearFinder {
 public:
  /// Reserves memory for so many tree leaves near a cord and for so many cords.
  void reserve(std::size_t leaves, std::size_t cords);
  /// Runs all searches for a tick of dt seconds under `gravity` [m/s²]. Each search must have its own result list.
  void find(b2World& world, std::span<const Look> looks, Vec2 gravity, double dt, const ParallelFor& parallel_for);

 private:
  /// A leaf of the broad phase's tree.
  struct Leaf {
    b2AABB fat;  // m, its box in the tree
    int proxy;
  };
  /// The memory and the results of one task, which searches for some of the cords.
  struct Lookout {
    std::vector<Leaf> leaves;                          // near a group of cords
    std::vector<std::pair<std::size_t, int>> further;  // cord, and leaf that only a moving body brings near it
    bool about_each = true;                            // there are few enough of them to look at each
  };

  void look_around(Lookout& lookout, std::span<const Look> looks, std::size_t first, std::size_t last);
  bool list_leaves(Lookout& lookout, std::span<const Look> group) const;
  void look_at_leaves(Lookout& lookout, const Look& look, std::size_t index) const;
  void look_for_what_moves(b2World& world, std::span<const Look> looks);
  void sort_by_x(std::span<const Look> looks);
  void look_from(std::span<const Look> looks, b2Fixture& fixture, int child);

  const b2BroadPhase* broad_phase_ = nullptr;
  double dt_ = 0.0;                // s
  double fall_ = 0.0;              // m, in the tick
  std::size_t most_leaves_ = 0;    // to be listed further off by one task
  std::vector<Lookout> lookouts_;  // one a task
  std::vector<std::size_t> by_x_;  // looks, by where their reaches begin
  double widest_ = 0.0;            // m, of these the widest
};

}  // namespace ribbon::box2d
