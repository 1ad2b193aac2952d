#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace ribbon {

/// A symmetric n × n matrix with entries only within `half_bandwidth` of the diagonal. Row r holds its diagonal
/// entry and those to the right of it: row(r)[k] is the entry (r, r + k), 0 ≤ k ≤ half_bandwidth.
class BandedMatrix {
 public:
  /// Of zeros. n ≥ 1, half_bandwidth ≥ 0.
  BandedMatrix(int n, int half_bandwidth)
      : n_(n),
        half_bandwidth_(half_bandwidth),
        // As many zero rows as the band is wide follow the last one, so that elimination needs no bounds.
        entries_((static_cast<std::size_t>(n) + static_cast<std::size_t>(half_bandwidth)) *
                 (static_cast<std::size_t>(half_bandwidth) + 1)) {}

  int size() const { return n_; }  ///< n, rows and columns
  /// How far from the diagonal entries may be.
  int half_bandwidth() const { return half_bandwidth_; }
  /// From a row to the next.
  int stride() const { return half_bandwidth_ + 1; }
  /// The entries (r, r), (r, r + 1), …, half_bandwidth + 1 of them; 0 ≤ r < n. What lies past column n is 0.
  double* row(int r) { return entries_.data() + offset(r); }
  /// The same to read.
  const double* row(int r) const { return entries_.data() + offset(r); }
  /// The entry (r, c); c within the band on either side.
  double at(int r, int c) const { return r <= c ? row(r)[c - r] : row(c)[r - c]; }
  /// Makes the row and column k those of the identity.
  void hold(int k);
  /// Becomes factor times a matrix of the same size.
  void set_scaled(const BandedMatrix& a, double factor);
  /// Makes all entries 0.
  void set_zero() { std::fill(entries_.begin(), entries_.end(), 0.0); }

 private:
  std::size_t offset(int r) const { return static_cast<std::size_t>(r) * static_cast<std::size_t>(stride()); }

  int n_;
  int half_bandwidth_;
  std::vector<double> entries_;
};

/// Solves A·x = b for a symmetric positive definite A.
class LinearSolver {
 public:
  LinearSolver() = default;
  LinearSolver(const LinearSolver&) = delete;
  LinearSolver& operator=(const LinearSolver&) = delete;
  virtual ~LinearSolver() = default;

  /// Overwrites b with x; A may be overwritten too. False if A is not positive definite in double precision or an
  /// entry is not finite; b is then undefined.
  virtual bool solve(BandedMatrix& a, std::span<double> b) = 0;
};

/// A = L·D·Lᵀ within the band, without pivoting, in O(n · half_bandwidth²) and without heap.
class BandedLdlt final : public LinearSolver {
 public:
  bool solve(BandedMatrix& a, std::span<double> b) override;
};

}  // namespace ribbon
