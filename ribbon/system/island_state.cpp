#include "ribbon/system/island_state.h"

#include <algorithm>

#include "ribbon/linear/reserve_more.h"

namespace ribbon {
namespace {

constexpr std::size_t usual_bodies = 8;  // of an island: it gets memory for so many at once

}  // namespace

bool IslandTies::is_tied(int slot) const {
  const auto found = std::lower_bound(slots.begin(), slots.end(), slot,
                                      [](const TiedSlot& tied, int wanted) { return tied.slot < wanted; });
  return found != slots.end() && found->slot == slot;
}

Stage IslandState::stage_of(const Stage& all, const Member& member) {
  Stage stage = all;
  stage.predicted = all.predicted.subspan(member.first_point, member.points);
  stage.velocity = all.velocity.subspan(member.first_point, member.points);
  stage.inertia = all.inertia.subspan(member.first_point, member.points);
  stage.force = all.force.subspan(member.first_point, member.points);
  stage.constrained = all.constrained.subspan(member.first_point, member.points);
  if (!all.resistance.empty()) stage.resistance = all.resistance.subspan(member.first_point, member.points);
  return stage;
}

std::size_t IslandState::solved_body(int index) {
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (bodies[k].index == index) return k;
  }
  if (bodies.capacity() == 0) bodies.reserve(usual_bodies);
  const RigidBody& body = rigid[at(index)];
  bodies.push_back({index, body.inverse_inertia > 0.0});
  return bodies.size() - 1;
}

void IslandState::drive(std::size_t slot, Vec2 velocity) {
  constrained[slot] = 1;
  drive_starts[slot] = positions[slot];
  drive_velocities[slot] = velocity;
  restart = restart || !(velocities[slot] == velocity);
  velocities[slot] = velocity;
}

void IslandState::place_gaps(double time) {
  for (const TieGap& gap : ties.gaps) {
    positions[at(gap.of.slot)] = positions[at(gap.of.with)] + gap.start - (time / dt) * gap.closing;
  }
}

/// The two sizes that are asked for are those of the arrays that are resized last, in case memory runs out before.
void IslandState::resize(std::size_t slots, std::size_t tension_count) {
  if (in_medium) medium_forces.resize(slots);
  if (positions.size() == slots && tensions.size() == tension_count) return;  // so are all the others
  for (auto* all : {&velocities, &accelerations, &free_accelerations, &drive_starts, &drive_velocities,
                    &start.positions, &start.velocities}) {
    all->resize(slots);
  }
  reserve_more(pushes, slots);
  masses.resize(slots);
  constrained.resize(slots);
  start.tensions.resize(tension_count);
  tensions.resize(tension_count);
  positions.resize(slots);
}

void IslandState::begin_substep(double time, double substep_dt) {
  now = start.time = time;
  start.dt = substep_dt;
  start.positions = positions;
  start.velocities = velocities;
  start.tensions = tensions;
  supports.changed = false;
  for (BodySupport& support : supports.all) support.start_push = support.push;
}

void IslandState::return_to_start() {
  now = start.time;
  positions = start.positions;
  velocities = start.velocities;
  tensions = start.tensions;
  supports.changed = false;
  for (BodySupport& support : supports.all) support.push = support.start_push;
}

void IslandState::add_damping(double sign) {
  for (const Member& member : members) {
    if (member.cord->def.damping == 0.0) continue;
    member.cord->elasticity->add_damping(motion_of(member), sign, tensions_of(member, tensions));
  }
}

void IslandState::find_tensions() {
  for (const Member& member : members) {
    member.cord->elasticity->find_tensions(points_of(member, positions), tensions_of(member, tensions));
  }
}

}  // namespace ribbon
