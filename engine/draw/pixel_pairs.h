#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

/// Arithmetic on several pixels at once; private to the rasteriser. The types are vectors of the compiler, which has
/// instructions for them on x86-64 and arm64 without any flag, and the same bits everywhere.
namespace engine {

static_assert(std::endian::native == std::endian::little, "the order of the channels in a pixel");

/// Four pixels, 0xAARRGGBB.
using Four __attribute__((vector_size(16))) = std::uint32_t;
/// The channels of two premultiplied pixels, 0 … 255 in 16 bits each: blue, green, red, alpha, twice. No colour is
/// larger than alpha.
using Pair __attribute__((vector_size(16))) = std::uint16_t;

namespace pairs {

using Bytes __attribute__((vector_size(16))) = std::uint8_t;
using Halves __attribute__((vector_size(16))) = std::uint64_t;

inline constexpr Four no_alpha = {0xffffffU, 0xffffffU, 0xffffffU, 0xffffffU};

}  // namespace pairs

inline Pair lower_pair(Four four) {
  return std::bit_cast<Pair>(__builtin_shufflevector(std::bit_cast<pairs::Bytes>(four), pairs::Bytes{}, 0, 16, 1, 17, 2,
                                                     18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23));
}

inline Pair upper_pair(Four four) {
  return std::bit_cast<Pair>(__builtin_shufflevector(std::bit_cast<pairs::Bytes>(four), pairs::Bytes{}, 8, 24, 9, 25,
                                                     10, 26, 11, 27, 12, 28, 13, 29, 14, 30, 15, 31));
}

/// The inverse of lower_pair and upper_pair.
inline Four joined(Pair lower, Pair upper) {
  return std::bit_cast<Four>(__builtin_shufflevector(std::bit_cast<pairs::Bytes>(lower),
                                                     std::bit_cast<pairs::Bytes>(upper), 0, 2, 4, 6, 8, 10, 12, 14, 16,
                                                     18, 20, 22, 24, 26, 28, 30));
}

inline Four load_four(const std::uint32_t* from) {
  Four four;
  std::memcpy(&four, from, sizeof four);
  return four;
}
/// Stores without alpha.
inline void store_four(std::uint32_t* to, Four four) {
  four &= pairs::no_alpha;
  std::memcpy(to, &four, sizeof four);
}

inline Pair load_pair(const std::uint32_t* from) {
  std::uint64_t two = 0;
  std::memcpy(&two, from, sizeof two);
  return lower_pair(std::bit_cast<Four>(pairs::Halves{two, 0}));
}
/// Stores without alpha.
inline void store_pair(std::uint32_t* to, Pair pair) {
  const std::uint64_t two = std::bit_cast<pairs::Halves>(joined(pair, pair) & pairs::no_alpha)[0];
  std::memcpy(to, &two, sizeof two);
}

/// One pixel as the first of a pair.
inline Pair load_one(const std::uint32_t* from) { return lower_pair(Four{*from, 0, 0, 0}); }
inline void store_one(std::uint32_t* to, Pair pair) { *to = (joined(pair, pair) & pairs::no_alpha)[0]; }

/// Multiplies by scale / 256; each scale is 0 … 256.
inline Pair scaled(Pair color, Pair scale) { return (color * scale + 128) >> 8; }

/// Returns what of the pixels below remains visible, 0 … 256 for each channel.
inline Pair under(Pair color) {
  const Pair alpha = __builtin_shufflevector(color, color, 3, 3, 3, 3, 7, 7, 7, 7);
  return 256 - alpha - (alpha >> 7);
}

/// Blends the colours over pixels.
inline Pair over(Pair color, Pair below) { return color + scaled(below, under(color)); }

/// The weights of two neighbouring texels: (256 − w)/256 and w/256 in the four channels of each, for w = 0 … 255.
struct TexelWeights {
  alignas(16) std::array<std::array<std::uint16_t, 8>, 256> of{};
  constexpr TexelWeights() {
    for (std::size_t w = 0; w < of.size(); ++w)
      for (std::size_t k = 0; k < 8; ++k) of[w][k] = static_cast<std::uint16_t>(k < 4 ? 256 - w : w);
  }
  Pair operator[](std::size_t w) const {
    Pair pair;
    std::memcpy(&pair, of[w].data(), sizeof pair);
    return pair;
  }
};
inline constexpr TexelWeights texel_weights;

/// Adds the first pixel to the second one in both pairs, which are weighted, and divides by 256.
inline Pair mixed_texels(Pair first, Pair second) {
  const auto a = std::bit_cast<pairs::Halves>(first);
  const auto b = std::bit_cast<pairs::Halves>(second);
  const auto left = std::bit_cast<Pair>(__builtin_shufflevector(a, b, 0, 2));
  const auto right = std::bit_cast<Pair>(__builtin_shufflevector(a, b, 1, 3));
  return (left + right + 128) >> 8;
}

}  // namespace engine
