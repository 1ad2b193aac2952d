#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "ribbon/island_cord.h"
#include "ribbon/system/island_state.h"
#include "ribbon/system/tie_groups.h"

namespace ribbon {

/// The grips of an island that slide along their ropes. A rope runs through such a hand as through a ring, which bends
/// it anywhere, not only at its points. In the step a ring is the wheel of a pulley without a size: it takes up the
/// points near it, and a brake on it has the strength of the grip. After the step the nearest of these points is where
/// the hand is, and the rest lengths of its links are those of the parts on both sides, with their masses. So the
/// points show the rope as it runs, and between steps there is no wheel.
///
/// Where there is no ring, a grip slides along the line of its link, as system/slips has it, unless it is in a bend:
/// there it is held. So it is where the rope near the hand is straight, where something may touch it there, near its
/// ends, on ribbons, on ropes that are stiff, touch themselves or have pulleys, on a rope that is heavy beside the
/// body, and in a step that Newton's method does not solve.
class Rings {
 public:
  /// Returns the cords of a step of dt seconds, with rings instead of the grips that slide, if they are allowed. Valid
  /// until the next call.
  std::span<const IslandCord> thread(std::span<const IslandCord> cords, std::span<const TiedPoint> tied,
                                     std::span<const RigidBody> bodies, double dt, bool allowed);
  /// After a substep: finds how much the rope pulls at hands that bends catch.
  static void watch(IslandState& state);
  /// Returns whether grips of cords without rings have begun to slide in an attempt, and may become rings. The next
  /// call of `thread` makes them so.
  bool find_begun(const IslandState& state, std::span<const TiedPoint> tied, std::span<const RigidBody> bodies,
                  double dt);
  /// Begins a step.
  void begin_step() { begun_.clear(); }
  /// Takes the rings off their cords, which are as they were before. Returns the cords of the step without rings.
  std::span<const IslandCord> undo();
  /// Takes the rings off their cords, after these were stored. Each leaves a holder.
  void take_off(const IslandState& state);

 private:
  /// A ring of a cord.
  struct Ring {
    std::size_t member = 0;
    std::size_t grip = 0;  // index in the surroundings that were given
    int taken_up = 0;      // point of the cord
    double column = 0.0;   // where the grip was at the start of the step
    Pulley pulley;
  };

  /// A grip that has begun to slide in this step.
  struct Begun {
    std::size_t member = 0;
    std::size_t grip = 0;
    double runs = 0.0;  // sign of the direction in which the rope runs: 1 towards its end
  };

  /// What a ring changes of a cord before the step.
  struct Before {
    CordParts* cord = nullptr;
    std::vector<Vec2> positions;
    std::vector<Vec2> velocities;
    std::vector<double> masses;
    std::vector<double> rest;
    std::vector<double> rest_targets;
  };

  void find(std::span<const IslandCord> cords, std::size_t member, std::span<const TiedPoint> tied,
            std::span<const RigidBody> bodies, double dt, bool allowed);
  void put_on(IslandCord& cord, std::span<const Ring> rings);
  void save(CordParts& cord);
  static void take_off(const IslandState& state, const Member& member, std::span<const Ring> rings);

  /// Calls f(index of the member, its rings) for each cord that has some.
  template <typename F>
  void for_each_cord(F&& f) const {
    for (auto ring = rings_.begin(); ring != rings_.end();) {
      const std::size_t member = ring->member;
      const auto end = std::find_if(ring, rings_.end(), [member](const Ring& r) { return r.member != member; });
      f(member, std::span<const Ring>(ring, end));
      ring = end;
    }
  }

  std::span<const IslandCord> without_rings_;  // the cords of the step: those given, or plain_
  std::vector<IslandCord> plain_;              // with grips that bends catch
  std::vector<Grip> plain_grips_;              // of the cords with grips that may slip
  std::vector<Ring> rings_;                    // by member, in their order along the cord
  std::vector<IslandCord> cords_;              // with rings
  std::vector<Grip> grips_;                    // of the cords with rings: the others
  std::vector<Axle> axles_;
  std::vector<Begun> begun_;
  std::vector<Before> before_;   // by cord with rings; it keeps its memory
  std::size_t saved_cords_ = 0;  // the first ones of before_
};

}  // namespace ribbon
