#pragma once

#include <box2d/box2d.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "ribbon/box.h"
#include "ribbon/parallel_for.h"
#include "ribbon/vec2.h"

namespace engine {

/// A part of a fixture that a cord may reach: an edge of a chain, and of any other shape all of it.
struct NearShape {
  b2Fixture* fixture;        ///< of an enabled body, no sensor
  int child;                 ///< of its shape
  double way;                ///< m, that it may go in the tick, and more
  std::uint64_t number = 0;  ///< the fixture's: FixtureIds
};

/// Where a cord looks, what it meets, and what it finds.
struct Look {
  ribbon::Box reach;             ///< m, of the cord in the tick
  b2Filter filter;               ///< as between two Box2D fixtures
  bool circles;                  ///< alone are met, as a cord of the thesis's does
  std::vector<NearShape>* near;  ///< what is found is added here, in no order; some of it may be there twice
};

/// Whether the numbers of a body are such that a cord can meet it.
bool is_sound(const b2Body& body);
/// Whether they are, and it is no dynamic body without mass.
bool can_be_met(const b2Body& body);

/// Finds what cords may reach in a tick, by the broad phase of a world: what is static where it is, the rest on its
/// way. Box2D takes a body no further than b2_maxTranslation in a tick, so what is further off than that, though it
/// turn, is left for the next. It keeps memory only.
class NearFinder {
 public:
  /// Takes the memory for so many leaves of the world's tree about a cord, and for so many cords.
  void reserve(std::size_t leaves, std::size_t cords);
  /// In a tick of dt seconds under `gravity` [m/s²]; no two looks find into the same list.
  void find(b2World& world, std::span<const Look> looks, ribbon::Vec2 gravity, double dt,
            const ribbon::ParallelFor& parallel_for);

 private:
  /// What one task finds that looks around for some cords.
  struct Lookout {
    std::vector<int> leaves;                           // of the world's tree, further off from a cord
    std::vector<std::pair<std::size_t, int>> further;  // the same of all of the cords,
    bool about_each = true;                            // which were not too many
  };

  void look_around(Lookout& lookout, std::span<const Look> looks, std::size_t first, std::size_t last);
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

}  // namespace engine
