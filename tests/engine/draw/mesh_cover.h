#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/draw/canvas_mesh.h"
#include "engine/draw/canvas_raster.h"
#include "ribbon/vec2.h"

namespace engine {

using ribbon::Vec2;

inline double triangle_area(Vec2 a, Vec2 b, Vec2 c) { return 0.5 * cross(b - a, c - a); }

template <typename Use>
void each_triangle(const Mesh& mesh, Use use) {
  const auto vertex = [&](std::size_t i) { return mesh.vertices.at(static_cast<std::size_t>(mesh.indices[i])); };
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) use(vertex(i), vertex(i + 1), vertex(i + 2));
}

/// Returns the cover of the mesh at a point: the largest of all shapes over it.
inline double cover_at(const Mesh& mesh, Vec2 p) {
  double most = 0.0;
  for (const MeshBar& bar : mesh.bars) {
    const Vec2 piece = bar.to - bar.from;
    const double along = dot(p - bar.from, piece) / dot(piece, piece);
    if (along < 0.0 || along > 1.0) continue;
    most = std::max(most, bar.profile.at(std::abs(cross(piece, p - bar.from)) / length(piece)));
  }
  for (const MeshRing& ring : mesh.rings)
    most = std::max(most, ring.profile.at(std::abs(length(p - ring.center) - ring.radius)));
  each_triangle(mesh, [&](const MeshVertex& a, const MeshVertex& b, const MeshVertex& c) {
    const double whole = triangle_area(a.at, b.at, c.at);
    const double wa = triangle_area(p, b.at, c.at) / whole;
    const double wb = triangle_area(a.at, p, c.at) / whole;
    const double wc = 1.0 - wa - wb;
    if (std::min({wa, wb, wc}) < -1e-9) return;
    most = std::max(most, wa * a.cover + wb * b.cover + wc * c.cover);
  });
  return most;
}

/// Returns the covered area of the mesh in pixels, with fractions.
inline double covered_pixels(const Mesh& mesh, int width, int height) {
  Raster raster(width, height);
  raster.fill(mesh, 0xff, 255);
  double sum = 0.0;
  for (const std::uint32_t pixel : raster.pixels()) sum += (pixel & 0xffU) / 255.0;
  return sum;
}

inline void expect_sound(const Mesh& mesh) {
  EXPECT_FALSE(mesh.is_empty());
  EXPECT_TRUE(is_paintable(mesh));
  each_triangle(mesh, [](const MeshVertex& a, const MeshVertex& b, const MeshVertex& c) {
    EXPECT_TRUE(is_finite(a.at) && is_finite(b.at) && is_finite(c.at));
    EXPECT_GT(std::abs(triangle_area(a.at, b.at, c.at)), 0.0);
    for (const MeshVertex& v : {a, b, c}) EXPECT_TRUE(v.cover >= 0.0 && v.cover <= 1.0) << v.cover;
  });
}

}  // namespace engine
