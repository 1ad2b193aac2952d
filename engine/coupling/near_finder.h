#pragma once

#include <box2d/box2d.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "ribbon/box.h"
#include "ribbon/box2d/coupling_types.h"
#include "ribbon/box2d/leaf_search.h"
#include "ribbon/box2d/remembered_search.h"
#include "ribbon/parallel_for.h"
#include "ribbon/vec2.h"

namespace ribbon::box2d {

/// A search for the fixtures near one cord.
struct NearQuery {
  Box swept_aabb;                   ///< m, box that the cord can reach in the tick
  b2Filter filter;                  ///< filter of the cord, as between two Box2D fixtures
  bool circles_only;                ///< find circles only, for the thesis's solver
  bool rests;                       ///< the box is the same in the next tick, in most cases
  std::vector<NearShape>* near;     ///< results are appended here, in any order and possibly twice
  std::vector<NearShape>* sensors;  ///< and sensors of any shape here
};

/// Returns whether all values of a body are finite and in range.
bool is_sound(const b2Body& body);
/// Returns whether in addition the body is not a dynamic body without mass.
bool can_be_met(const b2Body& body);

/// Finds the fixtures that cords may touch in a tick, by queries of the world's broad phase. Static fixtures are found
/// where they are, others along their motion. Box2D moves a body by at most b2_maxTranslation per tick, so fixtures
/// that are further away are left to later ticks. What it remembers of a tick changes no result of the next one, only
/// the time.
class NearFinder {
 public:
  /// Reserves memory for so many tree leaves near a cord and for so many cords.
  void reserve(std::size_t leaves, std::size_t cords);
  /// Runs all queries for a tick of dt seconds under `gravity` [m/s²]. Each query must have its own result list.
  void find(b2World& world, std::span<const NearQuery> queries, Vec2 gravity, double dt,
            const ParallelFor& parallel_for);

 private:
  /// A leaf near a cord.
  struct Found {
    const b2FixtureProxy* proxy;
    const NearQuery* query;
  };
  /// The memory and the results of one task, which runs some of the queries.
  struct Task {
    LeafSearch search;
    // Of a group of cords: the boxes in which bodies can be near that do not move, and others.
    std::array<SearchBox, LeafSearch::max_boxes> at_rest;
    std::array<SearchBox, LeafSearch::max_boxes> moving;
    std::vector<Found> found;                          // near a group of cords
    std::vector<std::pair<std::size_t, int>> distant;  // query, and leaf that is near the cord only if its body moves
    bool lists_distant = true;                         // there are few enough of them to test each
  };
  /// What is remembered of a group of neighbouring queries.
  struct Group {
    RememberedSearch search;
    bool lists_distant = false;  // it was a search for the boxes in which moving bodies can be
    int failures = 0;            // times in sequence that it was of no use
    int pause = 0;               // ticks in which it is not remembered, because that was of no use
  };

  void run(Task& task, const BroadPhaseTree& tree, std::span<const NearQuery> queries, std::size_t first,
           std::size_t last);
  void run_group(Task& task, Group& group, const BroadPhaseTree& tree, std::span<const NearQuery> queries,
                 std::size_t first);
  void take_leaf(Task& task, const BroadPhaseTree& tree, std::span<const NearQuery> queries, std::size_t first,
                 int leaf, BoxSet boxes) const;
  void test_found(Task& task) const;
  bool is_far_from_all(const Task& task, const BroadPhaseTree& tree, std::span<const NearQuery> of_group) const;
  void test_moving_bodies(b2World& world, std::span<const NearQuery> queries);
  void sort_by_x(std::span<const NearQuery> queries);
  void test_moving_fixture(std::span<const NearQuery> queries, b2Fixture& fixture, int child);

  double dt_ = 0.0;              // s
  double fall_ = 0.0;            // m, g·dt²
  std::size_t max_distant_ = 0;  // leaves that one task may list
  bool lists_distant_ = true;    // tasks begin to list them
  int ticks_without_list_ = 0;   // since there were too many
  bool is_recount_ = false;      // of them: a single tick, for which nothing is remembered
  std::vector<Task> tasks_;
  std::vector<Group> groups_;
  std::vector<std::size_t> by_x_;      // queries, by the left side of their boxes
  double max_width_ = 0.0;             // m, of these boxes
  std::vector<const b2Body*> walked_;  // addresses of the bodies in the last walk, only to fetch them from memory
};

}  // namespace ribbon::box2d
