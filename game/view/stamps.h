#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>

#include "engine/draw/image.h"

namespace game {

/// Copies of images in the sizes in which they are drawn, with their colour. A copy is drawn texel by pixel, which is
/// several times faster than scaling the image in each frame.
class Stamps {
 public:
  static constexpr std::size_t max_count = 96;

  struct Stamp {
    engine::Image image;  ///< the picture is at its top left; the rest is transparent
    int width, height;    ///< of the picture, texels
  };

  /// Returns a copy of width × height texels, 1 … 4096 each, multiplied with a colour. The reference is valid until the
  /// next call. `image` must outlive this object.
  const Stamp& get(const engine::Image& image, int width, int height, engine::Color color);
  void clear() { made_.clear(); }
  std::size_t count() const { return made_.size(); }

 private:
  using Key = std::tuple<const engine::Image*, int, int, std::uint8_t, std::uint8_t, std::uint8_t, std::uint8_t>;
  std::map<Key, Stamp> made_;  // for look-up only
};

}  // namespace game
