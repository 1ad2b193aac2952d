#include "ribbon/elastic/spine.h"

#include <algorithm>
#include <array>

#include "ribbon/elastic/link.h"

namespace ribbon {
namespace {

// Of the rest length, below which a crushed link's geometric stiffness grows no further.
constexpr double shortest_share = 0.05;

}  // namespace

Spine::Spine(const CordDef& def, double stiffness)
    : rows_(static_cast<std::size_t>(def.rows)),
      low_((rows_ - 1) / 2),
      high_(rows_ / 2),
      inverse_stiffness_(1.0 / stiffness),
      damping_(def.damping),
      rest_(static_cast<std::size_t>(def.points) - 1) {}

void Spine::set_rest_lengths(std::span<const double> lengths) {
  std::copy(lengths.begin(), lengths.end(), rest_.begin());
}

void Spine::find_tensions(std::span<const Vec2> x, std::span<double> tensions) const {
  for (std::size_t e = 0; e < rest_.size(); ++e) tensions[e] = (length(link(x, e)) - rest_[e]) / compliance(e);
}

double Spine::rate(const Motion& at, std::size_t e) const {
  if (at.v.empty()) return 0.0;
  const Vec2 ab = link(at.x, e);
  return dot(ab, link(at.v, e)) / std::max(length(ab), shortest_share * rest_[e]);
}

void Spine::add_damping(const Motion& at, double sign, std::span<double> tensions) const {
  for (std::size_t e = 0; e < rest_.size(); ++e) tensions[e] += sign * damping_ * rate(at, e) / compliance(e);
}

void Spine::add_turning(const Stage& stage, std::span<const Vec2> x, std::span<double> tensions) const {
  for (std::size_t e = 0; e < rest_.size(); ++e) {
    const Vec2 ab = link(x, e);
    tensions[e] += turning(stage, e, (1.0 / std::max(length(ab), 1e-300)) * ab) / compliance(e);
  }
}

/// m, β times the turning rate.
double Spine::turning(const Stage& stage, std::size_t e, Vec2 d) const {
  if (damping_ == 0.0 || !stage.euler) return 0.0;
  return damping_ * turning_rate(stage, link(stage.predicted, e) - stage.q * link(stage.velocity, e), d);
}

Vec2 Spine::middle(std::span<const Vec2> x, std::size_t column) const {
  return 0.5 * (x[column * rows_ + low_] + x[column * rows_ + high_]);
}

void Spine::load(const NewtonSystem& system, std::span<const double> tensions) {
  for (std::size_t e = 0; e < rest_.size(); ++e) {
    const Vec2 ab = link(system.x, e);
    const double size = std::max(length(ab), 1e-300);
    const Vec2 d = (1.0 / size) * ab;
    const double stiffness = 1.0 / compliance(e);
    const double pull = stiffness * (dot(d, link(system.damped, e)) - turning(system.stage, e, d) - rest_[e]);
    const Block block = directed(d, system.stiffening * stiffness,
                                 std::max(0.0, tensions[e]) / std::max(size, shortest_share * rest_[e]));
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
  for (std::size_t e = 0; e < rest_.size(); ++e) {
    const Vec2 ab = link(system.x, e);
    const Vec2 d = (1.0 / std::max(length(ab), 1e-300)) * ab;
    const double elongation = dot(d, link(system.damped, e)) - turning(system.stage, e, d) - rest_[e];
    next[e] = (elongation + system.stiffening * dot(d, link(direction, e))) / compliance(e);
  }
}

double Spine::potential(const Shape& shape, std::span<const double> most) const {
  double sum = 0.0;
  for (std::size_t e = 0; e < rest_.size(); ++e) {
    const Vec2 ab = link(shape.x, e);
    const double size = length(ab);
    const Vec2 d = size > 0.0 ? (1.0 / size) * ab : Vec2{};
    const double along = dot(d, link(shape.damped, e)) - turning(shape.stage, e, d);
    sum += exact_penalty({(along - rest_[e]) / shape.stiffening, compliance(e) / shape.stiffening}, most[e]);
  }
  return sum;
}

double Spine::energy(const Motion& at, std::span<const double> tensions) const {
  double sum = 0.0;
  for (std::size_t e = 0; e < rest_.size(); ++e) {
    sum += elastic_energy(tensions[e], compliance(e), damping_, damping_ > 0.0 ? rate(at, e) : 0.0);
  }
  return sum;
}

}  // namespace ribbon
