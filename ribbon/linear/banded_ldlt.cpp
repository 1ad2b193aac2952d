#include "ribbon/linear/banded_ldlt.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>

#include "ribbon/linear/index.h"

namespace ribbon {
namespace {

constexpr int max_half_bandwidth = 2 * 64 + 3;  // of a cord of 64 rows

/// Factorises A = L·D·Lᵀ and eliminates b with it. Returns false for a pivot that is not positive and finite. A row
/// keeps 1/d and its part of Lᵀ.
///
/// The elimination is right-looking: it subtracts row k from the rows below it. So the order of the sums does not
/// depend on the compiler. FixedWidth > 0 gives the loops a constant length, which doubles their speed; 0 reads the
/// half bandwidth at run time.
template <int FixedWidth>
bool eliminate(BandedMatrix& a, double* b) {
  const int width = FixedWidth > 0 ? FixedWidth : a.half_bandwidth();
  const int n = a.size();
  using Row = std::array<double, at(FixedWidth > 0 ? FixedWidth : max_half_bandwidth) + 1>;
  for (int k = 0; k < n; ++k) {
    double* row = a.row(k);
    const double inverse_pivot = 1.0 / row[0];
    // An infinite pivot gives 0, a subnormal one infinity; comparisons with NaN are false.
    if (!(inverse_pivot > 0.0 && inverse_pivot < std::numeric_limits<double>::infinity())) return false;
    Row u;  // row of D·Lᵀ
    Row l;  // row of Lᵀ
    for (int j = 1; j <= width; ++j) u[at(j)] = row[j];
    for (int i = 1; i <= width; ++i) l[at(i)] = u[at(i)] * inverse_pivot;
#pragma GCC unroll 16
    for (int i = 1; i <= width; ++i) {
      double* below = row + i * width;  // entry (k + i, k + j) is below[j]
#pragma GCC unroll 16
      for (int j = i; j <= width; ++j) below[j] -= l[at(i)] * u[at(j)];
    }
    const auto subtract_from = [&, b_k = b[k]](int rows) {
      for (int i = 1; i <= rows; ++i) b[k + i] -= l[at(i)] * b_k;
    };
    k + width < n ? subtract_from(width) : subtract_from(n - 1 - k);
    for (int i = 1; i <= width; ++i) row[i] = l[at(i)];
    row[0] = inverse_pivot;
  }
  return true;
}

/// Overwrites b with the solution: x_k = b_k/d_k − Σ l_i·x_{k+i}, from the last row to the first.
template <int FixedWidth>
void substitute_back(const BandedMatrix& a, double* b) {
  const int width = FixedWidth > 0 ? FixedWidth : a.half_bandwidth();
  const int n = a.size();
  const auto solve_row = [&](int k, int rows) {
    const double* row = a.row(k);
    double x = b[k] * row[0];
    for (int i = rows; i >= 1; --i) x -= row[i] * b[k + i];
    b[k] = x;
  };
  int k = n - 1;
  for (; k >= 0 && k + width >= n; --k) solve_row(k, n - 1 - k);
  for (; k >= 0; --k) solve_row(k, width);
}

template <int FixedWidth>
bool factor_and_solve(BandedMatrix& a, double* b) {
  if (!eliminate<FixedWidth>(a, b)) return false;
  substitute_back<FixedWidth>(a, b);
  return true;
}

}  // namespace

void BandedMatrix::hold(int k) {
  std::fill(row(k), row(k) + half_bandwidth_ + 1, 0.0);
  for (int r = std::max(0, k - half_bandwidth_); r < k; ++r) row(r)[k - r] = 0.0;
  row(k)[0] = 1.0;
}

void BandedMatrix::set_scaled(const BandedMatrix& a, double factor) {
  assert(a.entries_.size() == entries_.size());
  std::transform(a.entries_.begin(), a.entries_.end(), entries_.begin(),
                 [factor](double entry) { return factor * entry; });
}

bool BandedLdlt::solve(BandedMatrix& a, std::span<double> b) {
  assert(static_cast<int>(b.size()) == a.size() && a.half_bandwidth() <= max_half_bandwidth);
  switch (a.half_bandwidth()) {  // 5 for a rope that bends, 2h + 3 for a ribbon of h rows
    case 5: return factor_and_solve<5>(a, b.data());
    case 7: return factor_and_solve<7>(a, b.data());
    case 9: return factor_and_solve<9>(a, b.data());
    case 11: return factor_and_solve<11>(a, b.data());
    case 13: return factor_and_solve<13>(a, b.data());
    default: return factor_and_solve<0>(a, b.data());
  }
}

}  // namespace ribbon
