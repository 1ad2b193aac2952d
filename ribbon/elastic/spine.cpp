#include "ribbon/elastic/spine.h"

#include <algorithm>
#include <array>

#include "ribbon/elastic/link.h"
#include "ribbon/linear/index.h"

namespace ribbon {
namespace {

// Share of the rest length below which the geometric stiffness of a bar does not grow any more.
constexpr double min_length_ratio = 0.05;
constexpr double min_length = 1e-300;  // m, to divide by; a bar without length has no direction

}  // namespace

Spine::Spine(const CordDef& def, double stiffness)
    : rows_(at(def.rows)),
      low_((rows_ - 1) / 2),
      high_(rows_ / 2),
      inverse_stiffness_(1.0 / stiffness),
      damping_(def.damping),
      rest_lengths_(at(def.points) - 1) {}

void Spine::set_rest_lengths(std::span<const double> lengths) {
  std::copy(lengths.begin(), lengths.end(), rest_lengths_.begin());
}

void Spine::find_tensions(std::span<const Vec2> x, std::span<double> tensions) const {
  for (std::size_t e = 0; e < rest_lengths_.size(); ++e) {
    tensions[e] = (length(bar_vector(x, e)) - rest_lengths_[e]) / compliance(e);
  }
}

double Spine::rate(const Motion& motion, std::size_t e) const {
  if (motion.v.empty()) return 0.0;
  const Vec2 ab = bar_vector(motion.x, e);
  return dot(ab, bar_vector(motion.v, e)) / std::max(length(ab), min_length_ratio * rest_lengths_[e]);
}

void Spine::add_damping(const Motion& motion, double sign, std::span<double> tensions) const {
  for (std::size_t e = 0; e < rest_lengths_.size(); ++e) {
    tensions[e] += sign * damping_ * rate(motion, e) / compliance(e);
  }
}

void Spine::add_rotational_damping(const Stage& stage, std::span<const Vec2> x, std::span<double> tensions) const {
  for (std::size_t e = 0; e < rest_lengths_.size(); ++e) {
    const Vec2 ab = bar_vector(x, e);
    tensions[e] += rotational_extension(stage, e, (1.0 / std::max(length(ab), min_length)) * ab) / compliance(e);
  }
}

/// Returns β times the rotational extension rate, m.
double Spine::rotational_extension(const Stage& stage, std::size_t e, Vec2 d) const {
  if (damping_ == 0.0 || !stage.implicit_euler) return 0.0;
  return damping_ *
         rotational_extension_rate(stage, bar_vector(stage.predicted, e) - stage.q * bar_vector(stage.velocity, e), d);
}

Vec2 Spine::middle(std::span<const Vec2> x, std::size_t column) const {
  return 0.5 * (x[column * rows_ + low_] + x[column * rows_ + high_]);
}

void Spine::load(const NewtonSystem& system, std::span<const double> tensions) {
  for (std::size_t e = 0; e < rest_lengths_.size(); ++e) {
    const Vec2 ab = bar_vector(system.x, e);
    const double size = std::max(length(ab), min_length);
    const Vec2 d = (1.0 / size) * ab;
    const double stiffness = 1.0 / compliance(e);
    const double pull = stiffness * (dot(d, bar_vector(system.damped, e)) - rotational_extension(system.stage, e, d) -
                                     rest_lengths_[e]);
    const Block block = directed(d, system.stiffening * stiffness,
                                 std::max(0.0, tensions[e]) / std::max(size, min_length_ratio * rest_lengths_[e]));
    const std::array<std::size_t, 4> points{e * rows_ + low_, e * rows_ + high_, (e + 1) * rows_ + low_,
                                            (e + 1) * rows_ + high_};
    constexpr std::array<double, 4> weights{-0.5, -0.5, 0.5, 0.5};
    for (std::size_t k = 0; k < 4; ++k) {
      system.force[points[k]] -= (weights[k] * pull) * d;
      for (std::size_t l = 0; l < 4; ++l) {
        if (points[k] > points[l]) continue;
        system.add(static_cast<int>(points[k]), static_cast<int>(points[l]), (weights[k] * weights[l]) * block);
      }
    }
  }
}

void Spine::update(const NewtonSystem& system, std::span<const double> /*tensions*/, std::span<const Vec2> direction,
                   std::span<double> next) const {
  for (std::size_t e = 0; e < rest_lengths_.size(); ++e) {
    const Vec2 ab = bar_vector(system.x, e);
    const Vec2 d = (1.0 / std::max(length(ab), min_length)) * ab;
    const double elongation =
        dot(d, bar_vector(system.damped, e)) - rotational_extension(system.stage, e, d) - rest_lengths_[e];
    next[e] = (elongation + system.stiffening * dot(d, bar_vector(direction, e))) / compliance(e);
  }
}

double Spine::potential(const Shape& shape, std::span<const double> max_tensions) const {
  double sum = 0.0;
  for (std::size_t e = 0; e < rest_lengths_.size(); ++e) {
    const Vec2 ab = bar_vector(shape.x, e);
    const double size = length(ab);
    const Vec2 d = unit_or(ab, size, {});
    const double along = dot(d, bar_vector(shape.damped, e)) - rotational_extension(shape.stage, e, d);
    sum += exact_penalty({(along - rest_lengths_[e]) / shape.stiffening, compliance(e) / shape.stiffening},
                         max_tensions[e]);
  }
  return sum;
}

double Spine::energy(const Motion& motion, std::span<const double> tensions) const {
  double sum = 0.0;
  for (std::size_t e = 0; e < rest_lengths_.size(); ++e) {
    sum += elastic_energy(tensions[e], compliance(e), damping_, damping_ > 0.0 ? rate(motion, e) : 0.0);
  }
  return sum;
}

Vec2 Spine::section_force(std::size_t link, const Motion& motion, std::span<const double> tensions) const {
  const Vec2 ab = bar_vector(motion.x, link);
  return tensions[link] * unit_or(ab, length(ab), {});
}

Vec2 Spine::force_on(std::size_t point, const Motion& motion, std::span<const double> tensions) const {
  const std::size_t column = point / rows_;
  const std::size_t row = point % rows_;
  const double share = 0.5 * ((row == low_ ? 1.0 : 0.0) + (row == high_ ? 1.0 : 0.0));
  if (share == 0.0) return {};
  const auto pull = [&](std::size_t e) {
    const Vec2 ab = bar_vector(motion.x, e);
    return tensions[e] * unit_or(ab, length(ab), {});
  };
  Vec2 force{};
  if (column > 0) force -= pull(column - 1);
  if (column < rest_lengths_.size()) force += pull(column);
  return share * force;
}

}  // namespace ribbon
