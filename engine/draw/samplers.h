#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "engine/draw/image.h"
#include "engine/draw/lanes.h"
#include "engine/draw/textured_mesh.h"

/// Reads colours of an image; private to the rasteriser of textured meshes.
namespace engine {

/// The texels of an image level around a position, in texels.
class Texels {
 public:
  Texels(const Image::Level& level, const Texture& texture)
      : texels_(level.pixels.data()),
        width_(level.width),
        height_(level.height),
        repeat_u_(texture.along_u == Wrap::repeat),
        repeat_v_(texture.along_v == Wrap::repeat),
        is_opaque_(texture.image->is_opaque()) {}

  std::ptrdiff_t column(std::int64_t x) const {
    return repeat_u_ ? x & (width_ - 1) : std::clamp<std::int64_t>(x, 0, width_ - 1);
  }
  std::int64_t width() const { return width_; }
  bool repeats_along_u() const { return repeat_u_; }
  bool is_opaque() const { return is_opaque_; }
  const std::uint32_t* row(std::int64_t y) const {
    return texels_ + (repeat_v_ ? y & (height_ - 1) : std::clamp<std::int64_t>(y, 0, height_ - 1)) * width_;
  }

 private:
  const std::uint32_t* texels_;
  std::int64_t width_;
  std::int64_t height_;
  bool repeat_u_;
  bool repeat_v_;
  bool is_opaque_;
};

// The samplers return the colour of an image at a position in units of 1/65536 texels.
inline constexpr std::int64_t half_texel = 32768;

struct Nearest {
  Texels texels;
  Lanes operator()(std::int64_t u, std::int64_t v) const { return spread(texels.row(v >> 16)[texels.column(u >> 16)]); }
};

/// The same along a row of the image (constant v).
struct NearestRow {
  NearestRow(const Texels& all, std::int64_t v) : texels(all), row(all.row(v >> 16)) {}
  Lanes operator()(std::int64_t u, std::int64_t) const { return spread(row[texels.column(u >> 16)]); }

  Texels texels;
  const std::uint32_t* row;
};

/// The weight of the next texel, 0 … 255.
inline Lanes weight_of(std::int64_t x) { return static_cast<Lanes>(x & 0xffff) >> 8U; }

struct Linear {
  Texels texels;
  Lanes operator()(std::int64_t u, std::int64_t v) const {
    const std::int64_t x = u - half_texel;  // relative to the middle of a texel
    const std::int64_t y = v - half_texel;
    const std::uint32_t* const upper = texels.row(y >> 16);
    const std::uint32_t* const lower = texels.row((y >> 16) + 1);
    const std::ptrdiff_t left = texels.column(x >> 16);
    const std::ptrdiff_t right = texels.column((x >> 16) + 1);
    return mixed(mixed(spread(upper[left]), spread(upper[right]), weight_of(x)),
                 mixed(spread(lower[left]), spread(lower[right]), weight_of(x)), weight_of(y));
  }
};

/// Linear filtering along a row of the image (constant v): caches the vertical interpolation of the last two columns.
class LinearRow {
 public:
  LinearRow(const Texels& texels, std::int64_t v)
      : texels_(texels),
        upper_(texels.row((v - half_texel) >> 16)),
        lower_(texels.row(((v - half_texel) >> 16) + 1)),
        weight_(weight_of(v - half_texel)) {}

  Lanes operator()(std::int64_t u, std::int64_t) {
    const std::int64_t x = u - half_texel;
    if (const std::int64_t left = x >> 16; left != left_column_) {
      left_ = left == left_column_ + 1 ? right_ : column(left);
      right_ = column(left + 1);
      left_column_ = left;
    }
    return left_ == right_ ? left_ : mixed(left_, right_, weight_of(x));
  }

 private:
  Lanes column(std::int64_t x) const {
    const std::ptrdiff_t at = texels_.column(x);
    return upper_[at] == lower_[at] ? spread(upper_[at]) : mixed(spread(upper_[at]), spread(lower_[at]), weight_);
  }

  const Texels& texels_;
  const std::uint32_t* upper_;
  const std::uint32_t* lower_;
  Lanes weight_;
  std::int64_t left_column_ = std::numeric_limits<std::int64_t>::min() / 2;  // none
  Lanes left_ = 0;
  Lanes right_ = 0;
};

/// Without an image: white.
struct Plain {
  Lanes operator()(std::int64_t, std::int64_t) const { return white_lanes; }
};

}  // namespace engine
