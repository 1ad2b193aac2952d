#pragma once

#include <box2d/b2_world.h>

#include <memory>

namespace ribbon::box2d {

/// State of a Box2D world between two steps, as far as Box2D 2.4 lets it be read and written, to go back by some ticks.
/// Box2D has no snapshots, and a part of its state is private. So a world that went back continues with nearly the same
/// motion, and often, but not always, with the same bits. "Going back" in ribbon/guide.md says what
/// differs and by how much.
///
/// Put back are:
/// - of each body: type, position, angle, velocities, and whether it is enabled and awake;
/// - of each contact: whether it exists and is enabled, the whole manifold with the impulses that start the next solve,
///   friction, restitution and its threshold, tangent speed, and, with the snapshot of the tick before, whether it
///   touches;
/// - the order of the contacts, on which the solver's result depends.
///
/// Not put back are:
/// - how long a body has been at rest (private): it starts anew, so a body may fall asleep up to 0.5 s later;
/// - the impulses of joints (private): they stay those of now;
/// - the tree of the broad phase and its enlarged boxes (private): contacts may be created in another tick or order;
/// - the last bit of the centre of mass of a body whose centre of mass is not its origin;
/// - forces that were applied since the last step, and the state of a step that Box2D did not complete (sub-stepping);
/// - everything else of bodies, fixtures, joints and the world: damping, gravity, filters, shapes, user data. Restore
///   what your game changes.
///
/// A game goes back like this; the cords come last, because they refer to the bodies:
///
///     snapshot.restore(world, &snapshot_of_the_tick_before);
///     coupling.restore(state, world);
class WorldSnapshot {
 public:
  WorldSnapshot();
  WorldSnapshot(WorldSnapshot&& other) noexcept;
  WorldSnapshot& operator=(WorldSnapshot&& other) noexcept;
  ~WorldSnapshot();

  /// Saves the state of a world. It allocates nothing if the snapshot held as many bodies and contacts before. Throws
  /// CallError for a world that is inside its Step. O(bodies + fixtures + contacts).
  void save(const b2World& world);
  /// Puts the state back. `world` may be another one that was built in the same way, with the same bodies and fixtures
  /// in the same order, and made at least one step: the first solve of a world starts without impulses. `before` is the
  /// snapshot of the tick before, or null if there is none: the touching flags of Box2D belong to the positions at the
  /// start of the last step. Without it they are those at the saved positions. No listener is called meanwhile. It
  /// calls b2World::Step with a duration of 0, so forces are cleared. Throws CallError for a world that is inside its
  /// Step, and DefinitionError for one with other numbers of bodies or fixtures; then it changes nothing. O((bodies +
  /// fixtures + contacts)·log).
  void restore(b2World& world, const WorldSnapshot* before = nullptr);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace ribbon::box2d
