#include "ribbon/thesis/tangle.h"

#include <algorithm>
#include <array>

#include "ribbon/linear/index.h"

namespace ribbon {
namespace {

constexpr int tangled_columns = 2;  // on each side of a crossing; with fewer the next point catches on it

bool cross_each_other(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const bool c_left = cross(b - a, c - a) > 0.0;
  const bool d_left = cross(b - a, d - a) > 0.0;
  const bool a_left = cross(d - c, a - c) > 0.0;
  const bool b_left = cross(d - c, b - c) > 0.0;
  return c_left != d_left && a_left != b_left;
}

bool crosses_an_edge(Vec2 a, Vec2 b, const std::array<Vec2, 3>& corners) {
  return cross_each_other(a, b, corners[0], corners[1]) || cross_each_other(a, b, corners[1], corners[2]) ||
         cross_each_other(a, b, corners[2], corners[0]);
}

void mark(std::span<char> tangled, int column) {
  const int first = std::max(column - tangled_columns, 0);
  const int last = std::min(column + tangled_columns, static_cast<int>(tangled.size()) - 1);
  for (int c = first; c <= last; ++c) tangled[at(c)] = 1;
}

}  // namespace

int find_tangled_columns(const Mesh& mesh, std::span<const Vec2> positions, const BroadPhase& broad_phase,
                         std::span<char> tangled) {
  std::fill(tangled.begin(), tangled.end(), 0);
  for (int p = 0; p < mesh.size(); ++p) {
    for (const int t : broad_phase.near(at(p))) {
      const Triangle& triangle = mesh.triangles[at(t)];
      const std::array<Vec2, 3> corners = {positions[at(triangle.a)], positions[at(triangle.b)],
                                           positions[at(triangle.c)]};
      for (const int q : {p - mesh.h, p + mesh.h}) {  // neighbours of p along the cord
        if (q < 0 || q >= mesh.size() || broad_phase.is_own(at(p), t) || broad_phase.is_own(at(q), t)) continue;
        if (!crosses_an_edge(positions[at(p)], positions[at(q)], corners)) continue;
        mark(tangled, mesh.column(p));
        mark(tangled, mesh.column(triangle.a));  // its own circles may not list a triangle of p's edge
      }
    }
  }
  return static_cast<int>(std::count(tangled.begin(), tangled.end(), 1));
}

}  // namespace ribbon
