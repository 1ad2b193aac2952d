#include "ribbon/thesis/broad_phase.h"

#include <algorithm>
#include <numeric>

#include "ribbon/linear/index.h"

namespace ribbon {
namespace {

constexpr double skin_in_spacings = 0.5;          // less: more builds; more: longer lists
constexpr std::size_t triangles_per_circle = 48;  // mean capacity; a circle beyond it tests all triangles

bool within(Vec2 a, Vec2 b, double distance) { return dot(a - b, a - b) <= distance * distance; }

bool all_within(std::span<const Vec2> current, std::span<const Vec2> old, double distance) {
  return std::equal(current.begin(), current.end(), old.begin(), old.end(),
                    [distance](Vec2 a, Vec2 b) { return within(a, b, distance); });
}

}  // namespace

BroadPhase::BroadPhase(const Mesh& mesh, bool circles_are_points)
    : mesh_(&mesh),
      circles_are_points_(circles_are_points),
      skin_(skin_in_spacings * mesh.spacing),
      tree_(static_cast<int>(mesh.triangles.size())),
      boxes_(mesh.triangles.size()),
      built_positions_(at(mesh.size())),
      all_(mesh.triangles.size()) {
  std::iota(all_.begin(), all_.end(), 0);
}

/// The capacity depends only on the number of circles. So a restored cord falls back to all triangles where the
/// original cord does.
std::size_t BroadPhase::capacity_for(std::size_t circles) const {
  return circles * std::min(triangles_per_circle, all_.size());
}

void BroadPhase::reserve(std::size_t circles) {
  built_centers_.reserve(circles);
  list_start_.reserve(circles + 1);
  list_.reserve(capacity_for(circles));
}

void BroadPhase::update(std::span<const Vec2> positions, std::span<const Vec2> centers, std::span<const double> radii) {
  if (stale_ || moved_too_far(positions, centers)) build(positions, centers, radii);
}

bool BroadPhase::moved_too_far(std::span<const Vec2> positions, std::span<const Vec2> centers) const {
  const double half = 0.5 * skin_;
  if (!all_within(positions, built_positions_, half)) return true;
  return !circles_are_points_ && !all_within(centers, built_centers_, half);
}

void BroadPhase::build(std::span<const Vec2> positions, std::span<const Vec2> centers, std::span<const double> radii) {
  for (std::size_t t = 0; t < boxes_.size(); ++t) {
    const Triangle& triangle = mesh_->triangles[t];
    const Vec2 a = positions[at(triangle.a)];
    const Vec2 b = positions[at(triangle.b)];
    const Vec2 c = positions[at(triangle.c)];
    boxes_[t] = {{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y})},
                 {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y})}};
  }
  tree_.build(boxes_);
  capacity_ = capacity_for(centers.size());
  list_.clear();
  list_start_.assign(1, 0);
  for (std::size_t k = 0; k < centers.size(); ++k) {
    if (!list_near(k, centers[k], radii[k])) break;
    list_start_.push_back(list_.size());
  }
  built_positions_.assign(positions.begin(), positions.end());
  built_centers_.assign(centers.begin(), centers.end());
  stale_ = false;
  ++builds_;
}

/// Appends the list of circle k. Returns false if the capacity is too small for it.
bool BroadPhase::list_near(std::size_t k, Vec2 center, double radius) {
  const Vec2 corner{radius + skin_, radius + skin_};
  bool complete = true;
  tree_.query({center - corner, center + corner}, [&](int triangle) {
    if (is_own(k, triangle)) return;
    if (list_.size() < capacity_) {
      list_.push_back(triangle);
    } else {
      complete = false;
    }
  });
  // The order of the tree depends on the positions of its nodes; ascending order does not.
  std::sort(list_.begin() + static_cast<std::ptrdiff_t>(list_start_.back()), list_.end());
  return complete;
}

std::span<const int> BroadPhase::near(std::size_t k) const {
  if (k + 1 >= list_start_.size()) return all_;
  return std::span(list_).subspan(list_start_[k], list_start_[k + 1] - list_start_[k]);
}

bool BroadPhase::is_own(std::size_t k, int triangle) const {
  if (!circles_are_points_) return false;
  const int point = static_cast<int>(k);
  const int cells_across = mesh_->h - 1;
  const int from_column = mesh_->column(point) - (triangle / 2) / cells_across;
  const int from_row = mesh_->row(point) - (triangle / 2) % cells_across;
  return (from_column == 0 || from_column == 1) && (from_row == 0 || from_row == 1);
}

}  // namespace ribbon
