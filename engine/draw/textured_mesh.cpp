#include "engine/draw/textured_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "engine/draw/arcs.h"
#include "engine/draw/line_profile.h"
#include "engine/draw/mesh_limits.h"
#include "engine/draw/straight.h"

namespace engine {
namespace {

using ribbon::Vec2;

constexpr double max_uv = 1e6;          // above it the fixed-point numbers of the rasteriser do not resolve a texel
constexpr double max_mitre_turn = 0.2;  // rad; sharper corners are round outside

bool within(double x, double limit) { return std::abs(x) <= limit; }  // false for NaN
bool within(Vec2 p, double limit) { return within(p.x, limit) && within(p.y, limit); }

void add_triangle(TexturedMesh& mesh, int a, int b, int c) {
  const auto at = [&](int i) { return mesh.vertices[static_cast<std::size_t>(i)].at; };
  if (std::abs(cross(at(b) - at(a), at(c) - at(a))) < min_double_area) return;
  mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

/// Adds cross-sections of a band and the quads between successive ones.
class Band {
 public:
  Band(TexturedMesh& mesh, const BandLook& look) : mesh_(mesh), look_(look), profile_(line_profile(look.width)) {}

  const Profile& profile() const { return profile_; }

  /// `upper` and `lower`: the offsets of the edges of the band from `at`, in half widths.
  struct Section {
    Vec2 at;
    double distance;  // px, along the line
    Vec2 upper;
    Vec2 lower;
    Color color;
    double cover = 1.0;
  };
  void add(const Section& section) {
    const int first = static_cast<int>(mesh_.vertices.size());
    const double u = look_.u_start + section.distance * look_.u_per_pixel;
    const std::array<double, 4> offsets = {-profile_.outer, -profile_.core, profile_.core, profile_.outer};
    for (std::size_t k = 0; k < offsets.size(); ++k) {
      const Vec2 side = offsets[k] < 0.0 || k < 2 ? section.upper : section.lower;
      const double cover = k == 0 || k == 3 ? 0.0 : profile_.cover * section.cover;
      mesh_.vertices.push_back({section.at + std::abs(offsets[k]) * side,
                                {u, 0.5 + offsets[k] / std::max(look_.width, 1.0)},
                                section.color,
                                std::min(cover, 1.0)});
    }
    if (has_previous_) {
      for (int k = first; k < first + 3; ++k) {
        add_triangle(mesh_, k - 4, k, k + 1);
        add_triangle(mesh_, k - 4, k + 1, k - 3);
      }
    }
    has_previous_ = true;
  }

 private:
  TexturedMesh& mesh_;
  const BandLook& look_;
  Profile profile_;
  bool has_previous_ = false;
};

Vec2 turned(Vec2 v, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}

struct Corner {
  Vec2 in;  // the unit directions of the line before and after it
  Vec2 out;
  double min_length;  // px, of the two pieces that meet
};

void add_corner(Band& band, Band::Section section, const Corner& corner) {
  const double turn = std::atan2(cross(corner.in, corner.out), dot(corner.in, corner.out));
  const Vec2 before = perp(corner.in);
  const Vec2 after = perp(corner.out);
  const double fold = 1.0 + dot(before, after);
  const Vec2 mitre = (1.0 / std::max(fold, 1e-3)) * (before + after);
  if (std::abs(turn) < max_mitre_turn) {
    section.lower = mitre;
    section.upper = -mitre;
    band.add(section);
    return;
  }
  // Inside the bend both pieces end at the intersection of their edges, if they are long enough.
  const bool meets = band.profile().outer * std::tan(0.5 * std::abs(turn)) <= corner.min_length;
  const int steps = std::min(arc_steps(band.profile().outer, turn), 64);
  for (int k = 0; k <= steps; ++k) {
    const Vec2 normal = turned(before, turn * k / steps);
    section.lower = meets && turn > 0.0 ? mitre : normal;
    section.upper = meets && turn < 0.0 ? -mitre : -normal;
    band.add(section);
  }
}

/// The points of a line at which it bends, by index, with their colours. A line with colours of its own keeps all
/// distinct points.
class BandLine {
 public:
  BandLine(std::span<const Vec2> points, const BandLook& look) : points_(points), look_(look) {
    distinct_.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      if (distinct_.empty() || length(points[i] - points[distinct_.back()]) > merge_distance) distinct_.push_back(i);
    if (look.colors.empty() && distinct_.size() > 2) straighten();
  }

  std::size_t size() const { return distinct_.size(); }
  Vec2 point(std::size_t k) const { return points_[distinct_[k]]; }
  Color color(std::size_t k) const { return look_.colors.empty() ? look_.color : look_.colors[distinct_[k]]; }
  /// The unit direction of piece k, from point k to point k + 1.
  Vec2 direction(std::size_t k) const {
    const Vec2 piece = point(k + 1) - point(k);
    return (1.0 / length(piece)) * piece;
  }

 private:
  /// Removes points that are within straight_within px of the line without them.
  void straighten() {
    std::size_t kept = 0;
    Straight piece(point(0));
    for (std::size_t k = 1; k + 1 < distinct_.size(); ++k) {
      piece.pass(point(k));
      if (piece.reaches(point(k + 1))) continue;
      distinct_[++kept] = distinct_[k];
      piece = Straight(point(kept));
    }
    distinct_[++kept] = distinct_.back();
    distinct_.resize(kept + 1);
  }

  std::span<const Vec2> points_;
  const BandLook& look_;
  std::vector<std::size_t> distinct_;
};

/// Adds the straight cut at the first or last point, with a border one pixel wide.
void add_end(Band& band, const BandLine& line, std::size_t k, Vec2 along, double distance, bool first) {
  const double step = std::min(0.5, 0.4 * length(line.point(first ? 1 : k) - line.point(first ? 0 : k - 1)));
  for (const double side : {-step, step}) {
    band.add({line.point(k) + side * along, distance + side, -perp(along), perp(along), line.color(k),
              (side < 0.0) == first ? 0.0 : 1.0});
  }
}

}  // namespace

bool is_paintable(const TexturedMesh& mesh) {
  const auto known = [&](int i) { return i >= 0 && static_cast<std::size_t>(i) < mesh.vertices.size(); };
  const auto valid = [](const TexturedVertex& v) {
    return within(v.at, max_coordinate) && within(v.uv, max_uv) && v.cover >= 0.0 && v.cover <= 1.0;
  };
  return std::all_of(mesh.indices.begin(), mesh.indices.end(), known) &&
         std::all_of(mesh.vertices.begin(), mesh.vertices.end(), valid);
}

void add_shape(TexturedMesh& mesh, const Mesh& shape, const UvMap& map, Color color) {
  const int first = static_cast<int>(mesh.vertices.size());
  for (const MeshVertex& v : shape.vertices) {
    const Vec2 from = v.at - map.origin;
    mesh.vertices.push_back({v.at, {dot(from, map.u_axis), dot(from, map.v_axis)}, color, v.cover});
  }
  for (const int i : shape.indices) mesh.indices.push_back(first + i);
}

void add_rectangle(TexturedMesh& mesh, Vec2 top_left, Vec2 size, Color top, Color bottom, Vec2 uv_end) {
  const auto first = static_cast<int>(mesh.vertices.size());
  mesh.vertices.push_back({top_left, {0.0, 0.0}, top});
  mesh.vertices.push_back({top_left + Vec2{size.x, 0.0}, {uv_end.x, 0.0}, top});
  mesh.vertices.push_back({top_left + size, uv_end, bottom});
  mesh.vertices.push_back({top_left + Vec2{0.0, size.y}, {0.0, uv_end.y}, bottom});
  for (const int corner : {0, 1, 2, 0, 2, 3}) mesh.indices.push_back(first + corner);
}

void add_disc(TexturedMesh& mesh, Vec2 center, double radius, const UvMap& map, Color color) {
  if (!within(center, max_coordinate) || !within(radius, max_coordinate) || radius <= 0.0) return;
  const Profile profile = disc_profile(radius);
  const int steps = arc_steps(profile.outer, 2.0 * std::numbers::pi);
  const double step = 2.0 * std::numbers::pi / steps;
  const double grow = chord_compensation(step);
  const auto add_vertex = [&](Vec2 at, double cover) {
    const Vec2 from = at - map.origin;
    mesh.vertices.push_back({at, {dot(from, map.u_axis), dot(from, map.v_axis)}, color, cover});
    return static_cast<int>(mesh.vertices.size()) - 1;
  };
  const int middle = add_vertex(center, profile.cover);
  for (int k = 0; k <= steps; ++k) {
    const Vec2 out = grow * turned({1.0, 0.0}, k * step);
    const int core = add_vertex(center + profile.core * out, profile.cover);
    const int outer = add_vertex(center + profile.outer * out, 0.0);
    if (k == 0) continue;
    add_triangle(mesh, middle, core - 2, core);
    add_triangle(mesh, core - 2, outer - 2, outer);
    add_triangle(mesh, core - 2, outer, core);
  }
}

void add_band(TexturedMesh& mesh, std::span<const Vec2> points, const BandLook& look) {
  const auto drawable = [](Vec2 p) { return within(p, max_coordinate); };
  if (!std::all_of(points.begin(), points.end(), drawable) || !within(look.width, max_coordinate) || look.width <= 0.0)
    return;
  if (!look.colors.empty() && look.colors.size() != points.size()) return;
  const BandLine line(points, look);
  if (line.size() < 2) return;

  Band band(mesh, look);
  double distance = 0.0;
  add_end(band, line, 0, line.direction(0), distance, true);
  for (std::size_t k = 1; k + 1 < line.size(); ++k) {
    const double before = length(line.point(k) - line.point(k - 1));
    distance += before;
    add_corner(band, {line.point(k), distance, {}, {}, line.color(k)},
               {line.direction(k - 1), line.direction(k), std::min(before, length(line.point(k + 1) - line.point(k)))});
  }
  const std::size_t last = line.size() - 1;
  distance += length(line.point(last) - line.point(last - 1));
  add_end(band, line, last, line.direction(last - 1), distance, false);
}

}  // namespace engine
