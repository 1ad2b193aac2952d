#include "tests/support/exact_chain.h"

namespace test_support {
namespace {

using ribbon::Vec2;

constexpr int n = heavy::links;
constexpr double link = heavy::length / n;

/// The points 1 … n of the chain; point 0 is the pin.
struct ChainState {
  std::vector<Vec2> x, v;
};

double inverse_mass(int point) {
  if (point == 0) return 0.0;
  const double share = heavy::rope_mass / n;
  return 1.0 / (point == n ? heavy::load_mass + 0.5 * share : share);
}

ChainState moved(const ChainState& s, double h, const ChainState& rate) {
  ChainState out = s;
  for (std::size_t p = 0; p < s.x.size(); ++p) {
    out.x[p] += h * rate.x[p];
    out.v[p] += h * rate.v[p];
  }
  return out;
}

/// Link e = (p, p + 1) of vector d keeps its length: d·(a_{p+1} − a_p) + |v_{p+1} − v_p|² = 0, with
/// m_p a_p = m_p g + τ_p d_p − τ_{p−1} d_{p−1}. That is tridiagonal in the tensions a metre, τ.
ChainState rate(const ChainState& s) {
  constexpr auto size = static_cast<std::size_t>(n);
  std::vector<double> diagonal(size), upper(size), tau(size);
  std::vector<Vec2> d(size);
  for (int e = 0; e < n; ++e) {
    const auto k = static_cast<std::size_t>(e);
    d[k] = s.x[k + 1] - s.x[k];
    const Vec2 dv = s.v[k + 1] - s.v[k];
    const double fall = e == 0 ? dot(d[k], Vec2{0.0, -heavy::gravity}) : 0.0;  // the pin does not
    diagonal[k] = (inverse_mass(e) + inverse_mass(e + 1)) * dot(d[k], d[k]);
    tau[k] = dot(dv, dv) + fall;
    if (e == 0) continue;
    const double coupling = -inverse_mass(e) * dot(d[k - 1], d[k]);
    const double factor = coupling / diagonal[k - 1];
    upper[k - 1] = coupling;
    diagonal[k] -= factor * coupling;
    tau[k] -= factor * tau[k - 1];
  }
  for (std::size_t k = size; k-- > 0;) {
    if (k + 1 < size) tau[k] -= upper[k] * tau[k + 1];
    tau[k] /= diagonal[k];
  }
  ChainState out{s.v, std::vector<Vec2>(s.v.size())};
  for (std::size_t p = 1; p <= size; ++p) {
    const Vec2 pull = (p < size ? tau[p] * d[p] : Vec2{}) - tau[p - 1] * d[p - 1];
    out.v[p] = Vec2{0.0, -heavy::gravity} + inverse_mass(static_cast<int>(p)) * pull;
  }
  return out;
}

void runge_kutta(ChainState& s, double h) {
  const ChainState k1 = rate(s);
  const ChainState k2 = rate(moved(s, 0.5 * h, k1));
  const ChainState k3 = rate(moved(s, 0.5 * h, k2));
  const ChainState k4 = rate(moved(s, h, k3));
  s = moved(moved(moved(moved(s, h / 6.0, k1), h / 3.0, k2), h / 3.0, k3), h / 6.0, k4);
}

}  // namespace

std::vector<Vec2> exact_heavy_load(int substeps) {
  ChainState s;
  for (int p = 0; p <= n; ++p) s.x.push_back({p * link, 0.0});
  s.v.resize(s.x.size());
  std::vector<Vec2> path;
  for (int tick = 0; tick < heavy::ticks; ++tick) {
    for (int k = 0; k < substeps; ++k) runge_kutta(s, heavy::tick / substeps);
    path.push_back(s.x.back());
  }
  return path;
}

}  // namespace test_support
