#include "ribbon/thesis/mesh.h"

#include <cassert>
#include <cmath>

#include "ribbon/linear/index.h"

namespace ribbon {
namespace {

std::vector<Connection> connect(const Mesh& mesh) {
  std::vector<Connection> connections;
  const double diagonal = std::sqrt(2.0) * mesh.spacing;
  for (int i = 0; i < mesh.w; ++i) {
    for (int j = 0; j < mesh.h; ++j) {
      const int p = mesh.index(i, j);
      const bool above = j + 1 < mesh.h;
      const bool below = j > 0;
      const bool next = i + 1 < mesh.w;
      if (above) connections.push_back({p, mesh.index(i, j + 1), mesh.spacing});
      if (next && below) connections.push_back({p, mesh.index(i + 1, j - 1), diagonal});
      if (next) connections.push_back({p, mesh.index(i + 1, j), mesh.spacing});
      if (next && above) connections.push_back({p, mesh.index(i + 1, j + 1), diagonal});
    }
  }
  return connections;
}

std::vector<Triangle> tile(const Mesh& mesh) {
  std::vector<Triangle> triangles;
  const double area = 0.5 * mesh.spacing * mesh.spacing;
  for (int i = 0; i + 1 < mesh.w; ++i) {
    for (int j = 0; j + 1 < mesh.h; ++j) {
      const int a = mesh.index(i, j);
      const int b = mesh.index(i + 1, j);
      const int c = mesh.index(i + 1, j + 1);
      const int d = mesh.index(i, j + 1);
      triangles.push_back({a, b, c, area});
      triangles.push_back({a, c, d, area});
    }
  }
  return triangles;
}

std::vector<int> outline(const Mesh& mesh) {
  std::vector<int> loop;
  for (int i = 0; i < mesh.w; ++i) loop.push_back(mesh.index(i, 0));
  for (int j = 1; j < mesh.h; ++j) loop.push_back(mesh.index(mesh.w - 1, j));
  for (int i = mesh.w - 2; i >= 0; --i) loop.push_back(mesh.index(i, mesh.h - 1));
  for (int j = mesh.h - 2; j >= 1; --j) loop.push_back(mesh.index(0, j));
  return loop;
}

}  // namespace

Mesh make_mesh(int w, int h, double spacing) {
  assert(w >= 2 && h >= 2 && spacing > 0.0);
  Mesh mesh{w, h, spacing, {}, {}, {}};
  mesh.connections = connect(mesh);
  mesh.triangles = tile(mesh);
  mesh.boundary = outline(mesh);
  return mesh;
}

std::vector<Vec2> lay_along(std::span<const Vec2> path, int w, int h, double spacing) {
  assert(path.size() >= 2);
  std::vector<Vec2> positions;
  positions.reserve(at(w) * at(h));
  std::size_t segment = 0;
  double segment_start = 0.0;  // arc length at path[segment]
  for (int i = 0; i < w; ++i) {
    const double s = i * spacing;
    double segment_length = length(path[segment + 1] - path[segment]);
    while (segment + 2 < path.size() && s > segment_start + segment_length) {
      segment_start += segment_length;
      ++segment;
      segment_length = length(path[segment + 1] - path[segment]);
    }
    assert(segment_length > 0.0);
    const Vec2 along = (1.0 / segment_length) * (path[segment + 1] - path[segment]);
    const Vec2 middle = path[segment] + (s - segment_start) * along;
    for (int j = 0; j < h; ++j) positions.push_back(middle + ((j - 0.5 * (h - 1)) * spacing) * perp(along));
  }
  return positions;
}

}  // namespace ribbon
