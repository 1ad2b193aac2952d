#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/scene/tiled_map.h"
#include "ribbon/box2d/coupling.h"

namespace game {

/// A number of a cord that can be tuned: a property of its object in the map.
struct Dial {
  const char* property;
  const char* unit;
  double least, most;  ///< of the slider; what is typed may be anything that the map takes
  bool logarithmic = false;
  bool whole = false;
  /// A term of the model that can be switched off; `on`: what it begins with when it is switched on.
  bool term = false;
  double on = 0.0;
  /// What the cord has now; infinite: it does not stretch.
  std::function<double(const ribbon::box2d::Coupling&, ribbon::box2d::CordId)> value;
};

/// A term that is there or not, without a number.
struct Switch {
  const char* property;
  std::function<bool(const ribbon::box2d::Coupling&, ribbon::box2d::CordId)> value;
};

/// What can be tuned of a cord, by its solver, and rows.
std::vector<Dial> dials_of(const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord);
std::vector<Switch> switches_of(const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord);

/// The value that switches a term off: none takes the property away.
std::optional<engine::Properties::Value> off_value(const Dial& dial);

}  // namespace game
