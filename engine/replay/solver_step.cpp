#include "engine/replay/solver_step.h"

#include <algorithm>

#include "ribbon/box2d/state_hash.h"
#include "ribbon/definition.h"

namespace engine {
namespace {

/// Runs `check` and puts the index of the cord in front of its error message.
template <typename Check>
void check_cord(std::size_t index, Check check) {
  try {
    check();
  } catch (const ribbon::DefinitionError& error) {
    throw SolverStepError("cords[" + std::to_string(index) + "]: " + error.what());
  }
}

/// Checks the number of points before a cord is made, since a short text may define a very long cord.
void check_points(const SolverStep::Cord& cord) {
  ribbon::check_size(cord.def);
  const auto points = static_cast<std::size_t>(cord.def.points) * static_cast<std::size_t>(cord.def.rows);
  if (cord.state.positions.size() == points) return;
  throw ribbon::DefinitionError("state.positions has " + std::to_string(cord.state.positions.size()) +
                                " entries; accepted is one a point: " + std::to_string(points));
}

void check_ids(const std::vector<SolverStep::Cord>& cords) {
  std::vector<std::uint64_t> ids;
  for (const SolverStep::Cord& cord : cords) ids.push_back(cord.id);
  std::sort(ids.begin(), ids.end());
  const auto twice = std::adjacent_find(ids.begin(), ids.end());
  if (twice == ids.end()) return;
  throw SolverStepError("two cords have the id " + std::to_string(*twice) + "; accepted is another one for each");
}

}  // namespace

namespace {

/// Returns the definition of a medium; of another one than a Weather, that of a uniform one.
ribbon::WeatherDef definition_of(const ribbon::IslandCord& cord) {
  const ribbon::Surroundings& surroundings = cord.surroundings;
  if (const auto* weather = dynamic_cast<const ribbon::Weather*>(surroundings.medium)) return weather->def();
  const auto x = cord.cord->positions();
  const ribbon::MediumSample sample =
      surroundings.medium->at(x[x.size() / 2], cord.cord->def().length / cord.cord->def().points, surroundings.time);
  ribbon::WeatherDef uniform;
  uniform.wind = sample.velocity;
  uniform.air_density = sample.density;
  try {
    ribbon::check(uniform);
  } catch (const ribbon::DefinitionError&) {
    return {};
  }
  return uniform;
}

/// Returns the index of the medium of a cord in the step, and adds it if it is not there.
int medium_of(const ribbon::IslandCord& cord, SolverStep& step) {
  if (cord.surroundings.medium == nullptr) return -1;
  const ribbon::WeatherDef def = definition_of(cord);
  const auto found = std::find(step.media.begin(), step.media.end(), def);
  const auto index = found - step.media.begin();
  if (found == step.media.end()) step.media.push_back(def);
  return static_cast<int>(index);
}

}  // namespace

void capture(const ribbon::box2d::SolverInput& input, SolverStep& step) {
  step.dt = input.dt;
  step.gravity = input.gravity;
  step.bodies.assign(input.bodies.begin(), input.bodies.end());
  step.ties.assign(input.ties.begin(), input.ties.end());
  step.media.clear();
  step.cords.resize(input.cords.size());
  for (std::size_t k = 0; k < input.cords.size(); ++k) {
    const ribbon::IslandCord& from = input.cords[k];
    SolverStep::Cord& to = step.cords[k];
    to.def = from.cord->def();
    from.cord->save(to.state);
    to.circles.assign(from.surroundings.circles.begin(), from.surroundings.circles.end());
    to.segments.assign(from.surroundings.segments.begin(), from.surroundings.segments.end());
    to.grips.assign(from.surroundings.grips.begin(), from.surroundings.grips.end());
    to.axles.assign(from.surroundings.axles.begin(), from.surroundings.axles.end());
    to.supports.assign(from.surroundings.supports.begin(), from.surroundings.supports.end());
    to.id = from.id;
    to.medium = medium_of(from, step);
    to.time = from.surroundings.time;
  }
}

std::uint64_t hash_of_positions(std::span<const ribbon::IslandCord> cords) {
  ribbon::box2d::Hasher hasher;
  for (const ribbon::IslandCord& cord : cords) {
    for (const ribbon::Vec2 position : cord.cord->positions()) hasher.add(position);
    for (const ribbon::Vec2 velocity : cord.cord->velocities()) hasher.add(velocity);
  }
  return hasher.value();
}

void check(const SolverStep& step) {
  try {
    ribbon::check_step(step.dt, step.gravity);
    ribbon::check_bodies(step.bodies);
    for (const ribbon::WeatherDef& medium : step.media) ribbon::check(medium);
  } catch (const ribbon::DefinitionError& error) {
    throw SolverStepError(error.what());
  }
  check_ids(step.cords);
  std::vector<int> points;
  for (std::size_t k = 0; k < step.cords.size(); ++k) {
    check_cord(k, [&cord = step.cords[k], &step] {
      check_points(cord);
      const ribbon::Cord made(cord.def);
      ribbon::check_state(made, cord.state);
      ribbon::check_range("medium", cord.medium, -1, static_cast<double>(step.media.size()) - 1.0);
      ribbon::check_surroundings(
          {{}, cord.circles, cord.grips, cord.segments, cord.axles, nullptr, cord.time, cord.supports},
          step.bodies.size(), made.size(), cord.def.rows);
    });
    points.push_back(static_cast<int>(step.cords[k].state.positions.size()));
  }
  try {
    ribbon::check_ties(step.ties, points);
  } catch (const ribbon::DefinitionError& error) {
    throw SolverStepError(error.what());
  }
}

}  // namespace engine
