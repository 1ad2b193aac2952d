#pragma once

#include <cstddef>
#include <string>

namespace study {

/// A part of a list of items. The outputs of all shards, one behind the other, are that of the whole list: each has
/// consecutive items, and only the first one has a header.
struct Shard {
  std::size_t number = 1;  ///< 1 … count
  std::size_t count = 1;

  /// Returns whether the item with this index, of so many, is in it. Shards differ by at most one item.
  bool has(std::size_t item, std::size_t items) const {
    return item >= items * (number - 1) / count && item < items * number / count;
  }
  bool is_first() const { return number == 1; }
  bool is_whole() const { return count == 1; }
};

/// Parses 2/8. Throws std::invalid_argument, with what is accepted, for anything else.
Shard shard_of(const std::string& text);

}  // namespace study
