#include "tests/flight/edits.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace flight {
namespace {

using engine::SolverStep;
using ribbon::RigidBody;
using ribbon::Vec2;
using Cord = SolverStep::Cord;

/// Returns whether the assignment changed the value.
template <typename T>
bool set(T& value, const std::type_identity_t<T>& simple) {
  return !(std::exchange(value, simple) == simple);
}

template <typename T>
bool clear(std::vector<T>& values) {
  return !std::exchange(values, {}).empty();
}

bool stop(std::vector<Vec2>& vectors) {
  const bool moves = std::any_of(vectors.begin(), vectors.end(), [](Vec2 v) { return !(v == Vec2{}); });
  vectors.assign(vectors.size(), {});
  return moves;
}

bool drop_unused_bodies(SolverStep& step) {
  std::vector<int> places(step.bodies.size(), -1);
  const auto for_each = [&step](auto visit) {
    for (Cord& cord : step.cords) {
      for (auto& circle : cord.circles) visit(circle.body);
      for (auto& segment : cord.segments) visit(segment.body);
      for (auto& grip : cord.grips) visit(grip.body);
      for (auto& axle : cord.axles) visit(axle.body);
      for (auto& support : cord.supports) visit(support.body);
    }
  };
  for_each([&places](int body) { places[static_cast<std::size_t>(body)] = 0; });
  std::vector<RigidBody> used;
  for (std::size_t b = 0; b < places.size(); ++b) {
    if (places[b] < 0) continue;
    places[b] = static_cast<int>(used.size());
    used.push_back(step.bodies[b]);
  }
  const bool changed = used.size() < step.bodies.size();
  for_each([&places](int& body) { body = places[static_cast<std::size_t>(body)]; });
  step.bodies = std::move(used);
  return changed;
}

bool stop_sleep(Cord& cord) {
  cord.state.rest_time = 0.0;
  cord.state.asleep = false;
  return set(cord.def.allow_sleep, false);
}

bool stop_reel(Cord& cord) {
  clear(cord.state.rest_speeds);
  return clear(cord.state.rest_targets);
}

bool drop_pulleys(Cord& cord) {
  cord.axles.clear();
  return clear(cord.state.pulleys);
}

bool drop_area_stiffness(Cord& cord) {
  cord.state.unlocked.clear();
  return set(cord.def.area_stiffness, 0.0);
}

/// Removes friction and restitution of all circles and segments.
bool smooth(Cord& cord) {
  bool changed = false;
  for (auto& circle : cord.circles) {
    changed |= set(circle.friction, 0.0);
    changed |= set(circle.restitution, 0.0);
  }
  for (auto& segment : cord.segments) {
    changed |= set(segment.friction, 0.0);
    changed |= set(segment.restitution, 0.0);
  }
  return changed;
}

bool hold_still(Cord& cord) {
  bool changed = false;
  for (ribbon::Grip& grip : cord.grips) {
    changed |= set(grip.travel, {});
    changed |= set(grip.climb, 0.0);
  }
  return changed;
}

bool hold_hard(Cord& cord) {
  bool changed = false;
  for (ribbon::Grip& grip : cord.grips) changed |= set(grip.strength, std::numeric_limits<double>::infinity());
  return changed;
}

bool stop_body(RigidBody& body) {
  const bool turns = set(body.angular_velocity, 0.0);
  return set(body.velocity, {}) || turns;
}

bool fix_body(RigidBody& body) {
  body.inverse_inertia = 0.0;
  body.acceleration = {};
  return set(body.inverse_mass, 0.0);
}

template <typename T>
void cut(std::vector<T>& values, std::size_t many, bool at_front) {
  if (values.empty()) return;
  const auto count = static_cast<std::ptrdiff_t>(many);
  if (at_front) {
    values.erase(values.begin(), values.begin() + count);
  } else {
    values.erase(values.end() - count, values.end());
  }
}

void cut_state(ribbon::Cord::State& state, std::size_t many, bool at_front) {
  for (auto* vectors : {&state.positions, &state.velocities, &state.accelerations, &state.targets, &state.loads,
                        &state.medium_forces}) {
    cut(*vectors, many, at_front);
  }
  for (auto* numbers :
       {&state.masses, &state.tensions, &state.rest, &state.rest_targets, &state.rest_speeds, &state.breaking_forces}) {
    cut(*numbers, many, at_front);
  }
  cut(state.kinds, many, at_front);
  state.holders.clear();
  state.touches.clear();
}

}  // namespace

const std::vector<Edit<SolverStep>>& step_edits() {
  static const std::vector<Edit<SolverStep>> edits = {
      drop_unused_bodies,
      [](SolverStep& step) { return set(step.gravity, {}); },
  };
  return edits;
}

const std::vector<Edit<Cord>>& cord_edits() {
  static const std::vector<Edit<Cord>> edits = {
      stop_sleep,
      stop_reel,
      drop_area_stiffness,
      drop_pulleys,
      smooth,
      hold_still,
      hold_hard,
      [](Cord& cord) { return set(cord.def.bending_stiffness, 0.0); },
      [](Cord& cord) { return set(cord.def.poisson_ratio, 0.0); },
      [](Cord& cord) { return set(cord.def.damping, 0.0); },
      [](Cord& cord) { return set(cord.def.drag, 0.0); },
      [](Cord& cord) { return set(cord.def.gravity_scale, 1.0); },
      [](Cord& cord) { return set(cord.medium, -1); },
      [](Cord& cord) { return set(cord.def.drag_across, 0.0); },
      [](Cord& cord) { return set(cord.def.drag_along, 0.0); },
      [](Cord& cord) { return set(cord.def.displaced_area, 0.0); },
      [](Cord& cord) { return set(cord.def.tension_only, false); },
      [](Cord& cord) { return set(cord.def.friction, 0.0); },
      [](Cord& cord) { return set(cord.def.restitution, 0.0); },
      [](Cord& cord) { return set(cord.def.self_contact, false); },
      [](Cord& cord) { return set(cord.def.cord_contact, false); },
      [](Cord& cord) { return set(cord.def.accuracy, {}); },
      [](Cord& cord) { return clear(cord.def.pins); },
      [](Cord& cord) { return clear(cord.def.positions); },
      [](Cord& cord) { return clear(cord.state.loads); },
      [](Cord& cord) { return clear(cord.state.medium_forces); },
      [](Cord& cord) { return clear(cord.state.touches); },
      [](Cord& cord) { return clear(cord.state.holders); },
      [](Cord& cord) { return set(cord.state.depenetration_share, 1.0); },
      [](Cord& cord) { return set(cord.state.newton_pause, 0); },
      [](Cord& cord) { return set(cord.state.regainable_energy, 0.0); },
      [](Cord& cord) { return set(cord.state.energy_drift, 0.0); },
      [](Cord& cord) { return stop(cord.state.accelerations); },
      [](Cord& cord) { return stop(cord.state.velocities); },
  };
  return edits;
}

const std::vector<Edit<RigidBody>>& body_edits() {
  static const std::vector<Edit<RigidBody>> edits = {
      stop_body,
      fix_body,
      [](RigidBody& body) { return set(body.inverse_inertia, 0.0); },
      [](RigidBody& body) { return set(body.acceleration, {}); },
  };
  return edits;
}

bool cut_rope(Cord& cord, int many, bool at_front) {
  const int left = cord.def.points - many;
  if (cord.def.rows != 1 || left < 2 || !cord.state.pulleys.empty()) return false;
  cord.def.length *= (left - 1.0) / (cord.def.points - 1.0);
  cord.def.points = left;
  cord.def.pins.clear();
  const auto count = static_cast<std::size_t>(many);
  cut(cord.def.positions, count, at_front);
  cut_state(cord.state, count, at_front);
  for (ribbon::Grip& grip : cord.grips) grip.point -= at_front ? many : 0;
  std::erase_if(cord.grips, [left](const ribbon::Grip& grip) {
    return grip.point < 0 || grip.point + (grip.along > 0.0 ? 1 : 0) >= left;
  });
  return true;
}

}  // namespace flight
