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

/// Multiplies the colours of four pixels without alpha by scale / 256; each scale is 0 … 256, twice in 16 bits each.
/// The same as scaled() for all of them, without making pairs.
inline Four scaled(Four pixels, Four scale) {
  constexpr std::uint32_t every_other = 0x00ff00ffU;
  const auto by = std::bit_cast<Pair>(scale);
  const Pair red_blue = (std::bit_cast<Pair>(pixels & every_other) * by + 128) >> 8;
  const Pair green = std::bit_cast<Pair>(pixels >> 8 & every_other) * by + 128;
  return std::bit_cast<Four>(red_blue) | (std::bit_cast<Four>(green) & ~every_other);
}

/// Blends four premultiplied colours over pixels.
inline Four over(Four color, Four below) {
  const Four alpha = color >> 24;
  const Four visible = 256 - alpha - (alpha >> 7);
  return color + scaled(below, visible | visible << 16);
}

/// Interpolates from `a` to `b`; each weight is 0 … 255 of 256.
inline Pair mixed(Pair a, Pair b, Pair weight) { return ((a << 8) + (b - a) * weight + 128) >> 8; }

/// Returns the first pixels at both places, then the second ones.
inline Four both_twos(const std::uint32_t* a, const std::uint32_t* b) {
  std::uint64_t first = 0;
  std::uint64_t second = 0;
  std::memcpy(&first, a, sizeof first);
  std::memcpy(&second, b, sizeof second);
  return __builtin_shufflevector(std::bit_cast<Four>(pairs::Halves{first, 0}),
                                 std::bit_cast<Four>(pairs::Halves{second, 0}), 0, 4, 1, 5);
}

}  // namespace engine
