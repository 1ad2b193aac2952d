#pragma once

#include <box2d/box2d.h>

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "engine/scene/scene.h"
#include "engine/tick/input.h"
#include "game/lab/joint_chain.h"
#include "game/simulation/drag.h"
#include "ribbon/box2d/coupling.h"

namespace game::lab {

/// What the ropes of a bench are.
enum class Method : std::uint8_t {
  cords,   ///< cords of this library
  chains,  ///< chains of Box2D's joints with the same links
};

/// A disc of a bench.
struct Disc {
  b2BodyType type = b2_dynamicBody;
  ribbon::Vec2 at;          ///< m
  double radius = 0.1;      ///< m
  double mass = 1.0;        ///< kg, of a dynamic body
  double friction = 0.0;    ///< coefficient
  bool meets_cords = true;  ///< else it collides with bodies alone
  double damping = 0.0;     ///< 1/s, of its motion and its rotation
};

/// One Box2D world of an experiment, of 60 ticks a second, with its cords: or, so that one scene is built with both,
/// with chains of Box2D's joints in place of its ropes. It draws nothing and knows no clock.
class Bench {
 public:
  static constexpr int ticks_per_second = 60;
  static constexpr double dt = 1.0 / ticks_per_second;      ///< s
  static constexpr ribbon::Vec2 earth_gravity{0.0, -9.81};  ///< m/s²

  explicit Bench(Method method, ribbon::Vec2 gravity = earth_gravity);
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;

  // To build it. Throw ribbon::DefinitionError for values out of range.

  /// Adds a rope or ribbon at the definition's positions. A chain must be a rope.
  void add(const ribbon::CordDef& def);
  /// Adds a cord of the thesis's method.
  void add(const ribbon::ThesisDef& def);
  b2Body& add(const Disc& disc);
  /// Adds a body of static edges from corner to corner.
  void add_edges(std::span<const ribbon::Vec2> corners, double friction);
  /// Makes a body hold a point of a rope where the point is now.
  void hold(int rope, int point, b2Body& body);

  /// Runs a tick. The input is the pointer with button_drag (game/simulation/buttons.h): what is nearest to the pointer
  /// when the button goes down follows it.
  void tick(const engine::TickInput& input);

  /// Ends a drag, as a tick without button_drag would before anything moves.
  void let_go() { drag_.release(coupling_); }

  // Changes of what is there already. Positions and velocities stay.

  void set_accuracy(const ribbon::Accuracy& accuracy);
  /// Sets the number of steps of a bench of chains per tick, 1 or more.
  void set_chain_substeps(int substeps) { chain_substeps_ = substeps; }
  /// Changes the definition of all cords of the direct solver.
  void change_cords(const std::function<void(ribbon::CordDef& def)>& change);
  /// The same for cords of the thesis's method.
  void change_thesis_cords(const std::function<void(ribbon::ThesisDef& def)>& change);
  /// Sets the friction of all cords and bodies.
  void set_friction(double friction);
  /// Sets the mass of a disc, kg.
  void set_mass(b2Body& disc, double mass) const;

  Method method() const { return method_; }
  b2World& world() { return world_; }
  const b2World& world() const { return world_; }
  ribbon::box2d::Coupling& coupling() { return coupling_; }
  const ribbon::box2d::Coupling& coupling() const { return coupling_; }
  std::span<const JointChain> chains() const { return chains_; }
  /// Returns the definitions of ropes and ribbons as they were added, with their positions.
  std::span<const ribbon::CordDef> definitions() const { return definitions_; }
  /// Returns the bodies that can be dragged, in the order of adding.
  std::span<const engine::SceneBody> bodies() const { return bodies_; }
  const Drag& drag() const { return drag_; }

 private:
  Method method_;
  b2World world_;
  ribbon::box2d::Coupling coupling_;
  std::vector<JointChain> chains_;
  std::vector<ribbon::CordDef> definitions_;
  std::vector<engine::SceneBody> bodies_;
  b2Body* ground_ = nullptr;  // holds the pinned points of chains
  Drag drag_;
  int chain_substeps_ = 1;
};

}  // namespace game::lab
