#pragma once

#include <string_view>

#include "ribbon/definition.h"
#include "tests/fuzz/require.h"

namespace fuzz {

/// Calls `what`. Returns false if it throws; then the message names the accepted range, and the cord is unchanged.
template <typename Cord, typename Do>
bool accepts(Cord& cord, Do&& what) {
  const auto before = cord.save();
  try {
    what();
    return true;
  } catch (const ribbon::DefinitionError& error) {
    require(std::string_view(error.what()).find("accepted") != std::string_view::npos,
            "the message says what is accepted", error.what());
    require(cord.save() == before, "a refused call changes nothing", error.what());
    return false;
  }
}

template <typename Cord>
void require_finite(const Cord& cord) {
  for (const ribbon::Vec2 x : cord.positions()) require(is_finite(x), "positions of cords are finite");
  for (const ribbon::Vec2 v : cord.velocities()) require(is_finite(v), "velocities of cords are finite");
}

}  // namespace fuzz
