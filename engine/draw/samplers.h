#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/draw/image.h"
#include "engine/draw/pixel_pairs.h"
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

  /// `repeats` has to be repeats_along_u().
  template <bool repeats>
  std::ptrdiff_t column(std::int64_t x) const {
    const std::int64_t inside = repeats ? x & (width_ - 1) : std::clamp<std::int64_t>(x, 0, width_ - 1);
    return static_cast<std::ptrdiff_t>(inside);
  }
  /// Returns the same place of the image, in the image if it repeats; in units of 1/65536 texels.
  std::int64_t wrapped_u(std::int64_t u) const { return repeat_u_ ? u & ((width_ << 16) - 1) : u; }
  std::int64_t wrapped_v(std::int64_t v) const { return repeat_v_ ? v & ((height_ << 16) - 1) : v; }
  std::int64_t width() const { return width_; }
  std::int64_t height() const { return height_; }
  const std::uint32_t* data() const { return texels_; }
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

/// A quantity along a row of pixels, in units of 1/65536.
struct Ramp {
  std::int64_t here = 0;
  std::int64_t step = 0;  // per pixel

  std::int64_t next() {
    const std::int64_t value = here;
    here += step;
    return value;
  }
};

// A sampler moves along a row of pixels, and returns their colours in the image two by two. Positions are in units of
// 1/65536 texels.
inline constexpr std::int64_t half_texel = 32768;

/// The weight of the next texel, 0 … 255.
inline std::uint16_t weight_of(std::int64_t x) { return static_cast<std::uint16_t>((x & 0xffff) >> 8); }

/// The weights of the next texel along a row of pixels, two by two: one for each channel of a Pair.
class Weights {
 public:
  explicit Weights(const Ramp& position) : here_(lanes(position.here, position.here + position.step)) {
    step_ = lanes(2 * position.step, 2 * position.step);
  }
  Pair next() {
    const Pair weights = here_ >> 8;
    here_ += step_;
    return weights;
  }

 private:
  /// The lower 16 bits of two positions.
  static Pair lanes(std::int64_t first, std::int64_t second) {
    const auto a = static_cast<std::uint16_t>(first);
    const auto b = static_cast<std::uint16_t>(second);
    return Pair{a, a, a, a, b, b, b, b};
  }

  Pair here_, step_;
};

template <bool repeats>
struct Nearest {
  const Texels& texels;
  Ramp u, v;

  std::uint32_t one() { return texels.row(v.next() >> 16)[texels.column<repeats>(u.next() >> 16)]; }
  Pair pair() {
    const std::uint32_t first = one();
    return lower_pair(Four{first, one(), 0, 0});
  }
};

/// The same along a row of the image (constant v).
template <bool repeats>
struct NearestRow {
  const Texels& texels;
  const std::uint32_t* row;
  Ramp u;

  std::uint32_t one() { return row[texels.column<repeats>(u.next() >> 16)]; }
  Pair pair() {
    const std::uint32_t first = one();
    return lower_pair(Four{first, one(), 0, 0});
  }
  Four four() {
    const std::uint32_t a = one();
    const std::uint32_t b = one();
    const std::uint32_t c = one();
    return Four{a, b, c, one()};
  }
};

/// The texels around two positions: the left ones of the first and of the second, then the right ones.
struct TexelQuads {
  Four upper, lower;
};

/// Interpolates between four texels around each position.
template <typename Neighbours>
class Linear {
 public:
  /// `u` and `v`: relative to the middles of texels.
  Linear(const Neighbours& neighbours, const Ramp& u, const Ramp& v)
      : neighbours_(neighbours), u_(u), v_(v), right_(u), down_(v) {}

  Pair pair() {
    const TexelQuads quads = neighbours_(u_, v_);
    const Pair down = down_.next();
    const Pair left = mixed(lower_pair(quads.upper), lower_pair(quads.lower), down);
    const Pair right = mixed(upper_pair(quads.upper), upper_pair(quads.lower), down);
    return mixed(left, right, right_.next());
  }

 private:
  Neighbours neighbours_;
  Ramp u_, v_;
  Weights right_, down_;
};

/// Finds them anywhere in a plane of repeated or extended images.
template <bool repeats>
struct NeighboursAnywhere {
  const Texels& texels;

  TexelQuads operator()(Ramp& u, Ramp& v) const {
    const Rows first(texels, v.next());
    const std::int64_t x = u.next() >> 16;
    const Rows second(texels, v.next());
    const std::int64_t z = u.next() >> 16;
    const std::ptrdiff_t a = texels.column<repeats>(x);
    const std::ptrdiff_t b = texels.column<repeats>(z);
    const std::ptrdiff_t c = texels.column<repeats>(x + 1);
    const std::ptrdiff_t d = texels.column<repeats>(z + 1);
    return {Four{first.upper[a], second.upper[b], first.upper[c], second.upper[d]},
            Four{first.lower[a], second.lower[b], first.lower[c], second.lower[d]}};
  }

 private:
  struct Rows {
    Rows(const Texels& texels, std::int64_t y) : upper(texels.row(y >> 16)), lower(texels.row((y >> 16) + 1)) {}
    const std::uint32_t *upper, *lower;
  };
};

/// Finds them where all are in the image.
struct NeighboursInside {
  const std::uint32_t* texels;
  std::ptrdiff_t width;

  TexelQuads operator()(Ramp& u, Ramp& v) const {
    const std::uint32_t* const first = at(u, v);
    const std::uint32_t* const second = at(u, v);
    return {both_twos(first, second), both_twos(first + width, second + width)};
  }

 private:
  const std::uint32_t* at(Ramp& u, Ramp& v) const { return texels + (v.next() >> 16) * width + (u.next() >> 16); }
};

/// Returns whether the texels around all positions of a row are in an image of this length. `count`: pixels.
inline bool is_inside(const Ramp& position, int count, std::int64_t length) {
  const std::int64_t first = position.here >> 16;
  const std::int64_t last = (position.here + position.step * count) >> 16;  // one more, since they are read two by two
  return std::min(first, last) >= 0 && std::max(first, last) + 1 < length;
}

/// Linear filtering along a row of the image (constant v): the texels that the pixels touch are interpolated
/// vertically, and stored in a row.
class LinearRow {
 public:
  /// Returns whether this is cheaper than Linear: it is not where a pixel has many texels.
  static bool suits(const Ramp& u, int count) { return touched(u, count) <= 4 * std::int64_t{count} + 8; }

  /// `store` is overwritten and has to live as long as this.
  LinearRow(const Texels& texels, const Ramp& u, std::int64_t v, int count, std::vector<std::uint32_t>& store)
      : u_{u.here - half_texel, u.step}, weights_(u_) {
    const std::int64_t low = std::min(first(u), last(u, count));
    u_.here -= low << 16;
    store.resize(static_cast<std::size_t>(touched(u, count)));
    const std::int64_t y = v - half_texel;
    const Rows rows{texels.row(y >> 16), texels.row((y >> 16) + 1), weight_of(y)};
    if (texels.repeats_along_u()) {
      fill<true>(texels, rows, low, store);
    } else {
      fill<false>(texels, rows, low, store);
    }
    row_ = store.data();
  }

  Pair pair() {
    const std::uint32_t* const first = row_ + (u_.next() >> 16);
    const Four twos = both_twos(first, row_ + (u_.next() >> 16));
    return mixed(lower_pair(twos), upper_pair(twos), weights_.next());
  }

 private:
  struct Rows {
    const std::uint32_t* upper;
    const std::uint32_t* lower;
    std::uint16_t weight;

    Pair mix(Pair above, Pair below) const { return mixed(above, below, Pair{} + weight); }
  };

  static std::int64_t first(const Ramp& u) { return (u.here - half_texel) >> 16; }
  /// One pixel more than `count`, since pixels are read two by two.
  static std::int64_t last(const Ramp& u, int count) { return (u.here + u.step * count - half_texel) >> 16; }
  static std::int64_t touched(const Ramp& u, int count) { return std::abs(last(u, count) - first(u)) + 2; }

  template <bool repeats>
  static void fill(const Texels& texels, const Rows& rows, std::int64_t low, std::vector<std::uint32_t>& store) {
    for (std::size_t k = 0; k < store.size();) {
      const std::int64_t x = low + static_cast<std::int64_t>(k);
      const std::ptrdiff_t at = texels.column<repeats>(x);
      const bool is_inside = repeats || (x >= 0 && x < texels.width());
      // Four at a time where they are neighbours in the image.
      if (is_inside && k + 4 <= store.size() && at + 4 <= texels.width()) {
        const Four upper = load_four(rows.upper + at);
        const Four lower = load_four(rows.lower + at);
        const Four both =
            joined(rows.mix(lower_pair(upper), lower_pair(lower)), rows.mix(upper_pair(upper), upper_pair(lower)));
        std::memcpy(store.data() + k, &both, sizeof both);
        k += 4;
      } else {
        const Pair both = rows.mix(load_one(rows.upper + at), load_one(rows.lower + at));
        store[k] = joined(both, both)[0];
        ++k;
      }
    }
  }

  Ramp u_;
  Weights weights_;
  const std::uint32_t* row_ = nullptr;
};

/// Without an image: white.
struct Plain {
  Pair pair() { return Pair{} + 255; }
};

}  // namespace engine
