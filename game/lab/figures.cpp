#include "game/lab/figures.h"

#include <algorithm>
#include <cmath>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/coupling_state.h"
#include "ribbon/box2d/state_hash.h"
#include "ribbon/cord_forces.h"

namespace game::lab {

using ribbon::Vec2;
using ribbon::box2d::CordView;
using ribbon::box2d::to_double;

namespace {

double energy_of(const CordView& cord, Vec2 gravity) {
  if (cord.solver() == ribbon::box2d::Solver::direct) return energy_of(cord.direct(), gravity).total();
  double sum = 0.0;
  const ribbon::ThesisCord& thesis = cord.thesis();
  for (std::size_t p = 0; p < thesis.positions().size(); ++p) {
    const Vec2 v = thesis.velocities()[p];
    sum += thesis.def().point_mass * (0.5 * dot(v, v) - dot(gravity, thesis.positions()[p]));
  }
  return sum;
}

std::span<const Vec2> velocities_of(const CordView& cord) {
  return cord.solver() == ribbon::box2d::Solver::direct ? cord.direct().velocities() : cord.thesis().velocities();
}

}  // namespace

double energy(const Bench& bench) {
  const Vec2 gravity = to_double(bench.world().GetGravity());
  double sum = 0.0;
  for (const ribbon::box2d::CordId id : bench.coupling().cords()) sum += energy_of(bench.coupling().cord(id), gravity);
  for (const b2Body* body = bench.world().GetBodyList(); body != nullptr; body = body->GetNext()) {
    if (body->GetType() != b2_dynamicBody) continue;
    const Vec2 v = bench.coupling().body(*body).velocity();
    const double turning = bench.coupling().body(*body).angular_velocity();
    sum += static_cast<double>(body->GetMass()) * (0.5 * dot(v, v) - dot(gravity, to_double(body->GetWorldCenter())));
    sum += 0.5 * static_cast<double>(body->GetInertia()) * turning * turning;
  }
  return sum;
}

double length_now(const CordView& cord) {
  const auto x = cord.positions();
  const auto rows = static_cast<std::size_t>(cord.shape().rows);
  double sum = 0.0;
  for (std::size_t p = rows; p < x.size(); ++p) sum += length(x[p] - x[p - rows]);
  return sum / static_cast<double>(rows);
}

double length_at_rest(const CordView& cord) {
  if (cord.solver() == ribbon::box2d::Solver::direct) return cord.direct().def().length;
  return (cord.thesis().def().w - 1) * cord.thesis().def().spacing;
}

double length_now(const JointChain& chain) {
  double sum = 0.0;
  for (int k = 1; k < chain.points(); ++k) sum += length(to_double(chain.point(k)) - to_double(chain.point(k - 1)));
  return sum;
}

double greatest_stretch(const Bench& bench) {
  double most = -1.0;
  for (const ribbon::box2d::CordId id : bench.coupling().cords()) {
    const CordView cord = bench.coupling().cord(id);
    most = std::max(most, length_now(cord) / length_at_rest(cord) - 1.0);
  }
  for (std::size_t k = 0; k < bench.chains().size(); ++k) {
    most = std::max(most, length_now(bench.chains()[k]) / bench.definitions()[k].length - 1.0);
  }
  return most;
}

int cords_in_one_step(const Bench& bench) {
  int count = 0;
  for (const ribbon::box2d::CordId id : bench.coupling().cords()) {
    const CordView cord = bench.coupling().cord(id);
    if (cord.solver() != ribbon::box2d::Solver::direct) continue;
    const int solves = cord.island_report().stages;  // 0 for a cord that sleeps
    if (solves > 0 && solves < cord.direct().def().accuracy.substeps) ++count;
  }
  return count;
}

bool is_finite(const Bench& bench) {
  const auto all_finite = [](std::span<const Vec2> vectors) {
    return std::all_of(vectors.begin(), vectors.end(), [](Vec2 v) { return ribbon::is_finite(v); });
  };
  for (const ribbon::box2d::CordId id : bench.coupling().cords()) {
    const CordView cord = bench.coupling().cord(id);
    if (!all_finite(cord.positions()) || !all_finite(velocities_of(cord))) return false;
  }
  for (const b2Body* body = bench.world().GetBodyList(); body != nullptr; body = body->GetNext()) {
    if (!body->GetPosition().IsValid() || !body->GetLinearVelocity().IsValid()) return false;
  }
  return true;
}

std::uint64_t state_hash(const Bench& bench) {
  ribbon::box2d::Hasher hasher;
  add_to(hasher, bench.coupling().save(bench.world()));
  for (const b2Body* body = bench.world().GetBodyList(); body != nullptr; body = body->GetNext()) {
    hasher.add(to_double(body->GetPosition()));
    hasher.add(to_double(body->GetLinearVelocity()));
    hasher.add(body->GetAngle());
    hasher.add(body->GetAngularVelocity());
  }
  return hasher.value();
}

}  // namespace game::lab
