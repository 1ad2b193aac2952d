#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ribbon/contact/contact_rows.h"
#include "ribbon/contact/contact_scene.h"
#include "ribbon/linear/block_ldlt.h"

namespace ribbon {

/// A pair in contact, and its separation.
struct ActiveContact {
  std::size_t pair;
  Separation gap;
};

/// The pairs that are in contact in a state (narrow phase): those nearer than their active distance at a local
/// minimum of the distance along the polyline. A vertex is in contact only if it is the nearest point of both segments.
class ActiveContacts {
 public:
  void clear();
  /// Finds the contacts at x, the state at the start of a substep; changed() compares with these.
  void begin_substep(ContactScene& scene, std::span<const Vec2> x);
  /// Finds the contacts at x, unless they were found there last.
  void update(ContactScene& scene, std::span<const Vec2> x);
  /// Finds the contacts at x. Pairs that had a force [N, by pair] remain in contact up to `margin` times the contact
  /// distance further apart.
  void find(ContactScene& scene, std::span<const Vec2> x, std::span<const double> forces, double margin);
  /// Finds the contacts at x.
  void find(ContactScene& scene, std::span<const Vec2> x) { find(scene, x, {}, 0.0); }
  /// Makes the next update() find the contacts again.
  void invalidate() { is_current_ = false; }
  /// Replaces the contacts, at x, by the ones that add() is called for. changed() does not see them.
  void begin_other(const ContactAnchors& anchors, std::span<const Vec2> x);
  void add(const ActiveContact& contact) { active_.push_back(contact); }

  bool any() const { return !active_.empty(); }
  std::span<const ActiveContact> all() const { return active_; }
  std::size_t size() const { return active_.size(); }
  bool is_active(std::size_t pair) const { return is_active_[pair] != 0; }
  /// Returns whether other pairs are in contact than at the start of the substep.
  bool changed() const { return is_active_ != was_active_; }
  /// Returns whether no contact is deeper than a hundredth of its contact distance.
  bool are_shallow(const ContactPairs& pairs) const;
  /// Returns the state x, in which the contacts were found last.
  AnchorState state(const ContactAnchors& anchors, std::span<const Vec2> x) const { return {anchors, positions_, x}; }
  std::span<const Vec2> positions() const { return positions_; }

  /// Returns whether the matrix has all blocks that the contacts couple.
  bool are_coupled(const ContactScene& scene, const BlockLdlt& matrix) const;
  void couple(const ContactScene& scene, BlockLdlt& matrix) const;
  /// Calls visit(slot of the body's centre, slot of the point) for each dynamic body and point in contact.
  template <typename Visit>
  void for_each_body_and_point(const ContactScene& scene, Visit&& visit) const {
    const ContactAnchors& anchors = scene.anchors;
    for (const ActiveContact& contact : active_) {
      const ContactPair& pair = scene.pairs[contact.pair];
      for (const int body : {pair.disc, pair.a, pair.b}) {
        if (!anchors.is_dynamic(body)) continue;
        for (const int point : {pair.disc, pair.a, pair.b}) {
          if (anchors.is_point(point)) visit(anchors.body(body).center, point);
        }
      }
    }
  }

 private:
  bool is_found_at(const ContactAnchors& anchors, std::span<const Vec2> x);

  std::vector<ActiveContact> active_;
  std::vector<char> is_active_;   // by pair
  std::vector<char> was_active_;  // by pair: at the start of the substep
  std::vector<Vec2> positions_;   // m, by anchor, in the state
  std::vector<Vec2> compared_;    // m, by anchor, in the state that is compared with that
  bool is_current_ = false;       // the contacts are those at positions_
};

}  // namespace ribbon
