// Most mutations of a replay fail at its checksums. This mutator mostly rewrites the checksums, so that the code behind
// them is tested too. Only fuzzers need it: the inputs that they find are whole files.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "engine/replay/replay_format.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace {

namespace format = engine::replay_format;

/// Rewrites the checksums of all records that a reader would find.
class Sealer {
 public:
  explicit Sealer(std::span<std::uint8_t> file) : file_(file) {}

  void seal() {
    if (!skip_line()) return;
    const std::size_t header = at_;
    if (!skip_line()) return;
    const auto line = file_.subspan(header, at_ - header);
    constexpr std::string_view two = "\"players\":2";
    players_ = std::search(line.begin(), line.end(), two.begin(), two.end()) == line.end() ? 1 : 2;
    if (!close_record()) return;
    while (close_tick()) {
    }
    if (at_ + format::end_bytes <= file_.size() && file_[at_] == format::end_tag) {
      at_ += format::end_bytes - format::checksum_bytes;
      close_record();
    }
  }

 private:
  bool skip_line() {
    const auto end = std::find(file_.begin() + static_cast<std::ptrdiff_t>(at_), file_.end(), '\n');
    if (end == file_.end()) return false;
    at_ = static_cast<std::size_t>(end - file_.begin()) + 1;
    return true;
  }

  bool close_tick() {
    if (at_ + format::tick_head_bytes > file_.size() || file_[at_] != format::tick_tag) return false;
    const std::size_t flagged = file_[at_ + 1] + std::size_t{256} * file_[at_ + 2];
    const bool has_pointer = players_ == 2 && (flagged & format::second_pointer_flag) != 0;
    const std::size_t parts = has_pointer ? flagged - format::second_pointer_flag : flagged;
    for (const std::size_t k : {1U, 2U}) file_[at_ + 2 + k] = static_cast<std::uint8_t>(~file_[at_ + k]);
    at_ += format::tick_head_bytes + format::tick_body_bytes(parts, players_, has_pointer) - format::checksum_bytes;
    return close_record();
  }

  bool close_record() {
    if (at_ + format::checksum_bytes > file_.size()) return false;
    crc_ = format::crc32(crc_, file_.subspan(start_, at_ - start_));
    for (std::size_t k = 0; k < format::checksum_bytes; ++k) {
      file_[at_ + k] = static_cast<std::uint8_t>(crc_ >> (8 * k) & 0xFFU);
    }
    at_ += format::checksum_bytes;
    start_ = at_;
    return true;
  }

  std::span<std::uint8_t> file_;
  std::size_t at_ = 0;
  std::size_t start_ = 0;  // of the record
  int players_ = 1;
  std::uint32_t crc_ = 0;
};

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed) {
  const std::size_t mutated = LLVMFuzzerMutate(data, size, max_size);
  if (seed % 8 != 0) Sealer({data, mutated}).seal();
  return mutated;
}
