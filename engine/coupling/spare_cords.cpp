#include "ribbon/box2d/spare_cords.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace ribbon::box2d {

void SpareCords::reserve(std::size_t cords, int points) {
  const auto has_fewer = [points](const Spare& spare) { return spare.points < points; };
  spares_.erase(std::remove_if(spares_.begin(), spares_.end(), has_fewer), spares_.end());
  spares_.reserve(cords);
  begun_.reserve(2);
  while (spares_.size() < cords) {
    Spare spare;
    spare.points = points;
    spare.cord = std::make_unique<CoupledCord>(memory_for_piece(points), b2Filter{});
    spare.cord->reserve();
    spare.def = std::make_shared<CordDef>(spare.cord->direct().def());
    spare.def->positions.reserve(static_cast<std::size_t>(points));
    spare.cord->def = spare.def;
    spares_.push_back(std::move(spare));
  }
}

CutPieces SpareCords::cut(const Cord& cord, const CutPlace& where) {
  begun_.clear();
  const bool is_chain = cord.def().rows == 1 && cord.def().bending_stiffness == 0.0;
  if (!is_chain || spares_.size() < 2) return ribbon::cut(cord, where);
  const auto first = std::prev(spares_.end(), 2);
  begun_.assign(std::make_move_iterator(first), std::make_move_iterator(spares_.end()));
  spares_.erase(first, spares_.end());
  return ribbon::cut(cord, where, {std::move(begun_[0].cord->direct()), std::move(begun_[1].cord->direct())});
}

std::unique_ptr<CoupledCord> SpareCords::complete(Cord piece, const CoupledCord& whole) {
  std::unique_ptr<CoupledCord> made;
  if (begun_.empty()) {
    made = std::make_unique<CoupledCord>(std::move(piece), whole.filter);
  } else {
    Spare spare = std::move(begun_.back());
    begun_.pop_back();
    *spare.def = piece.def();
    made = std::move(spare.cord);
    made->cord = std::move(piece);
    made->filter = whole.filter;
  }
  made->user_data = whole.user_data;
  return made;
}

}  // namespace ribbon::box2d
