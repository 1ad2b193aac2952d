#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/scene/tiled_map.h"
#include "ribbon/vec2.h"

namespace game {

class Simulation;
struct Level;

/// The kinds of things that can be placed in a sandbox. Recordings have their names: see thing_name.
enum class Thing : std::uint8_t { rope, hanging_rope, curtain, trampoline, crate, ball, peg };
inline constexpr std::array all_things = {Thing::rope,  Thing::hanging_rope, Thing::curtain, Thing::trampoline,
                                          Thing::crate, Thing::ball,         Thing::peg};

/// Returns the name in recordings: `hanging_rope`.
std::string_view thing_name(Thing thing);
/// Returns whether it has two ends, as a rope has; else it is at one place.
bool has_two_ends(Thing thing);

/// A thing of the yard at its start.
struct PlacedThing {
  Thing thing = Thing::rope;
  ribbon::Vec2 first{};   ///< m, its first end or its centre; whole centimetres
  ribbon::Vec2 second{};  ///< m, its second end; likewise. Equal to `first` for a thing at one place

  bool operator==(const PlacedThing&) const = default;
};

/// Returns the thing between two places, or at the first one, rounded to centimetres.
PlacedThing thing_at(Thing thing, ribbon::Vec2 first, ribbon::Vec2 second);

/// What the player has placed in a sandbox. A recording has it as a setting, so that the run can be repeated.
struct Yard {
  static constexpr std::size_t max_things = 24;
  static constexpr double min_span = 1.0;     ///< m, between the ends of a thing
  static constexpr double max_span = 10.0;    ///< m
  static constexpr double edge = 0.5;         ///< m, of the level, where nothing can be placed
  static constexpr double pick_range = 0.75;  ///< m, from the pointer to a thing that it picks

  std::vector<PlacedThing> things;
  std::optional<ribbon::Vec2> start;  ///< m, feet: where the player starts instead of the level's start

  bool operator==(const Yard&) const = default;
};

/// Why a thing cannot be placed.
enum class PlacingFault : std::uint8_t { too_many, outside, too_short, too_long, in_the_way };

/// Returns why the thing cannot be added to a run that has just begun with this yard. `except`: the index of a thing
/// that it replaces.
std::optional<PlacingFault> fault_of(const Simulation& simulation, const PlacedThing& thing,
                                     std::optional<std::size_t> except = {});
/// Returns the index of the thing nearest to a place, within Yard::pick_range.
std::optional<std::size_t> nearest_thing(const Yard& yard, ribbon::Vec2 at);

/// Returns the yard with the start at the player's feet, rounded to centimetres.
Yard with_start_at(Yard yard, const Simulation& simulation);

/// Returns the objects of the map from which a scene builds the yard, in the order of its things.
std::vector<engine::MapObject> objects_of(const Yard& yard);
/// Returns whether an object of the map is a placed thing.
bool is_placed(int object);
/// Replaces the yard of a level.
void set_yard(Level& level, const Yard& yard);

/// Returns the yard as text: "start 150 300;rope 100 200 400 200;ball 50 60", in cm. Empty for a yard of the file.
std::string yard_text(const Yard& yard);
/// Returns the yard of such a text. Nothing if it is not one, or one that cannot be placed in the level.
std::optional<Yard> yard_of(std::string_view text, const Level& level);

}  // namespace game
