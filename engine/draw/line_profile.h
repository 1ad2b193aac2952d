#pragma once

namespace engine {

/// The cover across a shape by the distance from its middle in px: `cover` up to `core`, then falling to 0 at `outer`.
struct Profile {
  double core;
  double outer;
  double cover;

  /// Returns the cover at a distance, px.
  double at(double distance) const {
    const double falling = cover * (outer - distance) / (outer - core);
    return falling < 0.0 ? 0.0 : falling < cover ? falling : cover;
  }
};

/// Returns the profile of a line of `width` px. A line narrower than a pixel has the same total cover, the area under
/// the profile, but is translucent. Both cases agree at a width of 1.
inline Profile line_profile(double width) {
  const double half = width / 2.0;
  if (half < 0.5) return {0.0, 1.0, width};
  return {half - 0.5, half + 0.5, 1.0};
}

}  // namespace engine
