#include "tests/extremes/any_scene/figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "ribbon/pulley.h"
#include "tests/support/slot.h"

namespace any_scene {

using ribbon::Vec2;

namespace {

using test_support::slot;

}  // namespace

int work(const ribbon::box2d::Coupling& coupling) { return coupling.last_step().report().iterations; }

int unconverged(const ribbon::box2d::Coupling& coupling) { return coupling.last_step().report().unconverged; }

EnergyBalance::EnergyBalance(const World::Energy& start, double weight, Vec2 heights)
    : weight_(weight),
      heights_(heights),
      kinetic_(start.kinetic),
      lowest_(start.total - start.box2d),
      before_(lowest_) {}

void EnergyBalance::leave_out(const World::Energy& now) {
  const double own = now.total - now.box2d;
  lowest_ += own - before_;
  before_ = own;
}

EnergyBalance::Gain EnergyBalance::take(const World::Energy& now, Vec2 heights) {
  heights_ = {std::min(heights_.x, heights.x), std::max(heights_.y, heights.y)};
  kinetic_ = std::max(kinetic_, now.kinetic);
  const double own = now.total - now.box2d;
  lowest_ = std::min(lowest_, own);
  const double scale = kinetic_ + weight_ * (heights_.y - heights_.x);
  const double gained = std::max(0.0, own - before_);
  const double risen = own - lowest_;
  before_ = own;
  return scale > 0.0 ? Gain{gained / scale, risen / scale} : Gain{};
}

namespace {

/// Returns the length from the point before a wheel to the one behind it, m. Nothing keeps a point from swinging into a
/// wheel whose body has no disc there. No tangent leads to it, so its line ends at the place in the groove that the
/// solver found.
double path_length(const ribbon::Cord& cord, const ribbon::box2d::PulleyState& pulley) {
  const double radius = pulley.def.radius;
  const double sense = pulley.def.counterclockwise ? 1.0 : -1.0;
  const Vec2 first = cord.positions()[slot(pulley.def.before)] - pulley.center;
  const Vec2 last = cord.positions()[slot(pulley.def.after)] - pulley.center;
  if (std::min(length(first), length(last)) < radius) {
    const auto solved = std::find_if(pulleys_of(cord).begin(), pulleys_of(cord).end(),
                                     [&](const auto& other) { return other.def.before == pulley.def.before; });
    return length(first - radius * solved->arrival) + radius * pulley.arc + length(last - radius * solved->departure);
  }
  const auto tangent = [radius](Vec2 r) { return std::sqrt(std::max(0.0, dot(r, r) - radius * radius)); };
  const double turned = sense * (std::atan2(last.y, last.x) - std::atan2(first.y, first.x)) -
                        std::atan2(tangent(first), radius) - std::atan2(tangent(last), radius);
  constexpr double turn = 2.0 * std::numbers::pi;
  const double arc = turned + turn * std::round((pulley.arc - turned) / turn);
  return tangent(first) + radius * arc + tangent(last);
}

/// Returns the strain of that part. It is 0 where a keeper holds the cord, and where Box2D pushes the wheel: it is not
/// where the solver put it.
double strain_at(const ribbon::Cord& cord, const World::Reeving& reeving) {
  if (reeving.pressed || reeving.pulley.arc == 0.0) return 0.0;
  double rest = 0.0;
  for (int link = reeving.pulley.def.before; link < reeving.pulley.def.after; ++link) rest += cord.rest_length(link);
  return path_length(cord, reeving.pulley) / rest - 1.0;
}

void take(const ribbon::CordDef& def, double strain, Lengths& worst) {
  const double counted = def.tension_only ? strain : std::abs(strain);
  double& most = std::isinf(def.stretch_stiffness) ? worst.stretch : worst.strain;
  if (!(counted <= most)) most = counted;
}

}  // namespace

Lengths lengths(const World& world) {
  const ribbon::box2d::Coupling& coupling = world.coupling();
  Lengths worst;
  for (const ribbon::box2d::CordId c : coupling.cords()) {
    const ribbon::Cord& cord = coupling.cord(c).direct();
    const ribbon::CordDef& def = cord.def();
    for (int i = 0; i + 1 < def.points; ++i) {
      const bool on_wheel = std::any_of(pulleys_of(cord).begin(), pulleys_of(cord).end(), [i](const auto& pulley) {
        return i >= pulley.def.before && i < pulley.def.after;
      });
      for (int j = 0; j < def.rows && !on_wheel; ++j) {
        const Vec2 link = cord.positions()[slot(cord.index(i + 1, j))] - cord.positions()[slot(cord.index(i, j))];
        take(def, length(link) / cord.rest_length(i) - 1.0, worst);
      }
    }
  }
  for (const World::Reeving& reeving : world.reevings()) {
    const ribbon::Cord& cord = coupling.cord(reeving.pulley.cord).direct();
    take(cord.def(), strain_at(cord, reeving), worst);
  }
  return worst;
}

Inertia inertia(const ribbon::box2d::Coupling& coupling) {
  Inertia sum;
  for (const ribbon::box2d::CordId id : coupling.cords()) {
    const ribbon::Cord& cord = coupling.cord(id).direct();
    for (int p = 0; p < cord.size(); ++p) {
      sum.mass += cord.mass(p);
      sum.momentum += cord.mass(p) * cord.velocities()[static_cast<std::size_t>(p)];
    }
  }
  return sum;
}

double difference(const Inertia& before, const Inertia& after, double speed) {
  if (!(before.mass > 0.0)) return after.mass;
  const double mass = std::abs(after.mass - before.mass) / before.mass;
  const double moved = length(after.momentum - before.momentum);
  return std::max(mass, speed > 0.0 ? moved / (before.mass * speed) : moved);
}

int inverted(const ribbon::box2d::Coupling& coupling) {
  int count = 0;
  for (const ribbon::box2d::CordId c : coupling.cords()) {
    const ribbon::Cord& cord = coupling.cord(c).direct();
    if (cord.def().area_stiffness == 0.0) continue;
    const auto at = [&](int i, int j) { return cord.positions()[slot(cord.index(i, j))]; };
    for (int i = 0; i + 1 < cord.def().points; ++i) {
      for (int j = 0; j + 1 < cord.def().rows; ++j) {
        const std::array<Vec2, 4> x = {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
        for (std::size_t k = 0; k < 4; ++k) {
          const Vec2 corner = x[(k + 1) % 4];
          count += cross(corner - x[k], x[(k + 2) % 4] - corner) <= 0.0 ? 1 : 0;
        }
      }
    }
  }
  return count;
}

}  // namespace any_scene
