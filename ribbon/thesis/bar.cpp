#include "ribbon/thesis/bar.h"

namespace ribbon {

void add_bar_stiffness(BandedMatrix& matrix, int a, int b, Vec2 direction, double k, bool free_a, bool free_b) {
  const double xx = k * direction.x * direction.x;
  const double xy = k * direction.x * direction.y;
  const double yy = k * direction.y * direction.y;
  const auto add_diagonal_block = [&](int p) {
    double* x_row = matrix.row(2 * p);
    double* y_row = matrix.row(2 * p + 1);
    x_row[0] += xx;
    x_row[1] += xy;
    y_row[0] += yy;
  };
  if (free_a) add_diagonal_block(a);
  if (free_b) add_diagonal_block(b);
  if (free_a && free_b) {
    const int right = 2 * (b - a);
    double* x_row = matrix.row(2 * a) + right;
    double* y_row = matrix.row(2 * a + 1) + right;
    x_row[0] -= xx;
    x_row[1] -= xy;
    y_row[-1] -= xy;
    y_row[0] -= yy;
  }
}

Vec2 bar_force(Vec2 direction, double k, Vec2 u_a, Vec2 u_b) { return (k * dot(direction, u_b - u_a)) * direction; }

}  // namespace ribbon
