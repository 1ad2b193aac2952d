#pragma once

#include <box2d/box2d.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "ribbon/box2d/coupling.h"
#include "ribbon/box2d/coupling_types.h"
#include "ribbon/vec2.h"

namespace ribbon::box2d {

/// Which cords a query finds.
struct QueryFilter {
  std::uint16_t mask = 0xFFFF;          ///< bits, of which the category of the cord's filter must have one
  std::span<const CordId> except = {};  ///< cords that are not found
};

/// Where a ray meets a cord.
struct RayHit {
  CordId cord = 0;        ///< the cord
  int point = 0;          ///< index of the point at the hit, or of the one before it
  double along = 0.0;     ///< position between this point and the one in the next column, 0 … 1
  double fraction = 0.0;  ///< 0 … 1, of the ray; 0 if it begins in the cord
  Vec2 position;          ///< m
  Vec2 normal;            ///< unit vector, out of the cord; against the ray if that begins in the cord
};

/// Finds cords along a ray, in a shape or near a place. A rope is its links with their thickness; a ribbon is its
/// outline. Call update after each tick in which you ask: the queries refer to the positions at that time.
///
/// The results do not depend on earlier updates. Of several equal results, the one of the first cord and point is
/// returned. A query takes O(log n) for n links and allocates no memory. An update takes O(n), and allocates if cords
/// were added, removed or changed in size.
class CordQueries {
 public:
  CordQueries();
  CordQueries(CordQueries&& other) noexcept;
  CordQueries& operator=(CordQueries&& other) noexcept;
  ~CordQueries();

  /// Reads the positions of all enabled cords.
  void update(const Coupling& coupling);

  /// Returns where the ray between two points [m] first meets a cord, or nothing. If both points are the same, a hit
  /// means that the point is in a cord. Throws DefinitionError for a coordinate beyond ±1e9.
  std::optional<RayHit> ray_cast(Vec2 from, Vec2 to, const QueryFilter& filter = {}) const;
  /// Returns the nearest place on a cord within `reach` [m, 0 … 1e9] of `position` [m]; its distance is that to the
  /// middle line of a rope. Throws likewise.
  std::optional<CordPoint> nearest_place(Vec2 position, double reach, const QueryFilter& filter = {}) const;
  /// Writes the cords that a shape overlaps to `found`, by id, each with one place in the shape.
  void find_overlaps(const b2Shape& shape, const b2Transform& transform, std::vector<CordPoint>& found,
                     const QueryFilter& filter = {}) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace ribbon::box2d
