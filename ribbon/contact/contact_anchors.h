#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ribbon/convex/slot_row.h"
#include "ribbon/linear/index.h"
#include "ribbon/vec2.h"

namespace ribbon {

/// A point fixed to a body. A dynamic body is an unknown of the solve. One that cannot be pushed (static or
/// kinematic, here called kinematic) has a prescribed motion: in a stage its anchor moves from `start` to `target`.
struct BodyAnchor {
  int center = -1;  ///< slot of the centre of mass, followed by that of the angle; −1 for a kinematic body
  Vec2 arm;         ///< m, from the centre of mass, at the start of the step
  Vec2 current;     ///< m, position; of a dynamic body the one at the start of the step
  // Of kinematic bodies:
  Vec2 body_position;             ///< m, centre of mass at the start of the step
  Vec2 velocity;                  ///< m/s, of the centre of mass
  double angular_velocity = 0.0;  ///< rad/s
  Vec2 start;                     ///< m, position at the start of the stage
  Vec2 target;                    ///< m, position at the end of the stage
  double angle = 0.0;             ///< rad, rotation since the start of the step
  double target_angle = 0.0;      ///< rad, the same at the end of the stage

  bool is_kinematic() const { return center < 0; }
};

/// When the anchors of kinematic bodies are wanted: at the start of the stage, now, or at its end.
enum class KinematicTime { start, current, target };

/// The anchors that contacts refer to by index: first all points of the cords, then points fixed to bodies.
class ContactAnchors {
 public:
  /// Removes all body anchors; the cords have so many points.
  void clear(std::size_t points);
  /// Returns the index of the new anchor. Anchors of one body must follow each other.
  int add(const BodyAnchor& anchor);

  std::size_t size() const { return points_ + bodies_.size(); }
  /// Returns the number of anchors that fit into memory without an allocation.
  std::size_t capacity() const { return points_ + bodies_.capacity(); }
  std::size_t body_capacity() const { return bodies_.capacity(); }
  std::size_t points() const { return points_; }
  std::span<const BodyAnchor> bodies() const { return bodies_; }
  bool is_point(int anchor) const { return at(anchor) < points_; }
  bool is_dynamic(int anchor) const { return !is_point(anchor) && !body(anchor).is_kinematic(); }
  bool is_kinematic(int anchor) const { return !is_point(anchor) && body(anchor).is_kinematic(); }
  /// Returns the body anchor of that index. The anchor must not be a point.
  const BodyAnchor& body(int anchor) const { return bodies_[at(anchor) - points_]; }
  std::size_t body_index(int anchor) const { return at(anchor) - points_; }

  /// Sets `positions` [m] by anchor from x, the positions by slot of points and bodies.
  void positions(std::span<const Vec2> x, KinematicTime time, std::vector<Vec2>& positions) const;
  /// Returns the group that the anchor belongs to, −1 for a kinematic body. Groups are given by slot.
  int group(int anchor, std::span<const int> group_of) const;

  /// Starts a stage: kinematic bodies are to move from where they are to where they are `time` [s] after the start of
  /// the step.
  void set_kinematic_targets(double time);
  /// Moves kinematic bodies by this fraction, 0 … 1, of the rest of their motion in the stage.
  void advance_kinematics(double fraction);
  /// Moves kinematic bodies to where they are `time` [s] after the start of the step.
  void place_kinematics(double time);
  /// Returns the time until which they have moved, s since the start of the step.
  double time() const { return time_; }

 private:
  std::size_t points_ = 0;
  std::vector<BodyAnchor> bodies_;
  double time_ = 0.0;         // s, now
  double target_time_ = 0.0;  // s, at the end of the stage
};

/// A state x of the slots, and the positions of all anchors in it.
struct AnchorState {
  const ContactAnchors& anchors;
  std::span<const Vec2> positions;  ///< m, by anchor
  std::span<const Vec2> x;          ///< by slot

  Vec2 operator[](int anchor) const { return positions[static_cast<std::size_t>(anchor)]; }
  /// Returns the vector from the centre of mass of the anchor's body to the anchor [m]; zero unless it is dynamic.
  Vec2 lever(int anchor) const {
    if (!anchors.is_dynamic(anchor)) return {};
    return (*this)[anchor] - x[static_cast<std::size_t>(anchors.body(anchor).center)];
  }
  /// Adds the derivative by the anchor's position to a row; `lever` is the one with which the anchor turns, m.
  void add_derivative(SlotRow& row, int anchor, Vec2 by, Vec2 lever) const {
    if (anchors.is_point(anchor)) {
      row.add(anchor, by);
    } else if (const int center = anchors.body(anchor).center; center >= 0) {
      row.add(center, by);
      row.add(center + 1, {cross(lever, by), 0.0});
    }
  }
};

}  // namespace ribbon
