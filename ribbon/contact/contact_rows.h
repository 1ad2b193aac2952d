#pragma once

#include <span>
#include <vector>

#include "ribbon/contact/contact_anchors.h"
#include "ribbon/contact/contact_pairs.h"
#include "ribbon/convex/slot_row.h"

namespace ribbon {

/// Returns δd, the derivative of the distance of a pair. `gap` is that distance in a state, or in an earlier one about
/// which the contact is linearised.
SlotRow normal_row(const AnchorState& state, const ContactPair& pair, const Separation& gap);
/// Returns the derivative of the slip: how far the disc moves along the segment. The lever of a body ends at the axis
/// of the cord, because points of a cord cannot take a torque.
SlotRow tangent_row(const AnchorState& state, const ContactPair& pair, const Separation& gap);
/// Returns d·E/L − U, with E, L and U as in ribbon/geometry/separation.h. It is the part of
///
///     −δ²d = ((d·E/L − U)² − U²)/d
///
/// that leaves the Hessian positive semidefinite.
SlotRow rotation_row(const AnchorState& state, const ContactPair& pair, const Separation& gap);
/// Returns the slots that the pair couples, with derivatives of zero.
SlotRow slots_of(const ContactAnchors& anchors, const ContactPair& pair);

/// The state at the start of a substep, from which slip is measured.
class SlipReference {
 public:
  void set(const ContactAnchors& anchors, std::span<const Vec2> x);
  /// Returns the elongation of the friction spring, m: what is left from before the substep and the slip since then,
  /// along a tangent_row, with what a surface that moves along itself has moved.
  double elongation(const AnchorState& state, const ContactPair& pair, const Separation& gap,
                    const SlotRow& tangent) const;

 private:
  std::vector<Vec2> positions_;  // m, by anchor
  std::vector<Vec2> slots_;
  std::vector<double> angles_;  // rad, by body anchor
  double time_ = 0.0;           // s, since the start of the step
};

}  // namespace ribbon
