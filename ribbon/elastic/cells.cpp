#include "ribbon/elastic/cells.h"

#include <algorithm>
#include <cmath>

#include "ribbon/elastic/link.h"
#include "ribbon/linear/index.h"

namespace ribbon {
namespace {

constexpr double min_spread = 1e-6;             // |z| below which z has no direction
constexpr double min_stiffness_spread = 0.05;   // |z| below which the geometric stiffness does not grow any more
constexpr double min_area_ratio = 0.2;          // α: area over rest area, below which a corner resists compression
constexpr double recovered_area_ratio = 0.9;    // the same, which all corners of an unlocked cell must reach
constexpr double shallow_inversion = 0.01;      // the same, negative, that a cell may recover from by itself
constexpr double unlocked_hourglass = 10.0;     // hourglass stiffness of an unlocked cell, as a multiple of E
constexpr std::ptrdiff_t averaged_columns = 3;  // on each side of an unlocked cell, whose mean direction it takes

/// Returns the direction of z, or `fallback` if z is too short.
Vec2 direction_of(Vec2 z, Vec2 fallback) {
  const double size = length(z);
  return size > min_spread ? (1.0 / size) * z : fallback;
}

/// Returns the gradient ∂A_c/∂X [m] of the area of corner triangle c with respect to the corners. With the edges U
/// along and V across at the corner, 2A_c = U × V, so ∂(2A_c)/∂U = −perp(V) and ∂(2A_c)/∂V = perp(U).
Corners corner_area_gradient(const Corners& x, std::size_t c) {
  const std::size_t across = c % 2;        // U goes from corner `across` to across + 2,
  const std::size_t side = c < 2 ? 0 : 2;  // V from corner `side` to side + 1
  const Vec2 half_along = -0.5 * perp(x[side + 1] - x[side]);
  const Vec2 half_across = 0.5 * perp(x[across + 2] - x[across]);
  Corners gradient{};
  gradient[across] -= half_along;
  gradient[across + 2] += half_along;
  gradient[side] -= half_across;
  gradient[side + 1] += half_across;
  return gradient;
}

/// Returns twice the smallest area of the corner triangles, m².
double smallest_corner(const Corners& x) {
  const std::array<double, 4> doubled = doubled_corner_areas(x);
  return *std::min_element(doubled.begin(), doubled.end());
}

}  // namespace

Cells::Cells(const CordDef& def, double modulus, double row_bending)
    : columns_(at(def.points) - 1),
      rows_(at(def.rows) - 1),
      height_(def.width / (def.rows - 1)),
      modulus_(modulus),
      poisson_ratio_(def.poisson_ratio),
      row_bending_(row_bending),
      damping_(def.damping),
      area_stiffness_(def.area_stiffness * modulus),
      shapes_(columns_) {
  if (area_stiffness_ > 0.0) {
    unlocked_.resize(columns_ * rows_);
    target_directions_.resize(columns_);
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

void Cells::add_damping(const Motion& motion, double sign, std::span<double> tensions) const {
  Vec2 d{1.0, 0.0};
  for (std::size_t i = 0; i < columns_; ++i) {
    for (std::size_t j = 0; j < rows_; ++j) {
      d = direction_of(modes(shapes_[i], corners(motion.x, i, j)).z, d);
      const double rate = dot(d, modes(shapes_[i], corners(motion.v, i, j)).z);
      tensions[i * rows_ + j] += sign * damping_ * rate * shapes_[i].stretch;
    }
  }
}

void Cells::add_rotational_damping(const Stage& stage, std::span<const Vec2> x, std::span<double> tensions) const {
  Vec2 d{1.0, 0.0};
  for (std::size_t i = 0; i < columns_; ++i) {
    for (std::size_t j = 0; j < rows_; ++j) {
      d = direction_of(modes(shapes_[i], corners(x, i, j)).z, d);
      if (is_unlocked(i * rows_ + j)) continue;
      tensions[i * rows_ + j] += shapes_[i].stretch * rotational_spread(stage, i, j, d);
    }
  }
}

/// Returns β times the rotational extension rate of z as a bar, dimensionless.
double Cells::rotational_spread(const Stage& stage, std::size_t column, std::size_t row, Vec2 d) const {
  if (damping_ == 0.0 || !stage.implicit_euler) return 0.0;
  const std::size_t p = point(column, row);
  const std::size_t q = point(column + 1, row);
  const Corners start = {stage.start(p), stage.start(p + 1), stage.start(q), stage.start(q + 1)};
  return damping_ * rotational_extension_rate(stage, modes(shapes_[column], start).z, d);
}

Corners Cells::corners(std::span<const Vec2> x, std::size_t column, std::size_t row) const {
  const std::size_t first = point(column, row);
  const std::size_t second = point(column + 1, row);
  return {x[first], x[first + 1], x[second], x[second + 1]};
}

double Cells::unlock_hourglass(const Cell& cell) const {
  return std::max(cell.hourglass, unlocked_hourglass * modulus_);
}

void Cells::add_constant(BandedMatrix& matrix) const {
  CellAssembler assembler(matrix);
  for (std::size_t i = 0; i < columns_; ++i) {
    for (std::size_t j = 0; j < rows_; ++j) {
      assembler.add_constant(shapes_[i], shapes_[i].hourglass, 1.0, static_cast<int>(point(i, j)),
                             static_cast<int>(point(i + 1, j)));
    }
  }
}

/// Returns the mean tension of a column [J], 0 or more, for its geometric stiffness. In a bent ribbon the cells of one
/// side are compressed as much as those of the other are stretched. The tension of each cell alone would make the bent
/// ribbon too stiff, because negative tensions are left out.
double Cells::mean_tension(std::size_t column, std::span<const double> tensions) const {
  double sum = 0.0;
  for (std::size_t j = 0; j < rows_; ++j) sum += tensions[column * rows_ + j];
  return std::max(0.0, sum / static_cast<double>(rows_));
}

/// Adds the Hessian of a cell that is not unlocked, and returns its forces. d is the direction of z, `across` [J] the
/// geometric stiffness.
inline Corners Cells::load_locked(const NewtonSystem& system, std::size_t column, std::size_t row, Vec2 d,
                                  double across, CellAssembler& assembler) const {
  const Cell& cell = shapes_[column];
  const CellModes mode = modes(cell, corners(system.damped, column, row));
  assembler.add_spread(cell, d, system.stiffening * cell.stretch, across, static_cast<int>(point(column, row)),
                       static_cast<int>(point(column + 1, row)));
  return forces(cell, mode,
                (cell.stretch * (dot(d, mode.z) - rotational_spread(system.stage, column, row, d) - 2.0)) * d);
}

/// The same for an unlocked cell. The matrix has its own hourglass stiffness already: only the difference is added.
Corners Cells::load_unlocked(const NewtonSystem& system, std::size_t column, std::size_t row, Vec2 d,
                             CellAssembler& assembler) const {
  const Cell& cell = shapes_[column];
  const int first = static_cast<int>(point(column, row));
  const int second = static_cast<int>(point(column + 1, row));
  Cell stiff = cell;
  stiff.hourglass = unlock_hourglass(cell);
  const double stretch = system.stiffening * cell.stretch;
  assembler.add_spread(cell, d, stretch, stretch, first, second);
  Cell extra = cell;
  extra.shear = 0.0;
  assembler.add_constant(extra, stiff.hourglass - cell.hourglass, system.stiffening, first, second);
  const CellModes mode = modes(cell, corners(system.damped, column, row));
  return forces(stiff, mode, cell.stretch * (mode.z - 2.0 * target_directions_[column]));
}

void Cells::load(const NewtonSystem& system, std::span<const double> tensions) {
  CellAssembler assembler(system.matrix);
  Vec2 d{1.0, 0.0};
  for (std::size_t i = 0; i < columns_; ++i) {
    const double pull = mean_tension(i, tensions);
    for (std::size_t j = 0; j < rows_; ++j) {
      const Vec2 z = modes(shapes_[i], corners(system.x, i, j)).z;
      d = direction_of(z, d);
      const double across = pull / std::max(length(z), min_stiffness_spread);
      const Corners push = is_unlocked(i * rows_ + j) ? load_unlocked(system, i, j, d, assembler)
                                                      : load_locked(system, i, j, d, across, assembler);
      const std::size_t p = point(i, j);
      const std::size_t q = point(i + 1, j);
      system.force[p] += push[0];
      system.force[p + 1] += push[1];
      system.force[q] += push[2];
      system.force[q + 1] += push[3];
      if (area_stiffness_ > 0.0) load_corner_areas(system, i, j);
    }
  }
}

/// Adds the forces and the Gauss–Newton Hessian of the corner areas.
void Cells::load_corner_areas(const NewtonSystem& system, std::size_t column, std::size_t row) {
  const Corners x = corners(system.x, column, row);
  const double rest = shapes_[column].area;  // 2A₀
  const std::array<double, 4> doubled = doubled_corner_areas(x);
  const int low = static_cast<int>(point(column, row));
  const int high = static_cast<int>(point(column + 1, row));
  for (std::size_t c = 0; c < 4; ++c) {
    const double missing = min_area_ratio * rest - doubled[c];
    if (missing <= 0.0) continue;
    const Corners gradient = corner_area_gradient(x, c);
    const std::array<int, 4> points{low, low + 1, high, high + 1};
    const double force = area_stiffness_ * missing / rest;
    const double stiffness = area_stiffness_ / (0.5 * rest);
    for (std::size_t k = 0; k < 4; ++k) {
      system.force[at(points[k])] += force * gradient[k];
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
      const Vec2 step = modes(cell, corners(direction, i, j)).z;
      const Vec2 z = modes(cell, corners(system.damped, i, j)).z;
      const double spread = dot(d, z) - rotational_spread(system.stage, i, j, d) - 2.0;
      next[i * rows_ + j] = cell.stretch * (spread + system.stiffening * dot(d, step));
    }
  }
}

double Cells::corner_energy(const Cell& cell, const Corners& x) const {
  double sum = 0.0;
  for (const double doubled : doubled_corner_areas(x)) {
    const double missing = 0.5 * std::max(0.0, min_area_ratio * cell.area - doubled);
    sum += 0.5 * area_stiffness_ * missing * missing / (0.5 * cell.area);
  }
  return sum;
}

double Cells::potential(const Shape& shape, std::span<const double> max_tensions) const {
  double sum = 0.0;
  Vec2 d{1.0, 0.0};
  for (std::size_t i = 0; i < columns_; ++i) {
    for (std::size_t j = 0; j < rows_; ++j) {
      Cell cell = shapes_[i];
      const Corners x = corners(shape.x, i, j);
      const CellModes mode = modes(cell, corners(shape.damped, i, j));
      d = direction_of(modes(cell, x).z, d);
      if (is_unlocked(i * rows_ + j)) {
        cell.hourglass = unlock_hourglass(cell);
        const Vec2 away = mode.z - 2.0 * target_directions_[i];
        sum += 0.5 * cell.stretch * dot(away, away) / shape.stiffening;
      } else {
        const double spread = dot(d, mode.z) - rotational_spread(shape.stage, i, j, d) - 2.0;
        const MixedBar bar{spread / shape.stiffening, 1.0 / (cell.stretch * shape.stiffening)};
        sum += exact_penalty(bar, max_tensions[i * rows_ + j]);
      }
      sum += bending_and_shear_energy(cell, mode) / shape.stiffening;
      if (area_stiffness_ > 0.0) sum += corner_energy(cell, x);
    }
  }
  return sum;
}

double Cells::energy(const Motion& motion, std::span<const double> tensions) const {
  double sum = 0.0;
  Vec2 d{1.0, 0.0};
  for (std::size_t i = 0; i < columns_; ++i) {
    const Cell& cell = shapes_[i];
    for (std::size_t j = 0; j < rows_; ++j) {
      const Corners x = corners(motion.x, i, j);
      const CellModes mode = modes(cell, x);
      double rate = 0.0;
      if (damping_ > 0.0 && !motion.v.empty()) {
        d = direction_of(mode.z, d);
        rate = dot(d, modes(cell, corners(motion.v, i, j)).z);
      }
      sum += bending_and_shear_energy(cell, mode) +
             elastic_energy(tensions[i * rows_ + j], 1.0 / cell.stretch, damping_, rate);
      if (area_stiffness_ > 0.0) sum += corner_energy(cell, x);
    }
  }
  return sum;
}

Vec2 Cells::force_on(std::size_t p, const Motion& motion, std::span<const double> tensions) const {
  Vec2 sum{};
  const std::size_t column = p / (rows_ + 1);
  const std::size_t row = p % (rows_ + 1);
  for (const std::size_t before : {std::size_t{1}, std::size_t{0}}) {
    for (const std::size_t below : {std::size_t{1}, std::size_t{0}}) {
      if (column < before || column - before >= columns_ || row < below || row - below >= rows_) continue;
      sum += cell_forces(column - before, row - below, motion, tensions)[2 * before + below];
    }
  }
  return sum;
}

Vec2 Cells::section_force(std::size_t link, const Motion& motion, std::span<const double> tensions) const {
  Vec2 sum{};
  for (std::size_t j = 0; j < rows_; ++j) {
    const Corners push = cell_forces(link, j, motion, tensions);
    sum += push[0] + push[1];
  }
  return sum;
}

/// Returns the elastic and damping forces of a cell on its corners, N.
Corners Cells::cell_forces(std::size_t column, std::size_t row, const Motion& motion,
                           std::span<const double> tensions) const {
  Cell cell = shapes_[column];
  const Corners x = corners(motion.x, column, row);
  CellModes mode = modes(cell, x);
  Vec2 pull = tensions[column * rows_ + row] * direction_of(mode.z, {});
  if (!motion.v.empty()) {
    const CellModes rate = modes(cell, corners(motion.v, column, row));
    mode = {mode.z + damping_ * rate.z, mode.w + damping_ * rate.w, mode.h + damping_ * rate.h};
  }
  if (is_unlocked(column * rows_ + row)) {
    cell.hourglass = unlock_hourglass(cell);
    pull = cell.stretch * (mode.z - 2.0 * target_directions_[column]);
  }
  Corners sum = forces(cell, mode, pull);
  if (area_stiffness_ == 0.0) return sum;
  const std::array<double, 4> doubled = doubled_corner_areas(x);
  for (std::size_t c = 0; c < 4; ++c) {
    const double missing = std::max(0.0, min_area_ratio * cell.area - doubled[c]);
    const Corners gradient = corner_area_gradient(x, c);
    for (std::size_t k = 0; k < 4; ++k) sum[k] += (area_stiffness_ * missing / cell.area) * gradient[k];
  }
  return sum;
}

bool Cells::unlock(std::span<const Vec2> x) {
  if (area_stiffness_ == 0.0) return false;
  any_unlocked_ = find_unlocked(x);
  if (any_unlocked_) find_target_directions(x);
  return any_unlocked_;
}

void Cells::lock() {
  any_unlocked_ = false;
  std::fill(unlocked_.begin(), unlocked_.end(), 0);
}

bool Cells::has_deep_inversion(std::span<const Vec2> x) const {
  for (std::size_t i = 0; area_stiffness_ > 0.0 && i < columns_; ++i) {
    for (std::size_t j = 0; j < rows_; ++j) {
      if (smallest_corner(corners(x, i, j)) <= -shallow_inversion * shapes_[i].area) return true;
    }
  }
  return false;
}

/// Unlocks cells with an inverted corner, and keeps cells unlocked until all their corners have recovered. Returns
/// whether any is unlocked.
bool Cells::find_unlocked(std::span<const Vec2> x) {
  bool any = false;
  for (std::size_t i = 0; i < columns_; ++i) {
    for (std::size_t j = 0; j < rows_; ++j) {
      const double smallest = smallest_corner(corners(x, i, j));
      char& unlocked = unlocked_[i * rows_ + j];
      unlocked = smallest <= 0.0 || (unlocked != 0 && smallest <= recovered_area_ratio * shapes_[i].area) ? 1 : 0;
      any = any || unlocked != 0;
    }
  }
  return any;
}

/// Sets d̄ of each column: the direction of Σz over the columns around it, or of the column before if the sum is too
/// short.
void Cells::find_target_directions(std::span<const Vec2> x) {
  const auto columns = static_cast<std::ptrdiff_t>(columns_);
  Vec2 direction{1.0, 0.0};
  for (std::ptrdiff_t i = 0; i < columns; ++i) {
    Vec2 sum{};
    const std::ptrdiff_t end = std::min(columns, i + averaged_columns + 1);
    for (std::ptrdiff_t k = std::max<std::ptrdiff_t>(0, i - averaged_columns); k < end; ++k) {
      const auto column = static_cast<std::size_t>(k);
      for (std::size_t j = 0; j < rows_; ++j) sum += modes(shapes_[column], corners(x, column, j)).z;
    }
    direction = direction_of(sum, direction);
    target_directions_[static_cast<std::size_t>(i)] = direction;
  }
}

}  // namespace ribbon
