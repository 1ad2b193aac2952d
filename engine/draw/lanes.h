#pragma once

#include <cstdint>

namespace engine {

/// The four channels of a colour, 0 … 255 each, with sixteen bits of room: blue, red, green, alpha from the lowest. One
/// multiplication does all four. The colours are multiplied by the alpha already, so none is above it.
using Lanes = std::uint64_t;

inline constexpr Lanes lanes_mask = 0x00ff00ff00ff00ffU;
inline constexpr Lanes lanes_half = 0x0080008000800080U;
inline constexpr Lanes white_lanes = lanes_mask;

/// From 0xAARRGGBB, and back.
constexpr Lanes spread(std::uint32_t argb) { return (argb | static_cast<Lanes>(argb) << 24U) & lanes_mask; }
constexpr std::uint32_t packed(Lanes lanes) { return static_cast<std::uint32_t>(lanes | lanes >> 24U); }

/// `share` (0 … 256) of the way from a to b.
constexpr Lanes mixed(Lanes a, Lanes b, Lanes share) {
  return (a * (256U - share) + b * share + lanes_half) >> 8U & lanes_mask;
}

/// The colour over the pixel below, 0x00RRGGBB.
constexpr std::uint32_t over(Lanes color, std::uint32_t below) {
  const Lanes alpha = color >> 48U;
  const Lanes under = 256U - alpha - (alpha >> 7U);
  return packed(color + ((spread(below) * under + lanes_half) >> 8U & lanes_mask)) & 0xffffffU;
}

/// All channels times scale / 256, 0 … 256.
constexpr Lanes scaled(Lanes color, Lanes scale) { return color * scale >> 8U & lanes_mask; }

/// The same, but the alpha stays.
constexpr Lanes darkened(Lanes color, Lanes scale) {
  constexpr Lanes alpha = 0x00ff000000000000U;
  return (scaled(color, scale) & ~alpha) | (color & alpha);
}

/// The colour times another, whose channels are given in 1/65536, 0 … 255.
constexpr Lanes tinted(Lanes color, std::int64_t b, std::int64_t r, std::int64_t g, std::int64_t a) {
  const auto lane = [color, a](unsigned shift, std::int64_t by) {
    const auto sixteen_bits = static_cast<Lanes>((by < a ? by : a) * 257) >> 16U;
    const Lanes scale = sixteen_bits + (sixteen_bits >> 15U);  // 65536 for 255, so that white changes nothing
    return ((color >> shift & 0xffU) * scale >> 16U) << shift;
  };
  return lane(0, b) | lane(16, r) | lane(32, g) | lane(48, a);
}

}  // namespace engine
