#pragma once

namespace game {

// Of the pictures of runs without a window, px.
inline constexpr int picture_width = 1280;
inline constexpr int picture_height = 720;

}  // namespace game
