#include "game/simulation/blades.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "game/simulation/level_cords.h"
#include "game/simulation/sweep.h"
#include "ribbon/box.h"
#include "ribbon/box2d/convert.h"

namespace game {
namespace {

using ribbon::Vec2;
using ribbon::box2d::CordId;
using ribbon::box2d::to_double;

/// Position and rotation of a body.
struct Frame {
  Vec2 at;
  Vec2 along{1.0, 0.0};

  Vec2 to_world(Vec2 local) const { return at + local.x * along + local.y * perp(along); }
  Vec2 to_local(Vec2 world) const { return {dot(world - at, along), dot(world - at, perp(along))}; }
};

Frame frame_of(const Blade& blade, const engine::Scene& scene) {
  for (const engine::SceneBody& made : scene.bodies()) {
    if (blade.body == 0 || made.object != blade.body) continue;
    const b2Transform& pose = made.body->GetTransform();
    return {to_double(pose.p), {static_cast<double>(pose.q.c), static_cast<double>(pose.q.s)}};
  }
  return {};
}

int nearest_column(double place) { return static_cast<int>(std::floor(place + 0.5)); }

ribbon::Box box_of(std::span<const Vec2> points, std::span<const Vec2> others) {
  ribbon::Box box{points.front(), points.front()};
  for (const std::span<const Vec2> each : {points, others}) {
    for (const Vec2 p : each) {
      box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
      box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
    }
  }
  return box;
}

}  // namespace

void Blades::start(const std::vector<Blade>& blades, const engine::Scene& scene) {
  *this = {};
  for (const Blade& blade : blades) {
    const Frame frame = frame_of(blade, scene);
    Points& local = local_.emplace_back();
    for (const Vec2 p : blade.edge) local.push_back(frame.to_local(p));
    edges_.push_back(blade.edge);
  }
  before_ = edges_;
  if (!blades.empty()) store(scene);
}

void Blades::move(const std::vector<Blade>& blades, const engine::Scene& scene) {
  std::swap(before_, edges_);
  for (std::size_t k = 0; k < blades.size(); ++k) {
    const Frame frame = frame_of(blades[k], scene);
    for (std::size_t p = 0; p < local_[k].size(); ++p) edges_[k][p] = frame.to_world(local_[k][p]);
  }
}

void Blades::cut(const std::vector<Blade>& blades, engine::Scene& scene) {
  if (blades.empty()) return;
  move(blades, scene);
  for (Piece& piece : pieces_) --piece.ticks_left;
  std::erase_if(pieces_, [](const Piece& piece) { return piece.ticks_left <= 0; });
  const auto ids = scene.coupling().cords();
  // A cut replaces the cord by its pieces, which have higher ids: those that there are now are tested.
  const CordId last = ids.empty() ? -1 : ids.back();
  for (CordId id = 0; id <= last; ++id) {
    if (!scene.coupling().cord(id).is_valid() || !is_cuttable(scene.coupling().cord(id)) || rests(id)) continue;
    find_cuts(scene, id);
    if (!columns_.empty()) cut_at_columns(scene, id);
  }
  store(scene);
}

bool Blades::rests(CordId cord) const {
  return std::any_of(pieces_.begin(), pieces_.end(), [cord](const Piece& piece) { return piece.cord == cord; });
}

/// Finds the columns nearest to the places where the cord crosses an edge now, or crossed it in the tick.
void Blades::find_cuts(const engine::Scene& scene, CordId id) {
  columns_.clear();
  const ribbon::box2d::CordShape shape = scene.coupling().cord(id).shape();
  const auto now = scene.coupling().cord(id).positions();
  const auto index = static_cast<std::size_t>(id);
  const bool is_new = index >= cords_.size() || cords_[index].size() != now.size();
  const std::span<const Vec2> old = is_new ? now : std::span<const Vec2>(cords_[index]);
  const ribbon::Box box = box_of(now, old);
  for (std::size_t k = 0; k < edges_.size(); ++k) {
    if (!overlap(box, box_of(edges_[k], before_[k]))) continue;
    for (std::size_t e = 0; e + 1 < edges_[k].size(); ++e) {
      const Segment edge{edges_[k][e], edges_[k][e + 1]};
      const Segment edge_before{before_[k][e], before_[k][e + 1]};
      bool crosses = false;
      std::optional<Meeting> first;  // along a link that is parallel to the edge there are many
      for (int i = 0; i + 1 < shape.columns; ++i) {
        const std::size_t a = middle_point(shape, i);
        const std::size_t b = middle_point(shape, i + 1);
        if (const auto place = crossing({now[a], now[b]}, edge)) {
          columns_.push_back(nearest_column(i + *place));
          crosses = true;
        } else if (const auto met = swept_crossing({old[a], old[b]}, {now[a], now[b]}, edge_before, edge);
                   met && (!first || met->time < first->time)) {
          first = Meeting{met->time, i + met->place};
        }
      }
      if (first && !crosses) columns_.push_back(nearest_column(first->place));
    }
  }
  std::erase_if(columns_, [&shape](int column) { return column < 1 || column > shape.columns - 2; });
  std::sort(columns_.begin(), columns_.end(), std::greater<>());
  columns_.erase(std::unique(columns_.begin(), columns_.end()), columns_.end());
}

/// Cuts from the last column to the first one, so that the first piece keeps its columns.
void Blades::cut_at_columns(engine::Scene& scene, CordId cord) {
  CordId left = cord;
  for (const int column : columns_) {
    if (column > scene.coupling().cord(left).shape().columns - 2) continue;
    const ribbon::box2d::CutEvent event = cut_at_column(scene.coupling(), left, column);
    if (event.second) pieces_.push_back({*event.second, rest_ticks});
    if (!event.first) return;
    left = *event.first;
  }
  pieces_.push_back({left, rest_ticks});
}

void Blades::store(const engine::Scene& scene) {
  const auto ids = scene.coupling().cords();
  cords_.resize(ids.empty() ? 0 : static_cast<std::size_t>(ids.back()) + 1);
  for (Points& cord : cords_) cord.clear();
  for (const CordId id : ids) {
    const auto positions = scene.coupling().cord(id).positions();
    cords_[static_cast<std::size_t>(id)].assign(positions.begin(), positions.end());
  }
}

void Blades::forget(CordId cord) {
  if (cord < static_cast<CordId>(cords_.size())) cords_[static_cast<std::size_t>(cord)].clear();
}

/// The places of edges and cords follow from the rest of the state.
void Blades::add_to(ribbon::box2d::Hasher& hasher) const {
  for (const Piece& piece : pieces_) {
    hasher.add(piece.cord);
    hasher.add(piece.ticks_left);
  }
}

}  // namespace game
