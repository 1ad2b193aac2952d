#include "game/view/cloth.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>

#include "engine/draw/straight.h"

namespace game {
namespace {

using engine::Color;
using ribbon::Vec2;

/// The rows of points as smooth curves in pixels.
struct Rails {
  std::vector<std::vector<Vec2>> rows;
  int columns() const { return static_cast<int>(rows.front().size()); }
  Vec2 at(int i, int j) const { return rows[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)]; }
};

Rails rails_of(const Pen& pen, const DrawnCord& cord, int steps) {
  Rails rails;
  rails.rows.reserve(static_cast<std::size_t>(cord.shape.rows));
  for (int j = 0; j < cord.shape.rows; ++j) {
    std::vector<Vec2>& row = rails.rows.emplace_back(smooth_row(cord, j, steps));
    for (Vec2& x : row) x = pen.canvas.to_pixels(x);
  }
  return rails;
}

Vec2 unit(Vec2 v) { return length(v) > 1e-9 ? (1.0 / length(v)) * v : Vec2{}; }

/// Moves the outer rows and the ends outwards by `pixels`.
void grow(Rails& rails, double pixels) {
  const std::size_t last = rails.rows.size() - 1;
  for (std::size_t i = 0; i < rails.rows.front().size(); ++i) {
    const Vec2 across = pixels * unit(rails.rows[last][i] - rails.rows[0][i]);
    rails.rows[0][i] -= across;
    rails.rows[last][i] += across;
  }
  for (std::vector<Vec2>& row : rails.rows) {
    if (row.size() < 2) continue;
    row.front() -= pixels * unit(row[1] - row[0]);
    row.back() += pixels * unit(row[row.size() - 1] - row[row.size() - 2]);
  }
}

/// Returns the columns without those at which no row bends.
std::vector<int> bends_of(const Rails& rails) {
  std::vector<int> bends = {0};
  std::vector<engine::Straight> pieces;
  const auto begin_at = [&](int column) {
    pieces.clear();
    for (const std::vector<Vec2>& row : rails.rows) pieces.emplace_back(row[static_cast<std::size_t>(column)]);
  };
  begin_at(0);
  for (int i = 1; i + 1 < rails.columns(); ++i) {
    bool is_straight = true;
    for (std::size_t j = 0; j < pieces.size(); ++j) {
      pieces[j].pass(rails.at(i, static_cast<int>(j)));
      is_straight = is_straight && pieces[j].reaches(rails.at(i + 1, static_cast<int>(j)));
    }
    if (is_straight) continue;
    bends.push_back(i);
    begin_at(i);
  }
  if (rails.columns() > 1) bends.push_back(rails.columns() - 1);
  return bends;
}

std::vector<int> all_columns(int count) {
  std::vector<int> all(static_cast<std::size_t>(count));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

/// A grid of vertices with a border in which the cover falls to 0. u runs along the cloth, in widths; v runs across it
/// from 0 at the last row to 1 at the first.
class ClothMesh {
 public:
  /// `columns`: those that are drawn.
  ClothMesh(engine::TexturedMesh& mesh, const Rails& inner, const Rails& outer, const std::vector<int>& columns)
      : mesh_(mesh), inner_(inner), outer_(outer), columns_(columns) {}

  template <typename ColorOf>
  void build(double u_step, ColorOf color_of) {
    const int columns = static_cast<int>(columns_.size());
    const int rows = static_cast<int>(inner_.rows.size());
    for (int i = -1; i <= columns; ++i)
      for (int j = -1; j <= rows; ++j) add_vertex(i, j, u_step, color_of(column_at(i)));
    const int stride = rows + 2;
    for (int i = 0; i <= columns; ++i)
      for (int j = 0; j <= rows; ++j) {
        const int v = i * stride + j;
        mesh_.indices.insert(mesh_.indices.end(), {v, v + stride, v + stride + 1, v, v + stride + 1, v + 1});
      }
  }

 private:
  int column_at(int i) const {
    return columns_[static_cast<std::size_t>(std::clamp(i, 0, static_cast<int>(columns_.size()) - 1))];
  }
  void add_vertex(int i, int j, double u_step, Color color) {
    const int rows = static_cast<int>(inner_.rows.size());
    const int column = column_at(i);
    const int row = std::clamp(j, 0, rows - 1);
    const bool border = i < 0 || i >= static_cast<int>(columns_.size()) || row != j;
    const double v = 1.0 - static_cast<double>(row) / std::max(rows - 1, 1);
    mesh_.vertices.push_back(
        {(border ? outer_ : inner_).at(column, row), {u_step * column, v}, color, border ? 0.0 : 1.0});
  }

  engine::TexturedMesh& mesh_;
  const Rails& inner_;
  const Rails& outer_;
  const std::vector<int>& columns_;
};

}  // namespace

void draw_cloth(Pen& pen, const DrawnCord& cord, int steps, Color color, const std::vector<Color>& colors) {
  const bool direct = cord.coupling.cord(cord.index).solver() == ribbon::box2d::Solver::direct;
  const double radius = direct ? cord.coupling.cord(cord.index).direct().def().radius : 0.0;
  const Rails rails = rails_of(pen, cord, steps);
  Rails inner = rails;
  Rails outer = rails;
  grow(inner, radius * pen.scale() - 0.5);
  grow(outer, radius * pen.scale() + 0.5);
  const double spacing = cord.coupling.cord(cord.index).grid().rest_lengths[0];
  const auto color_of = [&](int i) {
    if (colors.empty()) return color;
    const auto column = static_cast<std::size_t>(i / steps);
    const Color next = colors[std::min(column + 1, colors.size() - 1)];
    return mix(colors[column], next, static_cast<double>(i % steps) / steps);
  };
  pen.mesh.clear();
  // Colours and their changes need all columns.
  const std::vector<int> columns = colors.empty() ? bends_of(inner) : all_columns(inner.columns());
  ClothMesh(pen.mesh, inner, outer, columns).build(spacing / (steps * cord.shape.thickness), color_of);
  pen.canvas.textured(pen.mesh, {&pen.images.cloth, engine::Filter::linear, engine::Wrap::repeat, engine::Wrap::clamp});
  // A dark edge for a clear silhouette. It is opaque, since it overlaps itself where the cloth bends more tightly than
  // the edge is wide.
  for (const auto* row : {&outer.rows.front(), &outer.rows.back()}) {
    pen.mesh.clear();
    engine::BandLook look;
    look.width = 0.03 * pen.scale();
    look.color = mix(pen.colors.ink, color, 0.27);
    add_band(pen.mesh, *row, look);
    pen.canvas.textured(pen.mesh, {});
  }
}

}  // namespace game
