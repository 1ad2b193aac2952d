#pragma once

#include <box2d/box2d.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/scene/tiled_map.h"
#include "ribbon/box2d/coupling.h"
#include "ribbon/box2d/state_hash.h"

namespace engine {

/// What a body of a scene was made from.
enum class BodyKind : unsigned char { ground, circle, load };
struct SceneBody {
  b2Body* body = nullptr;
  BodyKind kind = BodyKind::ground;
  int object = 0;  ///< its id in the map
};

/// A Box2D world with its cords, built from a map's objects of class
/// - `ground`: rectangle or convex polygon of at most 8 corners, static; friction.
/// - `circle`: ellipse as wide as high; body (static, kinematic, dynamic), density [kg/m²], friction, restitution,
///   angular_damping [1/s], velocity_x, velocity_y [m/s], spin [rad/s].
/// - `load`: rectangle, or ellipse as wide as high, dynamic; mass [kg], friction, restitution, angular_damping [1/s],
///   cord (the cord or ribbon whose nearer end it holds, if any, within 0.5 m of its rim).
/// - `anchor`: point; it constrains the nearest cord point within 0.25 m; cord (which one, if not any).
/// - `cord`: polyline that its middle line follows; solver ("direct", the default, or "thesis"); columns (how many
///   points along it), rows, mass [kg, all of it], drag [1/s], substeps, pin_first, pin_last (the points of the first
///   or last column are constrained), solid (it meets every fixture, also those that the game keeps from cords).
///   - "thesis" (ribbon/thesis/thesis_def.h), 2 rows unless given: spring_stiffness [N/m], bar_damping [N·s/m],
///     area_stiffness, self_collision.
///   - "direct" (ribbon/cord_def.h), 1 row unless given: stretch_stiffness [N, a rope without it does not stretch, a
///     ribbon needs one], bending_stiffness [N·m²], poisson_ratio, area_stiffness, damping [s], tension_only, radius
///     [m], width [m, that of square cells unless given], friction, restitution, self_contact, cord_contact (with other
///     cords that declare it), allow_sleep, accuracy ("fast", "balanced" unless given, "accurate"), and what is to be
///     otherwise in it: integrator ("tr_bdf2", "implicit_euler"), substeps, tolerance [m], max_work, max_iterations (of
///     Newton's a solve), soft_contacts (true for implicit_euler unless given). Its links are all straight and equal,
///     so that it is a little shorter than a polyline with corners.
/// - `ribbon`: the same, with 3 rows unless given, 2 or more.
/// At most 2000 objects, and 100,000 points of all cords together. The map's own property gravity_y [m/s²] is −9.81
/// unless given.
class Scene {
 public:
  /// `other_kinds` and `other_properties` are the classes, and the properties of the map itself, that the caller takes
  /// care of; `cord_filter` says which fixtures the cords meet that are not solid. Bodies have Box2D's default filter.
  /// Throws MapError for any other class, and for an object, property or value that cannot be built.
  explicit Scene(const TiledMap& map, const std::vector<std::string>& other_kinds = {},
                 const b2Filter& cord_filter = {}, const std::vector<std::string>& other_properties = {});
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  b2World& world() { return world_; }
  const b2World& world() const { return world_; }
  ribbon::box2d::Coupling& coupling() { return coupling_; }
  const ribbon::box2d::Coupling& coupling() const { return coupling_; }

  /// In the order in which they were made, which is the map's.
  std::span<const SceneBody> bodies() const { return bodies_; }
  /// The id of the object that a cord was made from; 0 for one that was added since.
  int cord_object(ribbon::box2d::CordId cord) const;

  /// One tick: the cords take from the world what is near them, move, push, and then the world moves.
  void tick(double dt);

  /// Adds every cord and every body, bodies in the order they were made, to a state hash. Cords are
  /// copied on the way, into memory that is kept: after the first time it takes none.
  void add_to(ribbon::box2d::StateHash& hash);

  /// Of cords that do not ask for one.
  static constexpr ribbon::box2d::Solver default_solver = ribbon::box2d::Solver::direct;
  static constexpr int velocity_iterations = 8;
  static constexpr int position_iterations = 3;

 private:
  void build(const MapObject& object, const std::vector<std::string>& other_kinds, const b2Filter& cord_filter);
  void add_cord_to(ribbon::box2d::StateHash& hash, ribbon::box2d::CordId cord);
  void build_cord(const MapObject& object, const b2Filter& filter);
  void fix_anchor(const MapObject& object, const TiledMap& map);
  void hang_load(const MapObject& object, const TiledMap& map);
  ribbon::box2d::CordId named_cord(const MapObject& object, const TiledMap& map) const;
  std::optional<ribbon::box2d::CordPoint> nearest_of(ribbon::box2d::CordId cord, ribbon::Vec2 position,
                                                     double reach) const;

  b2World world_;
  ribbon::box2d::Coupling coupling_;
  std::vector<SceneBody> bodies_;
  std::vector<int> cord_objects_;  // by cord
  ribbon::Cord::State hashed_;     // of the cord that was hashed last
  ribbon::ThesisCord::State hashed_thesis_;
};

}  // namespace engine
