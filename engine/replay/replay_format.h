#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

/// Constants and checksums shared by the writer and the reader of replays. engine/replay/replay.h describes the layout.
namespace engine::replay_format {

inline constexpr std::string_view magic = "ropeswing-replay ";
inline constexpr int version = 1;

inline constexpr std::size_t max_header_bytes = 65536;  // of the JSON line, including its line feed
inline constexpr std::size_t max_parts = 4096;
/// Added to the number of parts if the tick has the pointer of the second player. The complement protects it too.
inline constexpr std::uint16_t second_pointer_flag = 0x8000;
inline constexpr int max_tick_rate = 1'000'000;
inline constexpr int max_players = 2;

inline constexpr std::uint8_t tick_tag = 'T';
inline constexpr std::uint8_t end_tag = 'E';

inline constexpr std::size_t checksum_bytes = 4;
inline constexpr std::size_t tick_head_bytes = 1 + 2 + 2;
inline constexpr std::size_t input_bytes = 6;         // of the first player
inline constexpr std::size_t second_input_bytes = 2;  // of the second, in a run of two
inline constexpr std::size_t second_pointer_bytes = 4;
inline constexpr std::size_t part_bytes = 1 + 2 + 4;
inline constexpr std::size_t combined_bytes = 8;
inline constexpr std::size_t end_bytes = 1 + 4 + checksum_bytes;

/// The number of bytes of a tick's record after its head.
constexpr std::size_t tick_body_bytes(std::size_t parts, int players, bool has_second_pointer) {
  return input_bytes + (players == max_players ? second_input_bytes : 0) +
         (has_second_pointer ? second_pointer_bytes : 0) + parts * part_bytes + combined_bytes + checksum_bytes;
}

/// Continues `crc`, the CRC-32 of the bytes so far (0 at the start), with `bytes`. CRC-32 as in zlib and PNG:
/// reflected, polynomial 0xEDB88320. It detects every change within 32 consecutive bits.
constexpr std::uint32_t crc32(std::uint32_t crc, std::span<const std::uint8_t> bytes) {
  constexpr auto remainders = [] {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t i = 0; i < table.size(); ++i) {
      std::uint32_t entry = i;
      for (int bit = 0; bit < 8; ++bit) entry = (entry >> 1) ^ ((entry & 1U) != 0U ? 0xEDB8'8320U : 0U);
      table[i] = entry;
    }
    return table;
  }();
  crc = ~crc;
  for (const std::uint8_t byte : bytes) crc = (crc >> 8) ^ remainders[(crc ^ byte) & 0xFFU];
  return ~crc;
}

}  // namespace engine::replay_format
