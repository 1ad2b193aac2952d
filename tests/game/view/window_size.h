#pragma once

namespace game {

constexpr int window_width = 1280;  ///< px
constexpr int window_height = 720;  ///< px

}  // namespace game
