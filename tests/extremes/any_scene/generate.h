#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "tests/extremes/any_scene/scene.h"

namespace any_scene {

/// What a scene exercises.
enum class Family : unsigned char {
  rope_falls,    ///< one rope on scenery
  rope_self,     ///< the same with self_contact
  ropes_mutual,  ///< three ropes with cord_contact
  ropes_both,    ///< three ropes with both
  hold_points,   ///< one rope and five bodies, of which two hold points of it
  hold_between,  ///< the same, with holds between points
  grips_slip,    ///< grips of low strength
  ribbon_falls,  ///< a ribbon of 2 to 4 rows on scenery
  ribbons_both,  ///< ribbons with both contacts
  mixed,         ///< all of these
  heap,          ///< 8 to 16 short ropes and ribbons with both contacts, and bodies, between two walls
  heap_held,     ///< the same, of whose bodies up to three hold cords
  cut,           ///< as mixed; cords are cut, across or along, and break in every tenth tick
  tied,          ///< as cut; cords are also tied and untied in every tenth tick
  belts,         ///< as mixed; the surfaces of half of the solids are conveyor belts
  reeved,        ///< one or two ropes around wheels with loads, and as in mixed; rarely a cut and a tie
};
constexpr std::array<Family, 16> all_families = {
    Family::rope_falls,   Family::rope_self,    Family::ropes_mutual, Family::ropes_both,
    Family::hold_points,  Family::hold_between, Family::grips_slip,   Family::ribbon_falls,
    Family::ribbons_both, Family::mixed,        Family::heap,         Family::heap_held,
    Family::cut,          Family::tied,         Family::belts,        Family::reeved};
std::string_view name(Family family);

/// The difficulty of a scene.
enum class Difficulty : unsigned char {
  gentle,  ///< no overlaps, no drives
  wild,    ///< overlaps at the start, kinematic bodies, drags, reels, climbers, motors, and speeds up to 100 m/s
};
std::string_view name(Difficulty difficulty);

/// Identifies a generated scene.
struct SceneId {
  unsigned seed = 0;
  Family family = Family::rope_falls;
  Difficulty difficulty = Difficulty::gentle;
  std::optional<Preset> preset;  ///< empty: the seed decides

  bool operator==(const SceneId&) const = default;
};

/// Generates a scene. Equal arguments give equal scenes.
Scene generate(const SceneId& which);

}  // namespace any_scene
