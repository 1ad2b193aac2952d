#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "ribbon/vec2.h"

namespace fuzz {

/// Decodes a fuzzer's input as a sequence of small decisions and of numbers, most of them in the accepted range. Behind
/// the end of the input everything is 0.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : left_(data, size) {}

  bool empty() const { return left_.empty(); }
  std::uint8_t byte();
  bool boolean() { return (byte() & 1U) != 0; }
  /// Returns an integer in 0 … n − 1.
  int below(int n) { return byte() % n; }
  /// Returns mostly an integer in low … high; sometimes one just outside, −1, 0, or the least or greatest int.
  int integer(int low, int high);
  /// Returns mostly a number in low … high, log-uniform if both are above 0, often an end; sometimes `hostile`.
  double number(double low, double high);
  /// Returns NaN, an infinite, huge, tiny or negative number, or any eight bytes.
  double hostile();
  ribbon::Vec2 vector(double low, double high);

 private:
  std::span<const std::uint8_t> left_;
};

}  // namespace fuzz
