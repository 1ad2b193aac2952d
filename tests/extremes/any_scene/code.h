#pragma once

#include <string>
#include <string_view>

#include "tests/extremes/any_scene/scene.h"

namespace any_scene {

/// Returns a C++ function `any_scene::Scene name()` that makes the scene bit for bit; the code needs scene.h.
std::string to_code(const Scene& scene, std::string_view name);

}  // namespace any_scene
