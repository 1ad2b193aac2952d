#pragma once

#include <box2d/box2d.h>

#include <optional>
#include <span>

#include "engine/scene/scene.h"
#include "engine/tick/input.h"
#include "ribbon/box2d/state_hash.h"

namespace game {

/// Drags the body or cord point nearest to the pointer. Ground cannot be dragged.
class Drag {
 public:
  static constexpr double cord_range = 1.0;         ///< m, from the pointer to a cord point
  static constexpr double body_range = 0.3;         ///< m, from the pointer to the rim of a body
  static constexpr double max_speed = 15.0;         ///< m/s
  static constexpr double max_pin_speed = 5.0;      ///< m/s, of pins and of static and kinematic bodies
  static constexpr double max_acceleration = 60.0;  ///< m/s², of dynamic bodies of any mass

  /// Runs one tick of `dt` s, before that of the coupling: picks the nearest object when button_drag goes down,
  /// releases it when it goes up. `bodies`: those of the scene; `players`: others that can be dragged too.
  void apply(const engine::TickInput& input, ribbon::box2d::Coupling& coupling,
             std::span<const engine::SceneBody> bodies, std::span<b2Body* const> players, double dt);
  /// Ends a drag, as apply does when button_drag is up.
  void release(ribbon::box2d::Coupling& coupling);
  /// Drops all references, for a scene that no longer exists.
  void forget() { *this = {}; }

  const std::optional<ribbon::box2d::CordPoint>& cord_point() const { return cord_point_; }
  const b2Body* body() const { return body_ ? body_->body : nullptr; }

  void add_to(ribbon::box2d::Hasher& hasher) const;

 private:
  struct Body {
    b2Body* body = nullptr;
    int number = 0;  // index among the bodies of the scene; the players are the last
    double distance = 0.0;
    b2Vec2 at{};                       // the dragged point, in the frame of the body
    b2BodyType type = b2_dynamicBody;  // before the drag
    b2Vec2 velocity{};                 // m/s, before the drag
  };

  void pick(ribbon::Vec2 pointer, ribbon::box2d::Coupling& coupling, std::span<const engine::SceneBody> bodies,
            std::span<b2Body* const> players);
  void follow_piece(const ribbon::box2d::Coupling& coupling);
  static std::optional<Body> nearest_body(ribbon::Vec2 pointer, std::span<const engine::SceneBody> bodies,
                                          std::span<b2Body* const> players);
  void move_body(ribbon::Vec2 pointer, const ribbon::box2d::Coupling& coupling, double dt) const;
  void move_cord_point(ribbon::Vec2 pointer, ribbon::box2d::Coupling& coupling, double dt);

  std::optional<Body> body_;
  std::optional<ribbon::box2d::CordPoint> cord_point_;
  ribbon::Vec2 cord_at_{};  // m, where the cord point is after the tick
  bool is_pin_ = false;     // the cord point was constrained
};

}  // namespace game
