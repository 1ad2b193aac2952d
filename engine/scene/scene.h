#pragma once

#include <box2d/box2d.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/scene/scene_paths.h"
#include "engine/scene/tiled_map.h"
#include "ribbon/box2d/coupling.h"
#include "ribbon/box2d/state_hash.h"
#include "ribbon/weather.h"

namespace engine {

/// The class of the object that a body was built from.
enum class BodyKind : unsigned char { ground, circle, load };
struct SceneBody {
  b2Body* body = nullptr;
  BodyKind kind = BodyKind::ground;
  int object = 0;          ///< id of the object in the map
  bool is_sticky = false;  ///< its property sticky, which is for the caller: something can be fixed to it
};

/// A wheel that was built from an object of the map, in the order in which cords and their wheels were built.
struct SceneWheel {
  ribbon::box2d::PulleyId pulley = 0;
  int object = 0;  ///< id of the object in the map
};
struct WheelDefinition;

/// A Box2D world with its cords, built from the objects of a map. The classes and their properties:
/// - `ground`: rectangle or convex polygon of at most 8 corners, static; friction, sticky.
/// - `circle`: ellipse with equal axes; body (static, kinematic, dynamic), density [kg/m²], friction, restitution,
///   angular_damping [1/s], velocity_x, velocity_y [m/s], spin [rad/s], gravity_scale (−100 … 100, 1 by default; below
///   0 it rises, as a balloon), cord (optional: as of a load), path (optional: the path that it follows, within 0.25 m
///   of its centre; then it is kinematic and has no velocity of its own), speed [m/s, along the path; 0.01 … 100],
///   sticky.
/// - `path`: a polyline, which is followed back and forth, or a polygon, which is followed round and round.
/// - `load`: rectangle, or ellipse with equal axes, dynamic; mass [kg], friction, restitution, angular_damping [1/s],
///   gravity_scale, sticky, cord (optional: the cord or ribbon whose nearer end it holds, within 0.5 m of its rim).
/// - `anchor`: point; pins the nearest cord point within 0.25 m; cord (optional: only points of this cord), body
///   (optional: the ground, circle or load that holds the point there and takes it along).
/// - `tie`: point; ties the nearest point within 0.25 m to that of another cord, both of the direct solver; cord,
///   other_cord (optional: only points of these cords), breaking_force [N; 0, the default, for a tie that holds].
/// - `cord`: polyline of its middle line; solver ("direct", the default, or "thesis"); columns (number of points along
///   it), rows, mass [kg, total], drag [1/s], substeps, pin_first, pin_last (pin the points of the first or last
///   column), solid (collides with all fixtures, also those that the cord filter excludes).
///   - "thesis" (ribbon/thesis/thesis_def.h), by default 2 rows: spring_stiffness [N/m], bar_damping [N·s/m],
///     area_stiffness, self_collision.
///   - "direct" (ribbon/cord_def.h), by default 1 row: stretch_stiffness [N; a rope without it is inextensible, a
///     ribbon requires it], bending_stiffness [N·m²], poisson_ratio, area_stiffness, damping [s], gravity_scale (1 by
///     default), drag_across, drag_along, displaced_area [m²] (what the weather of the map acts on; 0 by default),
///     tension_only, breaking_force [N; 0, the default, for a cord that does not break], radius [m], width [m, by
///     default that of square cells], friction, restitution, self_contact, cord_contact (with other cords that declare
///     it), allow_sleep, accuracy ("fast", "balanced", the default, or "accurate"), and overrides of it: integrator
///     ("tr_bdf2", "implicit_euler"), substeps, tolerance [m], max_work, max_iterations (Newton steps per solve),
///     soft_contacts (by default true for implicit_euler), at_rest (it starts as it hangs from its pins, instead of
///     along the polyline; not with wheels). All links are straight and of equal length, so the cord is a little
///     shorter than a polyline with corners.
/// - `ribbon`: like cord with 2 rows or more, by default 3.
/// - `wheel`: ellipse with equal axes, the groove of a pulley; cord (the rope of the direct solver that runs around it,
///   whose polyline has one corner at each of its wheels and no other between its ends), body (optional: the ground,
///   circle or load that carries it), turns, inertia [kg·m²], friction (without it the cord does not slip),
///   motor_speed [rad/s], motor_torque [N·m] (ribbon/pulley.h). The rope is laid taut around its wheels. A wheel
///   without a body is a static disc that bodies meet.
/// A map has at most 2000 objects, and 100,000 points in all cords. Its own property gravity_y [m/s²] is −9.81 by
/// default; with wind_x, water_level and others it defines a weather (scene_weather.h, ribbon/weather.h).
class Scene {
 public:
  /// `other_kinds` and `other_properties`: classes and map properties that the caller handles. `cord_filter`: the
  /// collision filter of cords that are not solid; bodies have Box2D's default filter. Throws MapError for any other
  /// class, and for an object, property or value that cannot be built.
  explicit Scene(const TiledMap& map, const std::vector<std::string>& other_kinds = {},
                 const b2Filter& cord_filter = {}, const std::vector<std::string>& other_properties = {});
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  b2World& world() { return world_; }
  const b2World& world() const { return world_; }
  ribbon::box2d::Coupling& coupling() { return coupling_; }
  const ribbon::box2d::Coupling& coupling() const { return coupling_; }

  /// The bodies in the order of the map.
  std::span<const SceneBody> bodies() const { return bodies_; }
  std::span<const SceneWheel> wheels() const { return wheels_; }
  /// Returns the weather of the map, the medium of its cords; nothing if it has none.
  const std::optional<ribbon::Weather>& weather() const { return weather_; }
  /// Returns the id of the object that a cord or its uncut cord was built from, which is its user data; 0 for cords
  /// that were added later and for those that do not exist.
  int cord_object(ribbon::box2d::CordId cord) const;

  /// The circles that follow paths. Their time is part of the state.
  const Rides& rides() const { return rides_; }
  Rides& rides() { return rides_; }

  /// Advances the cords and the world by one tick of `dt` s: Coupling::tick. Circles are on their paths then.
  void tick(double dt);

  /// Adds all cords and all bodies, in the order of creation, to a state hash. Copies the cords to scratch memory:
  /// allocates only on the first call.
  void add_to(ribbon::box2d::StateHash& hash);

  /// The solver of cords without the property.
  static constexpr ribbon::box2d::Solver default_solver = ribbon::box2d::Solver::direct;
  static constexpr int velocity_iterations = 8;
  static constexpr int position_iterations = 3;

 private:
  void build(const MapObject& object, const TiledMap& map, const std::vector<std::string>& other_kinds);
  void add_cord_to(ribbon::box2d::StateHash& hash, ribbon::box2d::CordId cord);
  void build_cord(const MapObject& object, const TiledMap& map, const b2Filter& filter,
                  std::vector<WheelDefinition>& wheels);
  void hang_wheel(const WheelDefinition& wheel, const TiledMap& map);
  void fix_anchor(const MapObject& object, const TiledMap& map);
  void hang_load(const MapObject& object, const TiledMap& map);
  void tie_cords(const MapObject& object, const TiledMap& map);
  ribbon::box2d::CordPoint end_of_tie(const MapObject& object, const TiledMap& map, const char* property,
                                      std::optional<ribbon::box2d::CordId> except) const;
  b2Body& named_body(const MapObject& object, const TiledMap& map) const;
  ribbon::box2d::CordId named_cord(const MapObject& object, const TiledMap& map, const char* property = "cord") const;
  std::optional<ribbon::box2d::CordPoint> nearest_of(ribbon::box2d::CordId cord, ribbon::Vec2 position,
                                                     double max_distance) const;

  b2World world_;
  std::optional<ribbon::Weather> weather_;
  ribbon::box2d::Coupling coupling_;
  std::vector<SceneBody> bodies_;
  std::vector<SceneWheel> wheels_;
  Rides rides_;
  std::vector<int> cord_objects_;  // by cord, as built
  ribbon::Cord::State hashed_;     // scratch of add_to
  ribbon::ThesisCord::State hashed_thesis_;
};

}  // namespace engine
