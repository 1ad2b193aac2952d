#include "ribbon/elastic/cells.h"

#include <algorithm>
#include <cmath>

#include "ribbon/elastic/link.h"

namespace ribbon {
namespace {

constexpr double least_spread = 1e-6;    // |z| below which its direction means nothing
constexpr double crushed_spread = 0.05;  // |z| below which the geometric stiffness grows no further
constexpr double squashed_share = 0.2;   // α: of the rest area, below which a corner resists
constexpr double unlocked_share = 0.9;   // of the rest area, that all corners need before a cell counts as turned back
constexpr double unlock_bending = 10.0;  // hourglass stiffness of an unlocked cell, in E
constexpr std::ptrdiff_t unlock_reach = 3;  // columns on either side whose mean direction an unlocked cell is given

/// The direction of z, or where it has none that of the cell before.
Vec2 direction_of(Vec2 z, Vec2 before) {
  const double size = length(z);
  return size > least_spread ? (1.0 / size) * z : before;
}

}  // namespace

Cells::Cells(const CordDef& def, double modulus, double row_bending)
    : columns_(static_cast<std::size_t>(def.points) - 1),
      rows_(static_cast<std::size_t>(def.rows) - 1),
      height_(def.width / (def.rows - 1)),
      modulus_(modulus),
      poisson_ratio_(def.poisson_ratio),
      row_bending_(row_bending),
      damping_(def.damping),
      area_stiffness_(def.area_stiffness * modulus),
      shapes_(columns_) {
  if (area_stiffness_ > 0.0) {
    unlocked_.resize(columns_ * rows_);
    toward_.resize(columns_);
  }
}

void Cells::set_rest_lengths(std::span<const double> lengths) {
  for (std::size_t i = 0; i < columns_; ++i) {
    shapes_[i] = make_cell(lengths[i], height_, modulus_, poisson_ratio_, row_bending_);
  }
}

void Cells::find_tensions(std::span<const Vec2> x, std::span<double> tensions) const {
  for (std::size_t i = 0; i < columns_; ++i) {
    for (std::size_t j = 0; j < rows_; ++j) {
      tensions[i * rows_ + j] = shapes_[i].stretch * (length(modes(shapes_[i], corners(x, i, j)).z) - 2.0);
    }
  }
}

void Cells::add_damping(const Motion& at, double sign, std::span<double> tensions) const {
  Vec2 d{1.0, 0.0};
  for (std::size_t i = 0; i < columns_; ++i) {
    for (std::size_t j = 0; j < rows_; ++j) {
      d = direction_of(modes(shapes_[i], corners(at.x, i, j)).z, d);
      const double rate = dot(d, modes(shapes_[i], corners(at.v, i, j)).z);
      tensions[i * rows_ + j] += sign * damping_ * rate * shapes_[i].stretch;
    }
  }
}

void Cells::add_turning(const Stage& stage, std::span<const Vec2> x, std::span<double> tensions) const {
  Vec2 d{1.0, 0.0};
  for (std::size_t i = 0; i < columns_; ++i) {
    for (std::size_t j = 0; j < rows_; ++j) {
      d = direction_of(modes(shapes_[i], corners(x, i, j)).z, d);
      if (is_unlocked(i * rows_ + j)) continue;
      tensions[i * rows_ + j] += shapes_[i].stretch * turning(stage, i, j, d);
    }
  }
}

/// β times the turning rate of z, which is a bar to it.
double Cells::turning(const Stage& stage, std::size_t column, std::size_t row, Vec2 d) const {
  if (damping_ == 0.0 || !stage.euler) return 0.0;
  const std::size_t p = point(column, row);
  const std::size_t q = point(column + 1, row);
  const Corners start = {stage.start(p), stage.start(p + 1), stage.start(q), stage.start(q + 1)};
  return damping_ * turning_rate(stage, modes(shapes_[column], start).z, d);
}

Corners Cells::corners(std::span<const Vec2> x, std::size_t column, std::size_t row) const {
  const std::size_t first = point(column, row);
  const std::size_t second = point(column + 1, row);
  return {x[first], x[first + 1], x[second], x[second + 1]};
}

double Cells::unlock_hourglass(const Cell& cell) const { return std::max(cell.hourglass, unlock_bending * modulus_); }

void Cells::add_constant(BandedMatrix& matrix) const {
  CellAssembler assembler(matrix);
  for (std::size_t i = 0; i < columns_; ++i) {
    for (std::size_t j = 0; j < rows_; ++j) {
      assembler.add_constant(shapes_[i], shapes_[i].hourglass, 1.0, static_cast<int>(point(i, j)),
                             static_cast<int>(point(i + 1, j)));
    }
  }
}

/// One geometric stiffness a column: in a ribbon that bends, cells of one side are pushed together as much as those of
/// the other are pulled, and each for itself would make the bent ribbon stiffer than it is.
double Cells::mean_tension(std::size_t column, std::span<const double> tensions) const {
  double sum = 0.0;
  for (std::size_t j = 0; j < rows_; ++j) sum += tensions[column * rows_ + j];
  return std::max(0.0, sum / static_cast<double>(rows_));
}

void Cells::load(const NewtonSystem& system, std::span<const double> tensions) {
  CellAssembler assembler(system.matrix);
  Vec2 d{1.0, 0.0};
  for (std::size_t i = 0; i < columns_; ++i) {
    const Cell& cell = shapes_[i];
    const double pull = mean_tension(i, tensions);
    for (std::size_t j = 0; j < rows_; ++j) {
      const Vec2 z = modes(cell, corners(system.x, i, j)).z;
      CellModes at = modes(cell, corners(system.damped, i, j));
      const std::size_t p = point(i, j);
      const std::size_t q = point(i + 1, j);
      const int first = static_cast<int>(p);
      const int second = static_cast<int>(q);
      d = direction_of(z, d);
      Corners push;
      if (is_unlocked(i * rows_ + j)) {
        Cell stiff = cell;
        stiff.hourglass = unlock_hourglass(cell);
        push = forces(stiff, at, cell.stretch * (at.z - 2.0 * toward_[i]));
        const double stretch = system.stiffening * cell.stretch;
        assembler.add_spread(cell, d, stretch, stretch, first, second);
        Cell extra = cell;
        extra.shear = 0.0;
        assembler.add_constant(extra, stiff.hourglass - cell.hourglass, system.stiffening, first, second);
      } else {
        push = forces(cell, at, (cell.stretch * (dot(d, at.z) - turning(system.stage, i, j, d) - 2.0)) * d);
        assembler.add_spread(cell, d, system.stiffening * cell.stretch, pull / std::max(length(z), crushed_spread),
                             first, second);
      }
      system.force[p] += push[0];
      system.force[p + 1] += push[1];
      system.force[q] += push[2];
      system.force[q + 1] += push[3];
      if (area_stiffness_ > 0.0) load_corner_areas(system, i, j);
    }
  }
}

/// With U and V the edges along and across at a corner, 2A_c = U × V: ∂/∂U = −perp(V), ∂/∂V = perp(U). The Hessian is
/// that of Gauss and Newton.
void Cells::load_corner_areas(const NewtonSystem& system, std::size_t column, std::size_t row) {
  const Corners x = corners(system.x, column, row);
  const double rest = shapes_[column].area;  // twice the triangle's
  const std::array<double, 4> doubled = doubled_corner_areas(x);
  const int low = static_cast<int>(point(column, row));
  const int high = static_cast<int>(point(column + 1, row));
  for (std::size_t c = 0; c < 4; ++c) {
    const double missing = squashed_share * rest - doubled[c];
    if (missing <= 0.0) continue;
    const int across = static_cast<int>(c % 2);
    const Vec2 half_along = -0.5 * perp(c < 2 ? x[1] - x[0] : x[3] - x[2]);
    const Vec2 half_across = 0.5 * perp(across == 0 ? x[2] - x[0] : x[3] - x[1]);
    const int side = c < 2 ? low : high;
    // U goes from low + across to high + across, V from side to side + 1.
    std::array<Vec2, 4> gradient{};
    const std::array<int, 4> points{low, low + 1, high, high + 1};
    gradient[static_cast<std::size_t>(across)] -= half_along;
    gradient[static_cast<std::size_t>(across) + 2] += half_along;
    gradient[side == low ? 0 : 2] -= half_across;
    gradient[side == low ? 1 : 3] += half_across;
    const double force = area_stiffness_ * missing / rest;
    const double stiffness = area_stiffness_ / (0.5 * rest);
    for (std::size_t k = 0; k < 4; ++k) {
      system.force[static_cast<std::size_t>(points[k])] += force * gradient[k];
      for (std::size_t l = k; l < 4; ++l) {
        system.add_outer(points[k], points[l], stiffness, gradient[k], gradient[l]);
      }
    }
  }
}

void Cells::update(const NewtonSystem& system, std::span<const double> /*tensions*/, std::span<const Vec2> direction,
                   std::span<double> next) const {
  Vec2 d{1.0, 0.0};
  for (std::size_t i = 0; i < columns_; ++i) {
    const Cell& cell = shapes_[i];
    for (std::size_t j = 0; j < rows_; ++j) {
      d = direction_of(modes(cell, corners(system.x, i, j)).z, d);
      const Vec2 moved = modes(cell, corners(direction, i, j)).z;
      const Vec2 z = modes(cell, corners(system.damped, i, j)).z;
      const double spread = dot(d, z) - turning(system.stage, i, j, d) - 2.0;
      next[i * rows_ + j] = cell.stretch * (spread + system.stiffening * dot(d, moved));
    }
  }
}

double Cells::corner_energy(const Cell& cell, const Corners& x) const {
  double sum = 0.0;
  for (const double doubled : doubled_corner_areas(x)) {
    const double missing = 0.5 * std::max(0.0, squashed_share * cell.area - doubled);
    sum += 0.5 * area_stiffness_ * missing * missing / (0.5 * cell.area);
  }
  return sum;
}

double Cells::potential(const Shape& shape, std::span<const double> most) const {
  double sum = 0.0;
  Vec2 d{1.0, 0.0};
  for (std::size_t i = 0; i < columns_; ++i) {
    for (std::size_t j = 0; j < rows_; ++j) {
      Cell cell = shapes_[i];
      const Corners x = corners(shape.x, i, j);
      const CellModes at = modes(cell, corners(shape.damped, i, j));
      d = direction_of(modes(cell, x).z, d);
      if (is_unlocked(i * rows_ + j)) {
        cell.hourglass = unlock_hourglass(cell);
        const Vec2 away = at.z - 2.0 * toward_[i];
        sum += 0.5 * cell.stretch * dot(away, away) / shape.stiffening;
      } else {
        const double spread = dot(d, at.z) - turning(shape.stage, i, j, d) - 2.0;
        const MixedBar bar{spread / shape.stiffening, 1.0 / (cell.stretch * shape.stiffening)};
        sum += exact_penalty(bar, most[i * rows_ + j]);
      }
      sum += bending_and_shear_energy(cell, at) / shape.stiffening;
      if (area_stiffness_ > 0.0) sum += corner_energy(cell, x);
    }
  }
  return sum;
}

double Cells::energy(const Motion& at, std::span<const double> tensions) const {
  double sum = 0.0;
  Vec2 d{1.0, 0.0};
  for (std::size_t i = 0; i < columns_; ++i) {
    const Cell& cell = shapes_[i];
    for (std::size_t j = 0; j < rows_; ++j) {
      const Corners x = corners(at.x, i, j);
      const CellModes shape = modes(cell, x);
      double rate = 0.0;
      if (damping_ > 0.0 && !at.v.empty()) {
        d = direction_of(shape.z, d);
        rate = dot(d, modes(cell, corners(at.v, i, j)).z);
      }
      sum += bending_and_shear_energy(cell, shape) +
             elastic_energy(tensions[i * rows_ + j], 1.0 / cell.stretch, damping_, rate);
      if (area_stiffness_ > 0.0) sum += corner_energy(cell, x);
    }
  }
  return sum;
}

bool Cells::unlock(std::span<const Vec2> x) {
  if (area_stiffness_ == 0.0) return false;
  any_unlocked_ = false;
  for (std::size_t i = 0; i < columns_; ++i) {
    for (std::size_t j = 0; j < rows_; ++j) {
      const std::array<double, 4> doubled = doubled_corner_areas(corners(x, i, j));
      const double least = *std::min_element(doubled.begin(), doubled.end());
      char& unlocked = unlocked_[i * rows_ + j];
      unlocked = least <= 0.0 || (unlocked != 0 && least <= unlocked_share * shapes_[i].area) ? 1 : 0;
      any_unlocked_ = any_unlocked_ || unlocked != 0;
    }
  }
  if (!any_unlocked_) return false;
  const auto columns = static_cast<std::ptrdiff_t>(columns_);
  Vec2 before{1.0, 0.0};
  for (std::ptrdiff_t i = 0; i < columns; ++i) {
    Vec2 sum{};
    for (std::ptrdiff_t k = std::max<std::ptrdiff_t>(0, i - unlock_reach); k < std::min(columns, i + unlock_reach + 1);
         ++k) {
      const auto column = static_cast<std::size_t>(k);
      for (std::size_t j = 0; j < rows_; ++j) sum += modes(shapes_[column], corners(x, column, j)).z;
    }
    before = direction_of(sum, before);
    toward_[static_cast<std::size_t>(i)] = before;
  }
  return true;
}

}  // namespace ribbon
