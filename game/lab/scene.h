#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "game/lab/bench.h"
#include "game/lab/knobs.h"

namespace game::lab {

/// A figure that a scene shows besides energy and stretch.
struct Reading {
  enum class Kind : std::uint8_t {
    excess,         ///< m by which the cord is longer than its tension makes it; what should be 0
    pull_ratio,     ///< pull at one end / pull at the other
    holding_limit,  ///< the ratio up to which friction holds, e^(μ·angle)
    critical_load,  ///< N
    awake,          ///< number of cords that do not sleep
    contacts,       ///< number of contacts of cords
    unconverged,    ///< number of substeps that did not converge, since the start
    self_contacts,  ///< number of resolved overlaps of a cord with itself
    turned_over,    ///< number of inverted triangles
  };

  Kind kind;
  double value;
};

/// A force that is shown as an arrow, with a number at a place of its own.
struct ShownForce {
  ribbon::Vec2 tip;        ///< m, where it acts
  ribbon::Vec2 arrow;      ///< m, from the tail of the arrow to its tip
  ribbon::Vec2 number_at;  ///< m
  double share;            ///< what the number says
};

/// A scene of the lab: plain data, and functions that build it without any drawing.
struct Scene {
  std::string_view name;                        ///< of command lines and links
  ribbon::Vec2 low, high;                       ///< m, the corners of what is shown
  std::vector<KnobRange> knobs;                 ///< in the order of the sliders
  ribbon::Vec2 gravity = Bench::earth_gravity;  ///< m/s²
  /// m, from the cords' bench to one with chains of Box2D's joints; none: there is no such bench
  std::optional<ribbon::Vec2> chains_at{};
  /// Builds one of the two, `origin` away from the place of the first.
  std::function<void(Bench& bench, const KnobValues& values, ribbon::Vec2 origin)> build;
  /// Applies a knob of its own while the scene moves; may be empty.
  std::function<void(Bench& bench, const KnobValues& values)> tune{};
  std::function<std::vector<Reading>(const Bench& bench, const KnobValues& values)> readings;
  std::function<std::vector<ShownForce>(const Bench& bench, const KnobValues& values)> forces{};  ///< may be empty
};

/// Returns all scenes in the order in which the lab lists them.
std::span<const Scene> scenes();
/// Returns the scene of that name. Throws std::runtime_error with a sentence that names all scenes if there is none.
const Scene& scene_named(std::string_view name);

/// Returns the values that a scene starts with.
KnobValues initial_values(const Scene& scene);
/// Returns the range of a knob of a scene, or null if it does not have that knob.
const KnobRange* range_of(const Scene& scene, Knob knob);
/// Returns the accuracy that the knobs preset, substeps and tolerance ask for.
ribbon::Accuracy accuracy_of(const KnobValues& values);
/// Sets the knobs substeps and tolerance to those of the preset.
void follow_preset(KnobValues& values);

}  // namespace game::lab
