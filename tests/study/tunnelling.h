#pragma once

#include <box2d/box2d.h>

#include <string>
#include <vector>

#include "ribbon/box2d/coupling.h"

namespace study {

/// What a cord crossed, as bits.
enum Crossed : unsigned char {
  through_body = 1,    ///< a circle, edge or polygon
  through_itself = 2,  ///< a cord that declares self_contact, or one of the thesis
  through_cord = 4,    ///< another cord, if both declare cord_contact or are of the thesis
};

/// By cord, after a tick.
using Crossings = std::vector<unsigned char>;

/// Returns what a cord must not cross: bodies, and the objects of declared contacts.
unsigned char declared_contacts(const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord);

/// Detects after every tick what cords crossed. Penetration alone does not count. A middle line crosses a body if
/// it crosses an edge, is deeper in a polygon than half the cord's thickness, is as near to a circle's centre, or if
/// the centre of a circle or polygon crosses it on its straight path from one tick to the next. Links at a driven point
/// are excluded, and the body that holds the cord, which does not collide with it: a slack rope above a gate that it
/// hangs from folds into the gate.
class TunnellingDetector {
 public:
  /// `filter` is that of the cords.
  Crossings detect(const b2World& world, const ribbon::box2d::Coupling& coupling, const b2Filter& filter);
  /// Clears the earlier positions, for a new world.
  void reset() { before_ = {}; }

  /// The positions at a moment: the cords' middle lines, and the centres of fixtures that they collide with.
  struct Moment {
    std::vector<std::vector<ribbon::Vec2>> lines;
    std::vector<ribbon::Vec2> centers;
  };

 private:
  Moment before_;
};

/// Returns whether the link from a to b passes the point c while all three move straight from `before` to `after`.
struct LinkAndPoint {
  ribbon::Vec2 a, b, c;
};
bool crosses(const LinkAndPoint& before, const LinkAndPoint& after);

/// Returns the first tunnelling of a run that its reference does not have: "cord 2 went through a body in tick 31"; or
/// empty. In the first `ticks` the reference may show the same up to a quarter of a second earlier or later; after
/// them, where both motions are chaotic, at any time. `declared` has for each cord what it must not cross.
std::string tunnelling_failure(const std::vector<Crossings>& run, const std::vector<Crossings>& reference,
                               const Crossings& declared, std::size_t ticks);

}  // namespace study
