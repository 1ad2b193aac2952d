#include <chipmunk/chipmunk.h>

#include <chrono>
#include <cmath>
#include <memory>

#include "tests/peers/runners.h"

namespace peers {
namespace {

using ribbon::Vec2;

constexpr cpBitmask link_category = 2;
constexpr double slop = 0.005;  // m, tolerated overlap, as in Box2D; Chipmunk's default is in pixels

cpVect to_cp(Vec2 v) { return cpv(v.x, v.y); }
Vec2 to_vec2(cpVect v) { return {v.x, v.y}; }

/// Builds the plan in a Chipmunk space. Frees all objects, because Chipmunk frees none.
class Space {
 public:
  Space(const Plan& plan, int iterations) : plan_(&plan), space_(cpSpaceNew()) {
    cpSpaceSetGravity(space_, to_cp(plan.gravity));
    cpSpaceSetIterations(space_, iterations);
    cpSpaceSetCollisionSlop(space_, slop);
    for (const BodyPlan& body : plan.bodies) add(body);
    for (const HingePlan& hinge : plan.hinges) {
      cpConstraint* joint = cpPivotJointNew(body(hinge.a), body(hinge.b), to_cp(hinge.place));
      constraints_.push_back(cpSpaceAddConstraint(space_, joint));
    }
  }
  Space(const Space&) = delete;
  Space& operator=(const Space&) = delete;
  ~Space() {
    for (cpConstraint* constraint : constraints_) {
      cpSpaceRemoveConstraint(space_, constraint);
      cpConstraintFree(constraint);
    }
    for (cpShape* shape : shapes_) {
      cpSpaceRemoveShape(space_, shape);
      cpShapeFree(shape);
    }
    for (cpBody* body : bodies_) {
      if (body != cpSpaceGetStaticBody(space_) && cpSpaceContainsBody(space_, body)) cpSpaceRemoveBody(space_, body);
      cpBodyFree(body);
    }
    cpSpaceFree(space_);
  }

  void step(double dt) { cpSpaceStep(space_, dt); }

  void slow_down(double share) {
    for (cpBody* body : bodies_) {
      if (cpBodyGetType(body) != CP_BODY_TYPE_DYNAMIC) continue;
      cpBodySetVelocity(body, cpvmult(cpBodyGetVelocity(body), share));
      cpBodySetAngularVelocity(body, share * cpBodyGetAngularVelocity(body));
    }
  }

  Frame frame() const {
    Frame frame;
    for (const CordPlan& cord : plan_->cords) {
      std::vector<Vec2>& points = frame.cords.emplace_back();
      const auto end = [&](int link, double side) {
        const double half = side * plan_->bodies[static_cast<std::size_t>(link)].half_length;
        points.push_back(to_vec2(cpBodyLocalToWorld(body(link), cpv(half, 0.0))));
      };
      end(cord.links.front(), -1.0);
      for (const int link : cord.links) end(link, 1.0);
    }
    for (const int moving_body : plan_->moving_bodies())
      frame.moving_bodies.push_back(to_vec2(cpBodyGetPosition(body(moving_body))));
    return frame;
  }

 private:
  cpBody* body(int k) const { return bodies_[static_cast<std::size_t>(k)]; }

  void add(const BodyPlan& plan) {
    cpBody* body = plan.dynamic ? cpBodyNew(plan.mass, plan.inertia) : cpBodyNewStatic();
    cpBodySetPosition(body, to_cp(plan.position));
    cpBodySetAngle(body, plan.angle);
    bodies_.push_back(cpSpaceAddBody(space_, body));
    if (plan.half_length > 0.0) {
      cpShape* link = cpSegmentShapeNew(body, cpv(-plan.half_length, 0.0), cpv(plan.half_length, 0.0), plan.radius);
      cpShapeSetFilter(link, cpShapeFilterNew(CP_NO_GROUP, link_category, ~link_category));
      add(link, plan.friction);
    } else if (plan.radius > 0.0) {
      add(cpCircleShapeNew(body, plan.radius, cpvzero), plan.friction);
    }
    for (const auto& [a, b] : plan.edges) {
      add(cpSegmentShapeNew(body, to_cp(a - plan.position), to_cp(b - plan.position), 0.0), plan.friction);
    }
  }

  /// Takes the root, because Chipmunk multiplies the frictions of two shapes and the others take the geometric mean.
  void add(cpShape* shape, double friction) {
    cpShapeSetFriction(shape, std::sqrt(friction));
    shapes_.push_back(cpSpaceAddShape(space_, shape));
  }

  const Plan* plan_;
  cpSpace* space_;
  std::vector<cpBody*> bodies_;
  std::vector<cpShape*> shapes_;
  std::vector<cpConstraint*> constraints_;
};

}  // namespace

std::string chipmunk_version() { return cpVersionString; }

Recording run_chipmunk(const Plan& plan, const Parameters& parameters) {
  const int substeps = static_cast<int>(parameter_or(parameters, "substeps", 1.0));
  Space space(plan, static_cast<int>(parameter_or(parameters, "iterations", 10.0)));
  const auto tick = [&] {
    for (int k = 0; k < substeps; ++k) space.step(test_support::CoupledWorld::dt / substeps);
  };
  for (int k = 0; k < plan.settling_ticks; ++k) {
    tick();
    space.slow_down(0.9);
  }
  Recording recording;
  for (int k = 0; k < plan.ticks; ++k) {
    const auto start = std::chrono::steady_clock::now();
    tick();
    const double us = std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
    recording.push_back(space.frame());
    recording.back().us = us;
    if (!is_in_bounds(recording.back())) break;
  }
  return recording;
}

}  // namespace peers
