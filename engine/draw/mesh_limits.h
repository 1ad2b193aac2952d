#pragma once

namespace engine {

inline constexpr double max_coordinate = 1e12;   // px; above it doubles do not resolve a pixel
inline constexpr double min_double_area = 1e-9;  // px², twice the area of the smallest triangle that is drawn
inline constexpr double merge_distance = 0.01;   // px; points closer than this are merged

}  // namespace engine
