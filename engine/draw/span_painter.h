#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/draw/pixel_pairs.h"
#include "engine/draw/samplers.h"

/// Paints the pixels of a row that are in a triangle; private to the rasteriser of textured meshes.
namespace engine {

/// A colour along a row of pixels, which multiplies the image: blue, green, red and alpha, premultiplied, 0 … 255 in
/// units of 1/65536.
struct ColorRamp {
  using Channels __attribute__((vector_size(16))) = std::int32_t;

  Channels here{}, step{};

  bool is_constant() const { return (step[0] | step[1] | step[2] | step[3]) == 0; }
  bool is_white() const {
    constexpr std::int32_t white = 255 << 16;
    return here[0] == white && here[1] == white && here[2] == white && here[3] == white;
  }
  bool is_opaque() const { return here[3] == 255 << 16; }
};

// A tint changes the colours of the image along a row, two pixels at a time.

struct NoTint {
  Pair operator()(Pair color) const { return color; }
};

/// One colour for the whole row.
struct EvenTint {
  explicit EvenTint(const ColorRamp& color) {
    const auto scale_of = [&](std::size_t k) {
      return static_cast<std::uint16_t>((std::int64_t{color.here[k]} * 257 + (1 << 23)) >> 24);  // 256 for white
    };
    for (std::size_t k = 0; k < 4; ++k) scale[k] = scale[k + 4] = std::min(scale_of(k), scale_of(3));
  }
  Pair operator()(Pair color) const { return scaled(color, scale); }

  Pair scale{};
};

/// A colour that changes along the row.
struct RampTint {
  explicit RampTint(const ColorRamp& color)
      : first(color.here), second(color.here + color.step), step(color.step + color.step) {}

  Pair operator()(Pair color) {
    using Signed __attribute__((vector_size(16))) = std::int16_t;
    const Signed whole =
        __builtin_shufflevector(std::bit_cast<Signed>(first), std::bit_cast<Signed>(second), 1, 3, 5, 7, 9, 11, 13, 15);
    first += step;
    second += step;
    // By rounding, a colour can be outside 0 … alpha by one.
    const Signed positive = whole > 0 ? whole : Signed{};
    const Signed alpha = __builtin_shufflevector(positive, positive, 3, 3, 3, 3, 7, 7, 7, 7);
    const Signed valid = positive < alpha ? positive : alpha;
    return scaled(color, std::bit_cast<Pair>(valid + (valid >> 7)));
  }

  ColorRamp::Channels first, second, step;
};

/// `covers`: the colours are opaque.
template <bool covers, typename Sample, typename Tint>
void paint_pairs(std::uint32_t* pixel, int count, Sample sample, Tint tint) {
  for (; count >= 4; count -= 4, pixel += 4) {
    const Pair first = tint(sample.pair());
    const Four color = joined(first, tint(sample.pair()));
    store_four(pixel, covers ? color : over(color, load_four(pixel)));
  }
  if (count >= 2) {
    const Pair color = tint(sample.pair());
    store_pair(pixel, covers ? color : over(color, load_pair(pixel)));
    count -= 2;
    pixel += 2;
  }
  if (count == 0) return;
  const Pair color = tint(sample.pair());
  store_one(pixel, covers ? color : over(color, load_one(pixel)));
}

/// Paints an image with the cheapest method for the colours of the row.
template <typename Sample>
void paint_image(std::uint32_t* pixel, int count, const Sample& sample, const ColorRamp& color, bool is_opaque) {
  if (!color.is_constant()) return paint_pairs<false>(pixel, count, sample, RampTint(color));
  const bool covers = is_opaque && color.is_opaque();
  if (color.is_white()) {
    return covers ? paint_pairs<true>(pixel, count, sample, NoTint{})
                  : paint_pairs<false>(pixel, count, sample, NoTint{});
  }
  return covers ? paint_pairs<true>(pixel, count, sample, EvenTint(color))
                : paint_pairs<false>(pixel, count, sample, EvenTint(color));
}

/// Paints one colour.
inline void paint_flat(std::uint32_t* pixel, int count, Pair color) {
  const auto full = joined(color, color)[0];
  if (full >> 24U == 255U) {
    std::fill_n(pixel, count, full & 0xffffffU);
    return;
  }
  const Four four = joined(color, color);
  for (; count >= 4; count -= 4, pixel += 4) store_four(pixel, over(four, load_four(pixel)));
  for (; count > 0; --count, ++pixel) store_one(pixel, over(color, load_one(pixel)));
}

/// Copies a row of texels, one for each pixel.
inline void copy_texels(std::uint32_t* pixel, int count, const std::uint32_t* texel) {
  for (; count >= 4; count -= 4, pixel += 4, texel += 4) {
    std::array<std::uint64_t, 2> two{};
    std::memcpy(two.data(), texel, sizeof two);
    constexpr std::uint64_t alphas = 0xff000000ff000000U;
    const Four color = load_four(texel);
    if ((two[0] & two[1] & alphas) == alphas) {
      store_four(pixel, color);
    } else if ((two[0] | two[1]) != 0) {
      store_four(pixel, over(color, load_four(pixel)));
    }
  }
  for (; count > 0; --count, ++pixel, ++texel) store_one(pixel, over(load_one(texel), load_one(pixel)));
}

/// Paints an opaque image without interpolation; the same as paint_image, four pixels at a time.
template <bool repeats>
void paint_opaque(std::uint32_t* pixel, int count, NearestRow<repeats> sample, const ColorRamp& color) {
  const EvenTint tint(color);
  for (; count >= 4; count -= 4, pixel += 4) {
    const Four texels = sample.four();
    store_four(pixel, joined(tint(lower_pair(texels)), tint(upper_pair(texels))));
  }
  paint_pairs<true>(pixel, count, sample, tint);
}

/// Paints an image row by row. Where a texel covers exactly a pixel and has its own colour, it is copied.
template <bool repeats>
void paint_nearest_row(std::uint32_t* pixel, int count, const NearestRow<repeats>& sample, const ColorRamp& color) {
  constexpr std::int64_t one_texel = 1 << 16;
  const std::int64_t first = sample.u.here >> 16;
  const bool is_inside = first >= 0 && first + count <= sample.texels.width();
  if (color.is_constant() && color.is_white() && sample.u.step == one_texel && is_inside)
    return copy_texels(pixel, count, sample.row + first);
  if (color.is_constant() && color.is_opaque() && sample.texels.is_opaque())
    return paint_opaque(pixel, count, sample, color);
  paint_image(pixel, count, sample, color, sample.texels.is_opaque());
}

}  // namespace engine
