#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "ribbon/vec2.h"

namespace fuzz {

/// What a fuzzer's input is made into: a sequence of small decisions and of numbers, most of them where they are
/// accepted. At the end of the input everything is 0.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : left_(data, size) {}

  bool empty() const { return left_.empty(); }
  std::uint8_t byte();
  bool yes() { return (byte() & 1U) != 0; }
  /// 0 … n − 1.
  int below(int n) { return byte() % n; }
  /// Mostly low … high, at times just outside, −1, 0, or the greatest and least there are.
  int whole(int low, int high);
  /// Mostly low … high, geometrically if both are above 0, and often one of the two; at times `hostile`.
  double number(double low, double high);
  /// Not a number, infinite, huge, tiny, negative, or any eight bytes.
  double hostile();
  ribbon::Vec2 vector(double low, double high);

 private:
  std::span<const std::uint8_t> left_;
};

}  // namespace fuzz
