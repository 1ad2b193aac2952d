#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "ribbon/box.h"
#include "ribbon/collision/motion_bounds.h"
#include "ribbon/collision/stored_touches.h"
#include "ribbon/contact/contacts.h"
#include "ribbon/geometry/quadtree.h"
#include "ribbon/system/island_state.h"

namespace ribbon {

/// Finds the contact pairs of a step: circles and edges of bodies near cords, and cords near each other or themselves.
/// It stores no state between steps, only memory.
class CandidateFinder {
 public:
  /// Adds all pairs that may touch in the step, with the bodies that are solved with the cords, and finds the motion
  /// bounds. Without anything to touch it disables these.
  void find(IslandState& state, MotionBounds& bounds, Contacts& contacts);

 private:
  struct OutlineLink {
    std::size_t member;
    int link;
  };
  /// What the search for one cord works on.
  struct Search {
    IslandState& state;
    const MotionBounds& bounds;
    Contacts& contacts;
    const Member& member;
    const StoredTouches& touches;  // of the member
    double bound;                  // m
    std::span<const Vec2> rest;    // m, of the outline in the straight cord, if it touches itself
  };
  static constexpr std::size_t block = 8;  // neighbouring points or links of an outline that are looked for at once
  /// Boxes of the links of a block, by side, so that all are tested at once. A box that is not set overlaps nothing.
  struct LinkBoxes {
    std::array<double, block> left, right, bottom, top;  // m

    LinkBoxes();
    void set(std::size_t k, const Box& box);
    /// Returns for each link whether its box overlaps another one, as a bit.
    unsigned overlapping(const Box& box) const;
  };
  void sweep_outline(const Search& search);
  void find_circle(const Search& search, const RigidCircle& circle, double longest_link);
  void find_segment(const Search& search, const RigidSegment& segment);
  void find_cords(IslandState& state, const MotionBounds& bounds, Contacts& contacts);
  void box_links(const IslandState& state, const MotionBounds& bounds, Vec2 drift);
  void build_tree();
  void find_block(const Search& search, std::size_t k, Vec2 drift);
  static void find_link(const Search& search, int k, const OutlineLink& link, double other_bound);

  Box swept_aabb_;                     // of the cord whose contacts are looked for, within its bound
  std::vector<Box> outline_boxes_;     // of its outline's points, without the bound
  StoredTouches touches_;              // of that cord
  std::vector<Vec2> rest_positions_;   // of its outline
  std::vector<LinkBoxes> link_boxes_;  // of all links of cords that may touch cords
  std::vector<Box> block_boxes_;       // around each of these blocks
  std::vector<OutlineLink> links_;
  std::unique_ptr<Quadtree> tree_;  // of the blocks
  std::size_t tree_capacity_ = 0;
};

}  // namespace ribbon
