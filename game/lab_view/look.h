#pragma once

#include "engine/draw/color.h"

/// The colours of the lab.
namespace game::lab::look {

inline constexpr engine::Color sky_top{20, 27, 40};
inline constexpr engine::Color sky_bottom{37, 49, 70};
inline constexpr engine::Color grid{255, 255, 255, 16};
inline constexpr engine::Color axis{255, 255, 255, 40};
inline constexpr engine::Color side{16, 21, 31};   ///< of the columns at both sides
inline constexpr engine::Color strip{22, 29, 42};  ///< of the texts and plots between them
inline constexpr engine::Color field{30, 39, 56};  ///< of plots and sliders
inline constexpr engine::Color button{45, 60, 88};
inline constexpr engine::Color focus{52, 98, 168};
inline constexpr engine::Color white{255, 255, 255};
inline constexpr engine::Color faint{176, 190, 206};
inline constexpr engine::Color gold{255, 212, 92};

inline constexpr engine::Color cord{86, 204, 242};         ///< of this library
inline constexpr engine::Color cord_light{196, 240, 255};  ///< along its middle
inline constexpr engine::Color cloth{86, 204, 242, 110};
inline constexpr engine::Color chain{255, 150, 84};
inline constexpr engine::Color gap{255, 72, 88};    ///< between two links of a chain that are torn apart
inline constexpr engine::Color body{204, 150, 74};  ///< of a body that is awake
inline constexpr engine::Color body_rim{255, 222, 150};
inline constexpr engine::Color asleep{74, 86, 110};
inline constexpr engine::Color asleep_rim{132, 146, 172};
inline constexpr engine::Color fixed{62, 74, 98};
inline constexpr engine::Color fixed_rim{128, 144, 172};

// The points of the thesis's cords, as in Goto 2017, Fig. 4.1.
inline constexpr engine::Color free_point{110, 160, 255};
inline constexpr engine::Color operated_point{255, 220, 60};
inline constexpr engine::Color constrained_point{255, 84, 84};

}  // namespace game::lab::look
