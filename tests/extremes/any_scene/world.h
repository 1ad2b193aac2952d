#pragma once

#include <box2d/box2d.h>

#include <utility>
#include <vector>

#include "ribbon/box2d/coupling.h"
#include "tests/extremes/any_scene/geometry.h"
#include "tests/extremes/any_scene/scene.h"

namespace any_scene {

/// The positions of all objects after a tick, as input of the oracles.
struct Snapshot {
  std::vector<Outline> cords;
  std::vector<Pose> solids;
  std::vector<char> pressed;       ///< by solid: whether Box2D pushes it, because it touches another solid
  std::vector<ribbon::Vec2> ties;  ///< m, where cords are tied: there they lie in each other
};

/// A scene in Box2D's world with its cords.
class World {
 public:
  /// Throws ribbon::DefinitionError for a scene with an invalid number.
  explicit World(const Scene& scene);
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  /// Drives what the scene drives in a tick. Returns whether a cord was cut, tied or untied.
  bool drive(int number);
  /// Ends all that drives, and with it all that is impossible: what is dragged is let go, and so is what kinematic
  /// bodies hold; these, belts, motors and climbers stop; what was reeled in is paid out again.
  void calm_down();
  /// Takes one tick; returns the milliseconds of Coupling::step.
  double tick();
  /// Returns the share of the points of cords that moved in the last tick.
  double moved_share() const { return moved_share_; }
  /// Returns whether points that were tied while apart are being drawn together, which does work.
  bool draws_together() const;
  /// Returns whether a link broke in the last tick.
  bool has_broken() const;
  /// Returns whether all of a cord became dust then.
  bool has_lost_a_cord() const;
  /// Returns a scene with the cords that there are now, and what holds them, for the oracles.
  Scene present_scene() const;

  const ribbon::box2d::Coupling& coupling() const { return coupling_; }
  Snapshot snapshot() const;
  /// The energy of cords and dynamic bodies, J.
  struct Energy {
    double total = 0.0;
    double kinetic = 0.0;
    double box2d = 0.0;  ///< the part of `total` that world.Step added since the start to bodies that no cord moves
  };
  Energy energy() const;
  double weight() const;         ///< N, of all that moves
  ribbon::Vec2 heights() const;  ///< m, the lowest and the highest place of all that moves
  double fastest() const;        ///< m/s, of points of cords
  /// A pulley, and whether Box2D pushes what carries it.
  struct Reeving {
    ribbon::box2d::PulleyState pulley;
    bool pressed = false;
  };
  std::vector<Reeving> reevings() const;
  bool is_finite() const;
  /// The greatest distance between a hand and the place that it holds, m, without grips that slipped off an end:
  /// of solver-driven bodies, and of bodies that Box2D has pushed away since.
  struct Gaps {
    double free = 0.0;
    double pressed = 0.0;
  };
  Gaps grip_gaps() const;

 private:
  void add(const Solid& solid);
  void add(const SceneCord& cord, Preset preset);
  void add(const Wheel& wheel);
  void add(const Hold& hold);
  bool cut(const Cut& cut);
  bool tie(const Knot& knot);
  bool has_slipped_off(ribbon::box2d::CordId id, double arc, const Hold& hold) const;
  double gap(std::size_t hold) const;
  void update_pushed_bodies();
  void store_starts();
  void find_moved_share();
  struct Moving;
  double energy(const b2Body& body, const Moving& moving) const;
  Moving now(const b2Body& body) const;
  double energy_of_free_bodies(const ribbon::box2d::CouplingState& planned) const;
  double work_on_moved_bodies(const ribbon::box2d::CouplingState& planned) const;

  /// Makes belts of the solids that have a speed.
  struct Belts : ribbon::box2d::ContactListener {
    bool pre_solve(ribbon::box2d::CordId cord, const b2Fixture& fixture, ribbon::box2d::Surface& surface) override;
    std::vector<std::pair<const b2Fixture*, double>> speeds;
  };

  const Scene scene_;
  Belts belts_;
  b2World world_;
  ribbon::box2d::Coupling coupling_;
  std::vector<b2Body*> bodies_;
  std::vector<ribbon::box2d::GripId> grips_;
  std::vector<ribbon::box2d::PulleyId> pulleys_;
  std::vector<char> pushed_;  // by hold: Box2D has pushed its solid and the gap has not closed since
  std::vector<ribbon::Vec2> drag_starts_;
  std::vector<ribbon::box2d::TieId> ties_;
  std::vector<std::vector<ribbon::Vec2>> starts_;  // m, by cord: where its points were before the tick
  double moved_share_ = 0.0;
  double box2d_work_ = 0.0;  // J
};

}  // namespace any_scene
