#include "engine/draw/textured_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "engine/draw/line_profile.h"

namespace engine {
namespace {

using ribbon::Vec2;

constexpr double farthest = 1e12;       // px
constexpr double farthest_uv = 1e6;     // beyond, a texel is lost in the rasteriser's fixed-point numbers
constexpr double same_place = 0.01;     // px
constexpr double mitred_turn = 0.2;     // rad; a corner sharper than this is made round outside
constexpr double roundness = 0.05;      // px; how far a chord may stay behind its arc
constexpr double smallest_area = 1e-9;  // px²

bool within(double x, double most) { return std::abs(x) <= most; }  // false for NaN
bool within(Vec2 p, double most) { return within(p.x, most) && within(p.y, most); }

void add_triangle(TexturedMesh& mesh, int a, int b, int c) {
  const auto at = [&](int i) { return mesh.vertices[static_cast<std::size_t>(i)].at; };
  if (std::abs(cross(at(b) - at(a), at(c) - at(a))) < smallest_area) return;
  mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

/// Puts one cross-section after the other, and the quads between each and the one before.
class Band {
 public:
  Band(TexturedMesh& mesh, const BandLook& look) : mesh_(mesh), look_(look), profile_(line_profile(look.width)) {}

  const Profile& profile() const { return profile_; }

  /// `upper` and `lower` are where the band's edges lie, seen from `at` and in half widths.
  struct Section {
    Vec2 at;
    double way;  // px, along the line
    Vec2 upper;
    Vec2 lower;
    Color color;
    double cover = 1.0;
  };
  void add(const Section& section) {
    const int first = static_cast<int>(mesh_.vertices.size());
    const double u = look_.u_start + section.way * look_.u_per_pixel;
    const std::array<double, 4> offsets = {-profile_.outer, -profile_.core, profile_.core, profile_.outer};
    for (std::size_t k = 0; k < offsets.size(); ++k) {
      const Vec2 side = offsets[k] < 0.0 || k < 2 ? section.upper : section.lower;
      const double cover = k == 0 || k == 3 ? 0.0 : profile_.cover * section.cover;
      mesh_.vertices.push_back({section.at + std::abs(offsets[k]) * side,
                                {u, 0.5 + offsets[k] / std::max(look_.width, 1.0)},
                                section.color,
                                std::min(cover, 1.0)});
    }
    if (begun_) {
      for (int k = first; k < first + 3; ++k) {
        add_triangle(mesh_, k - 4, k, k + 1);
        add_triangle(mesh_, k - 4, k + 1, k - 3);
      }
    }
    begun_ = true;
  }

 private:
  TexturedMesh& mesh_;
  const BandLook& look_;
  Profile profile_;
  bool begun_ = false;
};

Vec2 turned(Vec2 v, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}

struct Corner {
  Vec2 in;  // the line's direction before it and after it, length 1
  Vec2 out;
  double shorter;  // px, of the two pieces that meet
};

void add_corner(Band& band, Band::Section section, const Corner& corner) {
  const double turn = std::atan2(cross(corner.in, corner.out), dot(corner.in, corner.out));
  const Vec2 before = perp(corner.in);
  const Vec2 after = perp(corner.out);
  const double fold = 1.0 + dot(before, after);
  const Vec2 mitre = (1.0 / std::max(fold, 1e-3)) * (before + after);
  if (std::abs(turn) < mitred_turn) {
    section.lower = mitre;
    section.upper = -mitre;
    band.add(section);
    return;
  }
  // Inside the bend both pieces end in the point where their edges cross, if they reach that far.
  const bool meets = band.profile().outer * std::tan(0.5 * std::abs(turn)) <= corner.shorter;
  const double step = 2.0 * std::acos(1.0 - std::min(roundness / band.profile().outer, 0.5));
  const int steps = static_cast<int>(std::clamp(std::ceil(std::abs(turn) / step), 1.0, 64.0));
  for (int k = 0; k <= steps; ++k) {
    const Vec2 normal = turned(before, turn * k / steps);
    section.lower = meets && turn > 0.0 ? mitre : normal;
    section.upper = meets && turn < 0.0 ? -mitre : -normal;
    band.add(section);
  }
}

}  // namespace

bool is_paintable(const TexturedMesh& mesh) {
  const auto known = [&](int i) { return i >= 0 && static_cast<std::size_t>(i) < mesh.vertices.size(); };
  const auto sound = [](const TexturedVertex& v) {
    return within(v.at, farthest) && within(v.uv, farthest_uv) && v.cover >= 0.0 && v.cover <= 1.0;
  };
  return std::all_of(mesh.indices.begin(), mesh.indices.end(), known) &&
         std::all_of(mesh.vertices.begin(), mesh.vertices.end(), sound);
}

void add_shape(TexturedMesh& mesh, const Mesh& shape, const UvMap& map, Color color) {
  const int first = static_cast<int>(mesh.vertices.size());
  for (const MeshVertex& v : shape.vertices) {
    const Vec2 from = v.at - map.origin;
    mesh.vertices.push_back({v.at, {dot(from, map.u_axis), dot(from, map.v_axis)}, color, v.cover});
  }
  for (const int i : shape.indices) mesh.indices.push_back(first + i);
}

void add_band(TexturedMesh& mesh, std::span<const Vec2> points, const BandLook& look) {
  const auto drawable = [](Vec2 p) { return within(p, farthest); };
  if (!std::all_of(points.begin(), points.end(), drawable) || !within(look.width, farthest) || look.width <= 0.0)
    return;
  if (!look.colors.empty() && look.colors.size() != points.size()) return;
  std::vector<std::size_t> kept;
  kept.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    if (kept.empty() || length(points[i] - points[kept.back()]) > same_place) kept.push_back(i);
  if (kept.size() < 2) return;

  Band band(mesh, look);
  const auto place = [&](std::size_t k) { return points[kept[k]]; };
  const auto color = [&](std::size_t k) { return look.colors.empty() ? look.color : look.colors[kept[k]]; };
  const auto direction = [&](std::size_t k) {
    const Vec2 way = place(k + 1) - place(k);
    return (1.0 / length(way)) * way;
  };
  const auto add_end = [&](std::size_t k, Vec2 along, double way, bool first) {
    const double step = std::min(0.5, 0.4 * length(place(first ? 1 : k) - place(first ? 0 : k - 1)));
    for (const double side : {-step, step}) {
      band.add({place(k) + side * along, way + side, -perp(along), perp(along), color(k),
                (side < 0.0) == first ? 0.0 : 1.0});
    }
  };
  double way = 0.0;
  add_end(0, direction(0), way, true);
  for (std::size_t k = 1; k + 1 < kept.size(); ++k) {
    const double before = length(place(k) - place(k - 1));
    way += before;
    add_corner(band, {place(k), way, {}, {}, color(k)},
               {direction(k - 1), direction(k), std::min(before, length(place(k + 1) - place(k)))});
  }
  const std::size_t last = kept.size() - 1;
  way += length(place(last) - place(last - 1));
  add_end(last, direction(last - 1), way, false);
}

}  // namespace engine
