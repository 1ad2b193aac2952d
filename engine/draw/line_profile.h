#pragma once

namespace engine {

/// Cover across a shape, from its middle outwards, px: `cover` up to `core`, then falling to 0 at `outer`.
struct Profile {
  double core;
  double outer;
  double cover;
};

/// Of a line of this width [px]. What is narrower than a pixel keeps its total cover, the volume under this profile,
/// and gets fainter instead. The two cases meet in a border that falls from 1 to 0 over one pixel each way.
inline Profile line_profile(double width) {
  const double half = width / 2.0;
  if (half < 0.5) return {0.0, 1.0, width};
  return {half - 0.5, half + 0.5, 1.0};
}

}  // namespace engine
