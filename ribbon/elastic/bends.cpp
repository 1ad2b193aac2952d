#include "ribbon/elastic/bends.h"

#include "ribbon/linear/index.h"

namespace ribbon {

Bends::Bends(const CordDef& def)
    : bending_stiffness_(def.bending_stiffness), damping_(def.damping), bends_(at(def.points) - 2) {}

void Bends::set_rest_lengths(std::span<const double> lengths) {
  for (std::size_t k = 0; k < bends_.size(); ++k) {
    const double before = 1.0 / lengths[k];
    const double after = 1.0 / lengths[k + 1];
    bends_[k] = {{before, -(before + after), after}, 2.0 * bending_stiffness_ / (lengths[k] + lengths[k + 1])};
  }
}

Vec2 Bends::turn(std::size_t k, std::span<const Vec2> x) const {
  const auto& weights = bends_[k].weights;
  return weights[0] * x[k] + weights[1] * x[k + 1] + weights[2] * x[k + 2];
}

void Bends::add_constant(BandedMatrix& matrix) const {
  for (std::size_t k = 0; k < bends_.size(); ++k) {
    const Bend& bend = bends_[k];
    for (std::size_t i = 0; i < 3; ++i) {
      double* x_row = matrix.row(static_cast<int>(2 * (k + i)));
      double* y_row = matrix.row(static_cast<int>(2 * (k + i) + 1));
      for (std::size_t j = i; j < 3; ++j) {
        const double entry = bend.stiffness * bend.weights[i] * bend.weights[j];
        x_row[2 * (j - i)] += entry;
        y_row[2 * (j - i)] += entry;
      }
    }
  }
}

void Bends::load(const NewtonSystem& system, std::span<const double> /*tensions*/) {
  const std::span<Vec2> force = system.force;
  // A point belongs to three consecutive bends: its sum is stored when the last of them has been added.
  Vec2 first = force[0];
  Vec2 second = force[1];
  for (std::size_t k = 0; k < bends_.size(); ++k) {
    const auto& weights = bends_[k].weights;
    const Vec2 moment = bends_[k].stiffness * turn(k, system.damped);
    force[k] = first - weights[0] * moment;
    first = second - weights[1] * moment;
    second = force[k + 2] - weights[2] * moment;
  }
  force[bends_.size()] = first;
  force[bends_.size() + 1] = second;
}

double Bends::energy_at(std::span<const Vec2> x) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < bends_.size(); ++k) {
    const Vec2 t = turn(k, x);
    sum += 0.5 * bends_[k].stiffness * dot(t, t);
  }
  return sum;
}

double Bends::potential(const Shape& shape, std::span<const double> /*max_tensions*/) const {
  return energy_at(shape.damped) / shape.stiffening;
}

double Bends::energy(const Motion& motion, std::span<const double> /*tensions*/) const { return energy_at(motion.x); }

Vec2 Bends::force_on(std::size_t point, const Motion& motion, std::span<const double> /*tensions*/) const {
  Vec2 force{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (point < i || point - i >= bends_.size()) continue;
    const std::size_t k = point - i;
    Vec2 damped_turn = turn(k, motion.x);
    if (!motion.v.empty()) damped_turn += damping_ * turn(k, motion.v);
    force -= (bends_[k].stiffness * bends_[k].weights[i]) * damped_turn;
  }
  return force;
}

}  // namespace ribbon
