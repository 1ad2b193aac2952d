#include "game/simulation/burning.h"

#include <algorithm>
#include <cmath>

#include "game/simulation/index.h"
#include "game/simulation/level_cords.h"

namespace game {
namespace {

using ribbon::Vec2;
using ribbon::box2d::CordId;
using ribbon::box2d::CutEvent;

constexpr std::int64_t full = 1'000'000'000'000;  // the heat at which a place burns through
constexpr int min_columns = 4;                    // of a piece that still burns

}  // namespace

void Burning::burn(const std::vector<Fire>& fires, engine::Scene& scene) {
  if (fires.empty()) return;
  follow_cuts(scene);
  const auto ids = scene.coupling().cords();
  const CordId last = ids.empty() ? -1 : ids.back();
  for (CordId id = 0; id <= last; ++id) {
    if (scene.coupling().cord(id).is_valid() && is_burnable(scene.coupling().cord(id))) heat_cord(fires, scene, id);
  }
}

/// Pieces keep the heat of their cord. The events are those of calls before the last tick and of links that broke in
/// it.
void Burning::follow_cuts(const engine::Scene& scene) {
  for (const CutEvent& event : scene.coupling().last_step().cut_events()) {
    if (event.cord >= static_cast<CordId>(cords_.size()) || cords_[at(event.cord)].columns.empty()) continue;
    const Cord whole = std::move(cords_[at(event.cord)]);
    cords_[at(event.cord)] = {};
    const int column = event.row > 0 ? 0 : static_cast<int>(std::floor(event.arc / whole.link + 0.5));
    if (event.first) inherit(scene, *event.first, whole, 0);
    if (event.second) inherit(scene, *event.second, whole, column);
  }
}

/// A piece that was cut again at once has more columns here than it had, which its own cut takes off.
void Burning::inherit(const engine::Scene& scene, CordId piece, const Cord& whole, int first_column) {
  if (piece >= static_cast<CordId>(cords_.size())) cords_.resize(at(piece) + 1);
  const auto from = whole.columns.begin() + std::min<std::ptrdiff_t>(first_column, std::ssize(whole.columns));
  cords_[at(piece)] = {whole.link, {from, whole.columns.end()}};
  const ribbon::box2d::CordView view = scene.coupling().cord(piece);
  if (view.is_valid()) cords_[at(piece)].columns.resize(at(view.shape().columns));
}

Burning::Cord& Burning::of(const engine::Scene& scene, CordId id) {
  if (id >= static_cast<CordId>(cords_.size())) cords_.resize(at(id) + 1);
  Cord& cord = cords_[at(id)];
  const ribbon::box2d::CordView view = scene.coupling().cord(id);
  const ribbon::box2d::CordShape shape = view.shape();
  if (cord.columns.empty()) {
    cord.link = view.arc(shape.rows);
    cord.columns.resize(at(shape.columns));
  }
  return cord;
}

void Burning::heat_cord(const std::vector<Fire>& fires, engine::Scene& scene, CordId id) {
  const ribbon::box2d::CordShape shape = scene.coupling().cord(id).shape();
  if (shape.columns < min_columns) return;
  const auto positions = scene.coupling().cord(id).positions();
  std::vector<Place>& columns = of(scene, id).columns;
  int hottest = 0;
  for (int i = 0; i < shape.columns; ++i) {
    Place& place = columns[at(i)];
    std::int64_t gain = -full / cooling_ticks;
    for (const Fire& fire : fires) {
      if (fire.area.contains(positions[middle_point(shape, i)])) gain = std::max(gain, (full - 1) / fire.ticks + 1);
    }
    place.heat = std::clamp<std::int64_t>(place.heat + gain, 0, full);
    place.most = std::max(place.most, place.heat);
    if (place.heat > columns[at(hottest)].heat) hottest = i;
  }
  if (columns[at(hottest)].heat < full) return;
  for (Place& place : columns) place.heat = 0;  // the pieces burn anew
  cut_at_column(scene.coupling(), id, std::clamp(hottest, 1, shape.columns - 2));
}

const Burning::Place* Burning::find(CordId cord, int column) const {
  if (cord < 0 || at(cord) >= cords_.size() || column < 0 || at(column) >= cords_[at(cord)].columns.size())
    return nullptr;
  return &cords_[at(cord)].columns[at(column)];
}

double Burning::heat(CordId cord, int column) const {
  const Place* const place = find(cord, column);
  return place == nullptr ? 0.0 : static_cast<double>(place->heat) / static_cast<double>(full);
}

double Burning::char_of(CordId cord, int column) const {
  const Place* const place = find(cord, column);
  return place == nullptr ? 0.0 : static_cast<double>(place->most) / static_cast<double>(full);
}

void Burning::add_to(ribbon::box2d::Hasher& hasher) const {
  for (const Cord& cord : cords_) {
    for (const Place& place : cord.columns) {
      hasher.add(place.heat);
      hasher.add(place.most);
    }
  }
}

}  // namespace game
