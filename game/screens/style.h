#pragma once

#include <cstdint>

#include "engine/draw/canvas.h"
#include "game/simulation/medals.h"

/// The colours of menus.
namespace game::style {

inline constexpr engine::Color paper{20, 24, 34, 215};
inline constexpr engine::Color card{22, 27, 39, 245};  ///< nearly opaque: what is below does not disturb the text
inline constexpr engine::Color night_top{24, 34, 56};
inline constexpr engine::Color night_bottom{54, 78, 112};
inline constexpr engine::Color shade{12, 16, 26, 110};  ///< over a paused run
inline constexpr engine::Color white{255, 255, 255};
inline constexpr engine::Color faint{206, 216, 226};
inline constexpr engine::Color gold{255, 212, 92};
inline constexpr engine::Color silver{208, 214, 222};
inline constexpr engine::Color bronze{214, 150, 92};
inline constexpr engine::Color focus{52, 98, 168, 235};
inline constexpr engine::Color focus_card{48, 84, 138};
inline constexpr engine::Color sky_top{92, 160, 214};
inline constexpr engine::Color sky_bottom{214, 236, 246};

/// A shade of a colour for its rim.
constexpr engine::Color dark_of(engine::Color c) {
  const auto darker = [](std::uint8_t channel) { return static_cast<std::uint8_t>(channel * 5 / 8); };
  return {darker(c.r), darker(c.g), darker(c.b)};
}

inline engine::Color of_medal(Medal medal) {
  return medal == Medal::gold ? gold : medal == Medal::silver ? silver : bronze;
}

}  // namespace game::style
