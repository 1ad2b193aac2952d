#pragma once

#include <cstddef>
#include <span>

#include "ribbon/vec2.h"

namespace ribbon {

/// A row of a cord as a polyline through its points. Column k of the row is its vertex k.
class CordLine {
 public:
  /// `positions` [m] are those of all points of a cord with so many rows, which must outlive the line. The row is 0 …
  /// rows − 1. There must be two columns or more.
  CordLine(std::span<const Vec2> positions, int rows, int row) : x_(positions), rows_(rows), row_(row) {}

  /// Returns the number of rows of the cord.
  int rows() const { return rows_; }
  /// Returns the number of links: columns less one.
  int links() const { return static_cast<int>(x_.size()) / rows_ - 1; }
  /// Returns the position of a column, m.
  Vec2 at(int column) const {
    const int point = column * rows_ + row_;
    return x_[static_cast<std::size_t>(point)];
  }
  /// Returns the position at a share of a link, 0 … 1; m.
  Vec2 place(int link, double along) const { return at(link) + along * (at(link + 1) - at(link)); }
  /// Returns the length of a link as it is, m.
  double length_of(int link) const { return length(at(link + 1) - at(link)); }
  /// Returns the direction of a link; zero if it has no length.
  Vec2 tangent(int link) const;
  /// Returns the column of the place that is nearest to a position, 0 … links(). It is looked for downhill from a link,
  /// so of two that are as near it is the one on this side.
  double nearest_column(int link, Vec2 position) const;

 private:
  double nearest(int link, Vec2 position) const;

  std::span<const Vec2> x_;
  int rows_;
  int row_;
};

}  // namespace ribbon
