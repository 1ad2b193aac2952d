#include "engine/draw/canvas_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "engine/draw/arcs.h"
#include "engine/draw/line_profile.h"
#include "engine/draw/mesh_limits.h"

namespace engine {
namespace {

using ribbon::Vec2;

bool drawable(double x) { return std::abs(x) <= max_coordinate; }  // false for NaN
bool drawable(Vec2 p) { return drawable(p.x) && drawable(p.y); }
bool drawable(std::span<const Vec2> points) {
  return std::all_of(points.begin(), points.end(), [](Vec2 p) { return drawable(p); });
}

bool is_valid(const Profile& profile) {
  return profile.core >= 0.0 && profile.outer > profile.core && drawable(profile.outer) && profile.cover >= 0.0 &&
         profile.cover <= 1.0;
}

Vec2 direction_of(double angle) { return {std::cos(angle), std::sin(angle)}; }

int add_vertex(Mesh& mesh, Vec2 at, double cover) {
  mesh.vertices.push_back({at, cover});
  return static_cast<int>(mesh.vertices.size()) - 1;
}

void add_triangle(Mesh& mesh, int a, int b, int c) {
  const auto at = [&](int i) { return mesh.vertices[static_cast<std::size_t>(i)].at; };
  if (std::abs(cross(at(b) - at(a), at(c) - at(a))) < min_double_area) return;
  mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

void add_quad(Mesh& mesh, int a, int b, int c, int d) {
  add_triangle(mesh, a, b, c);
  add_triangle(mesh, a, c, d);
}

/// Returns the points without those that coincide with the one before. Copies them only if there are such points: most
/// lines have none, and a frame draws hundreds of lines.
std::span<const Vec2> distinct(std::span<const Vec2> points, std::vector<Vec2>& copy) {
  const auto is_same = [](Vec2 a, Vec2 b) { return !(length(b - a) > merge_distance); };
  if (std::adjacent_find(points.begin(), points.end(), is_same) == points.end()) return points;
  copy.reserve(points.size());
  for (const Vec2 p : points)
    if (copy.empty() || !is_same(copy.back(), p)) copy.push_back(p);
  return copy;
}

double signed_area(std::span<const Vec2> corners) {
  double twice = 0.0;
  for (std::size_t i = 2; i < corners.size(); ++i) twice += cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
  return twice / 2.0;
}

double perimeter(std::span<const Vec2> corners) {
  double sum = length(corners.front() - corners.back());
  for (std::size_t i = 1; i < corners.size(); ++i) sum += length(corners[i] - corners[i - 1]);
  return sum;
}

/// Returns the displacement of a corner when both its edges move outwards by 1, bounded for very sharp corners.
Vec2 mitre(Vec2 before, Vec2 at, Vec2 after, double orientation) {
  const Vec2 in = (-orientation / length(at - before)) * perp(at - before);
  const Vec2 out = (-orientation / length(after - at)) * perp(after - at);
  return (1.0 / std::max(1.0 + dot(in, out), 0.25)) * (in + out);
}

using IndexPair = std::pair<int, int>;

/// Returns the edges that belong to one triangle only.
std::vector<IndexPair> boundary(std::span<const int> indices) {
  std::vector<IndexPair> edges;
  edges.reserve(indices.size());
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
    for (const auto& [a, b] : {IndexPair{indices[i], indices[i + 1]}, IndexPair{indices[i + 1], indices[i + 2]},
                               IndexPair{indices[i + 2], indices[i]}})
      edges.emplace_back(std::min(a, b), std::max(a, b));
  std::sort(edges.begin(), edges.end());
  std::vector<IndexPair> single;
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t next = i + 1;
    while (next < edges.size() && edges[next] == edges[i]) ++next;
    if (next == i + 1) single.push_back(edges[i]);
    i = next;
  }
  return single;
}

}  // namespace

bool is_paintable(const Mesh& mesh) {
  const auto known = [&](int i) { return i >= 0 && static_cast<std::size_t>(i) < mesh.vertices.size(); };
  const auto valid = [](const MeshVertex& v) { return drawable(v.at) && v.cover >= 0.0 && v.cover <= 1.0; };
  const auto is_bar = [](const MeshBar& bar) {
    return drawable(bar.from) && drawable(bar.to) && !(bar.from == bar.to) && is_valid(bar.profile);
  };
  const auto is_ring = [](const MeshRing& ring) {
    return drawable(ring.center) && drawable(ring.radius) && ring.radius >= 0.0 && is_valid(ring.profile);
  };
  return std::all_of(mesh.indices.begin(), mesh.indices.end(), known) &&
         std::all_of(mesh.vertices.begin(), mesh.vertices.end(), valid) &&
         std::all_of(mesh.bars.begin(), mesh.bars.end(), is_bar) &&
         std::all_of(mesh.rings.begin(), mesh.rings.end(), is_ring);
}

void add_disc(Mesh& mesh, Vec2 center, double radius) {
  if (!drawable(center) || !drawable(radius) || radius <= 0.0) return;
  mesh.rings.push_back({center, 0.0, disc_profile(radius)});
}

void add_ring(Mesh& mesh, Vec2 center, double radius, double width) {
  if (!drawable(center) || !drawable(radius) || !drawable(width) || radius <= 0.0 || width <= 0.0) return;
  const Profile profile = line_profile(width);
  if (profile.outer >= radius) return add_disc(mesh, center, radius + width / 2.0);
  mesh.rings.push_back({center, radius, profile});
}

/// A point near the line is nearest either to the inside of a piece, and so in its bar, or to a joint or an end, and so
/// in the disc around it, which has the cover of the line at this distance.
void add_polyline(Mesh& mesh, std::span<const Vec2> points, double width) {
  if (!drawable(points) || !drawable(width) || width <= 0.0) return;
  std::vector<Vec2> copy;
  const std::span<const Vec2> p = distinct(points, copy);
  if (p.size() < 2) return;
  const Profile profile = line_profile(width);
  for (std::size_t i = 1; i < p.size(); ++i) mesh.bars.push_back({p[i - 1], p[i], profile});
  for (const Vec2 joint : p) mesh.rings.push_back({joint, 0.0, profile});
}

void add_convex(Mesh& mesh, std::span<const Vec2> corners) {
  if (!drawable(corners)) return;
  std::vector<Vec2> copy;
  std::span<const Vec2> p = distinct(corners, copy);
  while (p.size() > 1 && length(p.front() - p.back()) <= merge_distance) p = p.first(p.size() - 1);
  const double area = signed_area(p);
  if (p.size() < 3 || std::abs(area) < min_double_area) return;
  // area / perimeter is at most the radius of the inscribed circle, so the core cannot invert; for a sliver it is half
  // the width.
  const double inset = std::min(0.5, std::abs(area) / perimeter(p));
  const Profile profile = line_profile(2.0 * inset);
  const int first = static_cast<int>(mesh.vertices.size());
  const int count = static_cast<int>(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec2 outwards =
        mitre(p[(i + p.size() - 1) % p.size()], p[i], p[(i + 1) % p.size()], std::copysign(1.0, area));
    add_vertex(mesh, p[i] - inset * outwards, profile.cover);
    add_vertex(mesh, p[i] + (profile.outer - inset) * outwards, 0.0);
  }
  for (int i = 0; i < count; ++i) {
    const int core = first + 2 * i;
    const int next = first + 2 * ((i + 1) % count);
    add_triangle(mesh, first, core, next);
    add_quad(mesh, core, core + 1, next + 1, next);
  }
}

void add_triangles(Mesh& mesh, std::span<const Vec2> vertices, std::span<const int> indices) {
  const auto known = [&](int i) { return i >= 0 && static_cast<std::size_t>(i) < vertices.size(); };
  if (!drawable(vertices) || !std::all_of(indices.begin(), indices.end(), known)) return;
  const int first = static_cast<int>(mesh.vertices.size());
  for (const Vec2 v : vertices) add_vertex(mesh, v, 1.0);
  const std::size_t before = mesh.indices.size();
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
    add_triangle(mesh, first + indices[i], first + indices[i + 1], first + indices[i + 2]);

  constexpr Profile rim{0.0, 1.0, 1.0};
  for (const auto& [a, b] :
       boundary(std::vector<int>(mesh.indices.begin() + static_cast<std::ptrdiff_t>(before), mesh.indices.end()))) {
    const Vec2 from = mesh.vertices[static_cast<std::size_t>(a)].at;
    const Vec2 to = mesh.vertices[static_cast<std::size_t>(b)].at;
    if (length(to - from) <= merge_distance) continue;
    mesh.bars.push_back({from, to, rim});
    mesh.rings.push_back({from, 0.0, rim});
    mesh.rings.push_back({to, 0.0, rim});
  }
}

void add_rounded_rectangle(Mesh& mesh, Vec2 corner, Vec2 size, double corner_radius) {
  if (!drawable(corner) || !drawable(size) || !drawable(corner_radius) || size.x <= 0.0 || size.y <= 0.0) return;
  const double r = std::clamp(corner_radius, 0.0, std::min(size.x, size.y) / 2.0);
  constexpr double quarter = std::numbers::pi / 2.0;
  const std::array<Vec2, 4> middles{{{corner.x + size.x - r, corner.y + size.y - r},
                                     {corner.x + r, corner.y + size.y - r},
                                     {corner.x + r, corner.y + r},
                                     {corner.x + size.x - r, corner.y + r}}};
  const int steps = r > 0.0 ? arc_steps(r, quarter) : 0;
  std::vector<Vec2> outline;
  outline.reserve(middles.size() * static_cast<std::size_t>(steps + 1));
  for (std::size_t i = 0; i < middles.size(); ++i)
    for (int k = 0; k <= steps; ++k)
      outline.push_back(middles[i] + r * direction_of(quarter * (static_cast<double>(i) +
                                                                 static_cast<double>(k) / std::max(steps, 1))));
  add_convex(mesh, outline);
}

}  // namespace engine
