#pragma once

#include "engine/draw/color.h"

/// The colours of texts over a run.
namespace game::hud_style {

inline constexpr engine::Color paper{20, 24, 34, 170};
inline constexpr engine::Color white{255, 255, 255};
inline constexpr engine::Color faint{206, 216, 226};
inline constexpr engine::Color gold{255, 212, 92};

}  // namespace game::hud_style
