#pragma once

#include <array>
#include <concepts>
#include <string_view>
#include <type_traits>

#include "engine/replay/solver_step.h"

/// The fields of a SolverStep by name, for writing, reading and printing: `fields(archive, value)` calls
/// archive("name", field) for each field. Structured bindings name all fields: a new field of a state or definition
/// does not compile until it is added here. Increase solver_step_version then.
namespace engine::step_fields {

inline constexpr int solver_step_version = 14;

/// T, const or not.
template <typename T, typename Plain>
concept Is = std::same_as<std::remove_const_t<T>, Plain>;

/// The names of the values of an enumeration, from 0.
template <typename Enum>
inline constexpr std::array<std::string_view, 0> names_of{};
template <>
inline constexpr std::array<std::string_view, 3> names_of<ribbon::PointKind>{"free", "operated", "constrained"};
template <>
inline constexpr std::array<std::string_view, 2> names_of<ribbon::Integrator>{"tr_bdf2", "implicit_euler"};
template <>
inline constexpr std::array<std::string_view, 2> names_of<ribbon::Elements>{"cells", "bars"};

template <typename Archive, Is<ribbon::Accuracy> T>
void fields(Archive& archive, T& accuracy) {
  auto& [integrator, substeps, max_iterations, tolerance, max_work, soft_contacts] = accuracy;
  archive("integrator", integrator);
  archive("substeps", substeps);
  archive("max_iterations", max_iterations);
  archive("tolerance", tolerance);
  archive("max_work", max_work);
  archive("soft_contacts", soft_contacts);
}

template <typename Archive, Is<ribbon::CordDef> T>
void fields(Archive& archive, T& def) {
  auto& [points, rows, length, width, radius, mass_per_length, stretch_stiffness, bending_stiffness, cell_stiffness,
         poisson_ratio, area_stiffness, damping, drag, gravity_scale, drag_across, drag_along, displaced_area,
         tension_only, breaking_force, friction, restitution, self_contact, cord_contact, allow_sleep, elements,
         accuracy, positions, pins] = def;
  archive("points", points);
  archive("rows", rows);
  archive("length", length);
  archive("width", width);
  archive("radius", radius);
  archive("mass_per_length", mass_per_length);
  archive("stretch_stiffness", stretch_stiffness);
  archive("bending_stiffness", bending_stiffness);
  archive("cell_stiffness", cell_stiffness);
  archive("poisson_ratio", poisson_ratio);
  archive("area_stiffness", area_stiffness);
  archive("damping", damping);
  archive("drag", drag);
  archive("gravity_scale", gravity_scale);
  archive("drag_across", drag_across);
  archive("drag_along", drag_along);
  archive("displaced_area", displaced_area);
  archive("tension_only", tension_only);
  archive("breaking_force", breaking_force);
  archive("friction", friction);
  archive("restitution", restitution);
  archive("self_contact", self_contact);
  archive("cord_contact", cord_contact);
  archive("allow_sleep", allow_sleep);
  archive("elements", elements);
  archive("accuracy", accuracy);
  archive("positions", positions);
  archive("pins", pins);
}

template <typename Archive, Is<ribbon::Cord::Holder> T>
void fields(Archive& archive, T& holder) {
  auto& [point, velocity, turning, acceleration, angular_acceleration, grip, pull, slid, slips] = holder;
  archive("point", point);
  archive("velocity", velocity);
  archive("turning", turning);
  archive("acceleration", acceleration);
  archive("angular_acceleration", angular_acceleration);
  archive("grip", grip);
  archive("pull", pull);
  archive("slid", slid);
  archive("slips", slips);
}

template <typename Archive, Is<ribbon::Touch> T>
void fields(Archive& archive, T& touch) {
  auto& [other, feature, other_feature, force, stuck, impulse, point, normal, push] = touch;
  archive("other", other);
  archive("feature", feature);
  archive("other_feature", other_feature);
  archive("force", force);
  archive("stuck", stuck);
  archive("impulse", impulse);
  archive("point", point);
  archive("normal", normal);
  archive("push", push);
}

template <typename Archive, Is<ribbon::PulleyDef> T>
void fields(Archive& archive, T& def) {
  auto& [center, radius, counterclockwise, turns, before, after, inertia, friction, motor_speed, motor_torque] = def;
  archive("center", center);
  archive("radius", radius);
  archive("counterclockwise", counterclockwise);
  archive("turns", turns);
  archive("before", before);
  archive("after", after);
  archive("inertia", inertia);
  archive("friction", friction);
  archive("motor_speed", motor_speed);
  archive("motor_torque", motor_torque);
}

template <typename Archive, Is<ribbon::Pulley> T>
void fields(Archive& archive, T& pulley) {
  auto& [def, lead, arc, arrival, departure, speed, acceleration, angle, turning, tension_before, tension_after,
         slip_sign, blocked, kept, motor_sign] = pulley;
  archive("def", def);
  archive("lead", lead);
  archive("arc", arc);
  archive("arrival", arrival);
  archive("departure", departure);
  archive("speed", speed);
  archive("acceleration", acceleration);
  archive("angle", angle);
  archive("turning", turning);
  archive("tension_before", tension_before);
  archive("tension_after", tension_after);
  archive("slip_sign", slip_sign);
  archive("blocked", blocked);
  archive("kept", kept);
  archive("motor_sign", motor_sign);
}

template <typename Archive, Is<ribbon::Axle> T>
void fields(Archive& archive, T& axle) {
  auto& [body, offset] = axle;
  archive("body", body);
  archive("offset", offset);
}

template <typename Archive, Is<ribbon::Cord::State> T>
void fields(Archive& archive, T& state) {
  auto& [positions, velocities, accelerations, targets, kinds, masses, loads, medium_forces, tensions, rest,
         rest_targets, rest_speeds, breaking_forces, pulleys, unlocked, family, joined_first, joined_last, split,
         holders, touches, touch_changed, depenetration_share, newton_pause, regainable_energy, energy_drift,
         damping_excluded, restart, rest_time, asleep, surroundings_hash] = state;
  archive("positions", positions);
  archive("velocities", velocities);
  archive("accelerations", accelerations);
  archive("targets", targets);
  archive("kinds", kinds);
  archive("masses", masses);
  archive("loads", loads);
  archive("medium_forces", medium_forces);
  archive("tensions", tensions);
  archive("rest", rest);
  archive("rest_targets", rest_targets);
  archive("rest_speeds", rest_speeds);
  archive("breaking_forces", breaking_forces);
  archive("pulleys", pulleys);
  archive("unlocked", unlocked);
  archive("family", family);
  archive("joined_first", joined_first);
  archive("joined_last", joined_last);
  archive("split", split);
  archive("holders", holders);
  archive("touches", touches);
  archive("touch_changed", touch_changed);
  archive("depenetration_share", depenetration_share);
  archive("newton_pause", newton_pause);
  archive("regainable_energy", regainable_energy);
  archive("energy_drift", energy_drift);
  archive("damping_excluded", damping_excluded);
  archive("restart", restart);
  archive("rest_time", rest_time);
  archive("asleep", asleep);
  archive("surroundings_hash", surroundings_hash);
}

template <typename Archive, Is<ribbon::RigidBody> T>
void fields(Archive& archive, T& body) {
  auto& [position, velocity, angular_velocity, inverse_mass, inverse_inertia, acceleration, pushed, pushed_turn,
         impulse, angular_impulse, moved, turned, solved, support_force, support_torque, awake, may_sleep, rests] =
      body;
  archive("position", position);
  archive("velocity", velocity);
  archive("angular_velocity", angular_velocity);
  archive("inverse_mass", inverse_mass);
  archive("inverse_inertia", inverse_inertia);
  archive("acceleration", acceleration);
  archive("pushed", pushed);
  archive("pushed_turn", pushed_turn);
  archive("impulse", impulse);
  archive("angular_impulse", angular_impulse);
  archive("moved", moved);
  archive("turned", turned);
  archive("solved", solved);
  archive("support_force", support_force);
  archive("support_torque", support_torque);
  archive("awake", awake);
  archive("may_sleep", may_sleep);
  archive("rests", rests);
}

template <typename Archive, Is<ribbon::RigidCircle> T>
void fields(Archive& archive, T& circle) {
  auto& [body, offset, radius, friction, restitution, id, tangent_speed] = circle;
  archive("body", body);
  archive("offset", offset);
  archive("radius", radius);
  archive("friction", friction);
  archive("restitution", restitution);
  archive("id", id);
  archive("tangent_speed", tangent_speed);
}

template <typename Archive, Is<ribbon::RigidSegment> T>
void fields(Archive& archive, T& segment) {
  auto& [body, a, b, radius, friction, restitution, id, tangent_speed] = segment;
  archive("body", body);
  archive("a", a);
  archive("b", b);
  archive("radius", radius);
  archive("friction", friction);
  archive("restitution", restitution);
  archive("id", id);
  archive("tangent_speed", tangent_speed);
}

template <typename Archive, Is<ribbon::Grip> T>
void fields(Archive& archive, T& grip) {
  auto& [point, body, offset, travel, along, climb, strength, returns, across, beside, caught] = grip;
  archive("point", point);
  archive("body", body);
  archive("offset", offset);
  archive("travel", travel);
  archive("along", along);
  archive("climb", climb);
  archive("strength", strength);
  archive("returns", returns);
  archive("across", across);
  archive("beside", beside);
  archive("caught", caught);
}

template <typename Archive, Is<ribbon::Support> T>
void fields(Archive& archive, T& support) {
  auto& [body, arm, normal, gap, speed, other, other_arm] = support;
  archive("body", body);
  archive("arm", arm);
  archive("normal", normal);
  archive("gap", gap);
  archive("speed", speed);
  archive("other", other);
  archive("other_arm", other_arm);
}

template <typename Archive, Is<SolverStep::Cord> T>
void fields(Archive& archive, T& cord) {
  auto& [def, state, circles, segments, grips, axles, supports, id, medium, time] = cord;
  archive("id", id);
  archive("def", def);
  archive("state", state);
  archive("circles", circles);
  archive("segments", segments);
  archive("grips", grips);
  archive("axles", axles);
  archive("supports", supports);
  archive("medium", medium);
  archive("time", time);
}

template <typename Archive, Is<ribbon::WeatherDef> T>
void fields(Archive& archive, T& weather) {
  auto& [wind, air_density, gusts, gust_time, gust_length, water_level, water_density, current] = weather;
  archive("wind", wind);
  archive("air_density", air_density);
  archive("gusts", gusts);
  archive("gust_time", gust_time);
  archive("gust_length", gust_length);
  archive("water_level", water_level);
  archive("water_density", water_density);
  archive("current", current);
}

template <typename Archive, Is<ribbon::Tie> T>
void fields(Archive& archive, T& tie) {
  auto& [cord, point, other_cord, other_point] = tie;
  archive("cord", cord);
  archive("point", point);
  archive("other_cord", other_cord);
  archive("other_point", other_point);
}

template <typename Archive, Is<SolverStep::Outcome> T>
void fields(Archive& archive, T& outcome) {
  auto& [why, work, unconverged, positions] = outcome;
  archive("why", why);
  archive("work", work);
  archive("unconverged", unconverged);
  archive("positions", positions);
}

template <typename Archive, Is<SolverStep> T>
void fields(Archive& archive, T& step) {
  auto& [dt, gravity, bodies, cords, ties, media, outcome] = step;
  archive("outcome", outcome);
  archive("dt", dt);
  archive("gravity", gravity);
  archive("bodies", bodies);
  archive("cords", cords);
  archive("ties", ties);
  archive("media", media);
}

}  // namespace engine::step_fields
