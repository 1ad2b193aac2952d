#pragma once

#include <cstdint>

namespace engine {

/// The four channels of a premultiplied colour, 0 … 255 each, in 16 bits each: blue, red, green, alpha from the lowest.
/// One multiplication scales all four. No colour is larger than alpha.
using Lanes = std::uint64_t;

inline constexpr Lanes lanes_mask = 0x00ff00ff00ff00ffU;
inline constexpr Lanes lanes_half = 0x0080008000800080U;
inline constexpr Lanes white_lanes = lanes_mask;

/// Converts from 0xAARRGGBB.
constexpr Lanes spread(std::uint32_t argb) { return (argb | static_cast<Lanes>(argb) << 24U) & lanes_mask; }
/// Converts to 0xAARRGGBB.
constexpr std::uint32_t packed(Lanes lanes) { return static_cast<std::uint32_t>(lanes | lanes >> 24U); }

/// Interpolates linearly; `weight` is 0 … 256 for a … b.
constexpr Lanes mixed(Lanes a, Lanes b, Lanes weight) {
  return (a * (256U - weight) + b * weight + lanes_half) >> 8U & lanes_mask;
}

/// Blends the colour over a pixel, 0x00RRGGBB.
constexpr std::uint32_t over(Lanes color, std::uint32_t below) {
  const Lanes alpha = color >> 48U;
  const Lanes under = 256U - alpha - (alpha >> 7U);
  return packed(color + ((spread(below) * under + lanes_half) >> 8U & lanes_mask)) & 0xffffffU;
}

/// Multiplies all channels by scale / 256; `scale` is 0 … 256.
constexpr Lanes scaled(Lanes color, Lanes scale) { return color * scale >> 8U & lanes_mask; }

/// Multiplies the colours, but not alpha, by scale / 256.
constexpr Lanes darkened(Lanes color, Lanes scale) {
  constexpr Lanes alpha = 0x00ff000000000000U;
  return (scaled(color, scale) & ~alpha) | (color & alpha);
}

/// Multiplies the colour with another, whose channels are 0 … 255 in units of 1/65536.
constexpr Lanes tinted(Lanes color, std::int64_t b, std::int64_t r, std::int64_t g, std::int64_t a) {
  const auto lane = [color, a](unsigned shift, std::int64_t by) {
    const auto sixteen_bits = static_cast<Lanes>((by < a ? by : a) * 257) >> 16U;
    const Lanes scale = sixteen_bits + (sixteen_bits >> 15U);  // 65536 for 255, so that white changes nothing
    return ((color >> shift & 0xffU) * scale >> 16U) << shift;
  };
  return lane(0, b) | lane(16, r) | lane(32, g) | lane(48, a);
}

}  // namespace engine
