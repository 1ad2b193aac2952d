#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/scene/tiled_map.h"
#include "ribbon/box2d/coupling.h"

namespace game {

/// A numeric parameter of a cord that can be tuned: a property of its object in the map.
struct Parameter {
  const char* property;
  const char* unit;
  double min, max;  ///< of the slider; typed values may be any that the map accepts
  bool logarithmic = false;
  bool whole = false;
  bool is_term = false;   ///< the parameter switches a term of the model off
  double on_value = 0.0;  ///< the value when the term is switched on
  /// Returns the current value; infinite stretch_stiffness for inextensible cords.
  std::function<double(const ribbon::box2d::Coupling&, ribbon::box2d::CordId)> value;
};

/// A boolean parameter.
struct Switch {
  const char* property;
  std::function<bool(const ribbon::box2d::Coupling&, ribbon::box2d::CordId)> value;
};

/// Return the parameters of a cord, by its solver and number of rows.
std::vector<Parameter> parameters_of(const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord);
std::vector<Switch> switches_of(const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord);

/// Returns the value that switches a term off; nothing if the property must be removed.
std::optional<engine::Properties::Value> off_value(const Parameter& parameter);

}  // namespace game
