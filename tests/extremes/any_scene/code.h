#pragma once

#include <string>
#include <string_view>

#include "tests/extremes/any_scene/scene.h"

namespace any_scene {

/// A function `any_scene::Scene name()` in C++ that makes the scene to the last bit; it needs scene.h.
std::string to_code(const Scene& scene, std::string_view name);

}  // namespace any_scene
