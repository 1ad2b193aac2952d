#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "ribbon/box2d/coupled_cord.h"
#include "ribbon/cut.h"

namespace ribbon::box2d {

/// Ropes whose memory the pieces of ropes get that are cut.
class SpareCords {
 public:
  /// Makes spare cords until there are `cords` of them with `points` points or more.
  void reserve(std::size_t cords, int points);
  /// Cuts a cord of the direct solver. The pieces of a rope get the memory of two spare cords, if there are two.
  CutPieces cut(const Cord& cord, const CutPlace& where);
  /// Returns a cord of the coupling of one of these pieces, with the filter and the user data of the uncut cord.
  std::unique_ptr<CoupledCord> complete(Cord piece, const CoupledCord& whole);

 private:
  struct Spare {
    std::unique_ptr<CoupledCord> cord;  // without its part for the direct solver, once that is memory of a piece
    std::shared_ptr<CordDef> def;       // of the cord, which sees it as constant
    int points = 0;
  };
  std::vector<Spare> spares_;
  std::vector<Spare> begun_;  // of the pieces of the last cut
};

}  // namespace ribbon::box2d
