#pragma once

#include <box2d/box2d.h>

#include <string>
#include <vector>

#include "ribbon/box2d/coupling.h"

namespace study {

/// What a cord went through, as bits.
enum Passage : unsigned char {
  through_body = 1,    ///< a circle, edge or polygon
  through_itself = 2,  ///< a cord that declares self_contact, or one of the thesis's
  through_cord = 4,    ///< another one, where both declare cord_contact or are the thesis's
};

/// By cord, after a tick.
using Passages = std::vector<unsigned char>;

/// What cords must not go through: bodies, and what they declare contact with.
Passages declared_contacts(const ribbon::box2d::Coupling& coupling);

/// Looks after every tick for what cords went through. What only sinks in does not count: a middle line that crosses an
/// edge, is deeper in a polygon than half the cord's thickness, or nearer to a circle's centre does; and so does one
/// that the centre of a circle or polygon crossed on the straight way from one tick to the next. Links at a point that
/// is driven may be anywhere.
class PassageWatch {
 public:
  /// `filter` is that of the cords.
  Passages look(const b2World& world, const ribbon::box2d::Coupling& coupling, const b2Filter& filter);
  /// Of what was seen before: the next world is a new one.
  void forget() { before_ = {}; }

  /// The positions at a moment: the cords' middle lines, and the centres of fixtures that they collide with.
  struct Moment {
    std::vector<std::vector<ribbon::Vec2>> lines;
    std::vector<ribbon::Vec2> centers;
  };

 private:
  Moment before_;
};

/// Whether the link from a to b passed the point c on the straight ways from `before` to `after` that all three go.
struct PassingLink {
  ribbon::Vec2 a, b, c;
};
bool passes(const PassingLink& before, const PassingLink& after);

/// What a run let through and its reference did not, in words: "cord 2 went through a body in tick 31"; or empty. In
/// the first `ticks` the reference may show the same a quarter of a second earlier or later; after them, where what
/// both do is chance, at any time.
/// `declared` has of each cord what it must not go through.
std::string let_through(const std::vector<Passages>& run, const std::vector<Passages>& reference,
                        const Passages& declared, std::size_t ticks);

}  // namespace study
