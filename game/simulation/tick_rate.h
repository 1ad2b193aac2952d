#pragma once

namespace game {

inline constexpr int ticks_per_second = 60;
inline constexpr double tick_dt = 1.0 / ticks_per_second;  // s

}  // namespace game
