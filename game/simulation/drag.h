#pragma once

#include <box2d/box2d.h>

#include <optional>

#include "engine/scene/scene.h"
#include "engine/tick/input.h"
#include "ribbon/box2d/state_hash.h"

namespace game {

/// What the pointer has taken hold of, and takes along until it lets go: a body, or the point of a cord. Ground stays.
class Drag {
 public:
  static constexpr double cord_reach = 1.0;  ///< m, from the pointer to a cord point that it can take
  static constexpr double body_reach = 0.3;  ///< m, to the rim of a body
  static constexpr double speed = 15.0;      ///< m/s, at which it takes something along at the most
  static constexpr double pin_speed = 5.0;   ///< m/s, what a cord is fixed to, and all that hangs there with it
  static constexpr double strength = 60.0;   ///< m/s², with which it moves a body of any mass at the most

  /// A tick of dt seconds, before the scene's: takes what is nearest where button_drag goes down, lets go where it is
  /// up. `player` is a body that the scene does not know of.
  void apply(const engine::TickInput& input, engine::Scene& scene, b2Body& player, double dt);
  /// There is nothing any more of what it held.
  void forget() { *this = {}; }

  const std::optional<ribbon::box2d::CordPoint>& cord_point() const { return cord_point_; }
  const b2Body* body() const { return body_ ? body_->body : nullptr; }

  void add_to(ribbon::box2d::Hasher& hasher) const;

 private:
  struct Body {
    b2Body* body = nullptr;
    int number = 0;  // among those of the scene; the player comes after them
    double distance = 0.0;
    b2Vec2 at{};                       // where it is held, in its own frame
    b2BodyType type = b2_dynamicBody;  // before it was taken
    b2Vec2 velocity{};                 // m/s, then
  };

  void take(ribbon::Vec2 pointer, engine::Scene& scene, b2Body& player);
  void let_go(ribbon::box2d::Coupling& coupling);
  static std::optional<Body> nearest_body(ribbon::Vec2 pointer, const engine::Scene& scene, b2Body& player);
  void move_body(ribbon::Vec2 pointer, const ribbon::box2d::Coupling& coupling, double dt) const;
  void move_cord_point(ribbon::Vec2 pointer, ribbon::box2d::Coupling& coupling, double dt) const;

  std::optional<Body> body_;
  std::optional<ribbon::box2d::CordPoint> cord_point_;
  bool is_pin_ = false;  // that point
};

}  // namespace game
