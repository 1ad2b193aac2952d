#pragma once

#include <string_view>

#include "ribbon/definition.h"
#include "tests/fuzz/demand.h"

namespace fuzz {

/// Calls `what`. Returns false if it throws; then the message names the accepted range, and the cord is unchanged.
template <typename Cord, typename Do>
bool accepts(Cord& cord, Do&& what) {
  const auto before = cord.save();
  try {
    what();
    return true;
  } catch (const ribbon::DefinitionError& error) {
    demand(std::string_view(error.what()).find("accepted") != std::string_view::npos, "it is said what is accepted",
           error.what());
    demand(cord.save() == before, "a refusal changes nothing", error.what());
    return false;
  }
}

template <typename Cord>
void demand_finite(const Cord& cord) {
  for (const ribbon::Vec2 x : cord.positions()) demand(is_finite(x), "the cord is somewhere");
  for (const ribbon::Vec2 v : cord.velocities()) demand(is_finite(v), "the cord goes somewhere");
}

}  // namespace fuzz
