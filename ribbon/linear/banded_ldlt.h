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
  /// Creates a zero matrix. Requires n ≥ 1 and half_bandwidth ≥ 0.
  BandedMatrix(int n, int half_bandwidth)
      : n_(n),
        half_bandwidth_(half_bandwidth),
        // As many zero rows as the band is wide follow the last one, so that elimination needs no bounds.
        entries_((static_cast<std::size_t>(n) + static_cast<std::size_t>(half_bandwidth)) *
                 (static_cast<std::size_t>(half_bandwidth) + 1)) {}

  int size() const { return n_; }  ///< number n of rows and of columns
  /// Returns the half bandwidth.
  int half_bandwidth() const { return half_bandwidth_; }
  /// Returns the distance between rows in memory.
  int stride() const { return half_bandwidth_ + 1; }
  /// Returns the half_bandwidth + 1 entries (r, r), (r, r + 1), … of row r, 0 ≤ r < n. Entries beyond column n are 0.
  double* row(int r) { return entries_.data() + offset(r); }
  /// Returns the same entries, for reading.
  const double* row(int r) const { return entries_.data() + offset(r); }
  /// Returns entry (r, c), which must be within the band on either side.
  double at(int r, int c) const { return r <= c ? row(r)[c - r] : row(c)[r - c]; }
  /// Replaces row and column k by those of the identity.
  void hold(int k);
  /// Assigns `factor` times a matrix of the same size.
  void set_scaled(const BandedMatrix& a, double factor);
  /// Sets all entries to 0.
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

  /// Overwrites b with x; it may overwrite A too. Returns false if A is not positive definite in double precision or
  /// has an entry that is not finite; b is then undefined.
  virtual bool solve(BandedMatrix& a, std::span<double> b) = 0;
};

/// Factorises A = L·D·Lᵀ within the band without pivoting, in O(n · half_bandwidth²). Allocates no memory.
class BandedLdlt final : public LinearSolver {
 public:
  bool solve(BandedMatrix& a, std::span<double> b) override;
};

}  // namespace ribbon
