#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace game {

/// The place where a level is: its look only, without effect on a run.
enum class Place { hills, cave, harbour, storm };

inline constexpr std::array<Place, 4> places = {Place::hills, Place::cave, Place::harbour, Place::storm};

/// The name of a place in a level file.
constexpr std::string_view place_name(Place place) {
  constexpr std::array<std::string_view, 4> names = {"hills", "cave", "harbour", "storm"};
  return names[static_cast<std::size_t>(place)];
}

}  // namespace game
