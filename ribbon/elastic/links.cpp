#include "ribbon/elastic/links.h"

#include <algorithm>

namespace ribbon {

Links::Links(const CordDef& def)
    : inverse_stiffness_(def.rows / def.stretch_stiffness), damping_(def.damping), tension_only_(def.tension_only) {
  const double row_distance = def.rows > 1 ? def.width / (def.rows - 1) : 0.0;
  for (int i = 0; i < def.points; ++i) {
    for (int j = 0; j < def.rows; ++j) {
      const int a = i * def.rows + j;
      if (j + 1 < def.rows) links_.push_back({a, a + 1, i, false, row_distance, row_distance});
      for (const int k : {j - 1, j, j + 1}) {
        if (i + 1 == def.points || k < 0 || k >= def.rows) continue;
        links_.push_back({a, (i + 1) * def.rows + k, i, true, (k - j) * row_distance, 0.0});
      }
    }
  }
  linearised_.resize(links_.size());
}

void Links::set_rest_lengths(std::span<const double> lengths) {
  for (Link& link : links_) {
    const double along = link.along ? lengths[static_cast<std::size_t>(link.column)] : 0.0;
    link.rest = length({along, link.across});
  }
}

void Links::find_tensions(std::span<const Vec2> x, std::span<double> tensions) const {
  for (std::size_t e = 0; e < links_.size(); ++e) {
    const Vec2 ab = x[static_cast<std::size_t>(links_[e].b)] - x[static_cast<std::size_t>(links_[e].a)];
    tensions[e] = static_tension({length(ab) - links_[e].rest, compliance(links_[e])}, tension_only_);
  }
}

void Links::add_damping(const Motion& at, double sign, std::span<double> tensions) const {
  if (inverse_stiffness_ == 0.0) return;
  for (std::size_t e = 0; e < links_.size(); ++e) {
    if (tension_only_ && tensions[e] == 0.0) continue;
    const double rate =
        extension_rate(at, static_cast<std::size_t>(links_[e].a), static_cast<std::size_t>(links_[e].b));
    tensions[e] += sign * damping_ * rate / compliance(links_[e]);
  }
}

void Links::add_turning(const Stage& stage, std::span<const Vec2> x, std::span<double> tensions) const {
  if (inverse_stiffness_ == 0.0 || damping_ == 0.0) return;
  for (std::size_t e = 0; e < links_.size(); ++e) {
    const auto a = static_cast<std::size_t>(links_[e].a);
    const auto b = static_cast<std::size_t>(links_[e].b);
    const Vec2 ab = x[b] - x[a];
    const double size = length(ab);
    if (size == 0.0 || (tension_only_ && tensions[e] == 0.0)) continue;
    tensions[e] +=
        damping_ * turning_rate(stage, stage.start(b) - stage.start(a), (1.0 / size) * ab) / compliance(links_[e]);
  }
}

inline MixedBar Links::bar(const Shape& shape, const Link& link, Vec2 d) const {
  const auto a = static_cast<std::size_t>(link.a);
  const auto b = static_cast<std::size_t>(link.b);
  if (inverse_stiffness_ == 0.0) return {dot(d, shape.x[b] - shape.x[a]) - link.rest, 0.0};
  const double turning =
      damping_ > 0.0 ? damping_ * turning_rate(shape.stage, shape.stage.start(b) - shape.stage.start(a), d) : 0.0;
  return {(dot(d, shape.damped[b] - shape.damped[a]) - turning - link.rest) / shape.stiffening,
          compliance(link) / shape.stiffening};
}

/// With a least compliance α₀ above α, α·λ⁺ + (α₀ − α)(λ⁺ − λ) = c + J·δ: the same solution, once λ rests, of a system
/// that is no stiffer than 1/α₀ (the proximal point method of Rockafellar 1976).
inline Links::Linearised Links::linearise(const Shape& shape, const Link& link, double tension) const {
  const Vec2 ab = shape.x[static_cast<std::size_t>(link.b)] - shape.x[static_cast<std::size_t>(link.a)];
  const double size = length(ab);
  const Vec2 d = size > 0.0 ? (1.0 / size) * ab : Vec2{0.0, -1.0};
  const double give = this->give(shape, link);
  MixedBar mixed = bar(shape, link, d);
  if (tension_only_ && is_slack(mixed, tension, give, size)) return {d, 0.0, 0.0, 0.0};
  const double least = proximal_share * give;
  if (mixed.compliance < least) {
    mixed.elongation += (least - mixed.compliance) * tension;
    mixed.compliance = least;
  }
  const double stiffness = 1.0 / mixed.compliance;
  return {d, stiffness * mixed.elongation, stiffness, size > 0.0 ? std::max(0.0, tension) / size : 0.0};
}

void Links::load(const NewtonSystem& system, std::span<const double> tensions) {
  if (links_.size() + 1 == system.x.size()) {
    load_rope(system, tensions);
    return;
  }
  for (std::size_t e = 0; e < links_.size(); ++e) {
    const Link& link = links_[e];
    const Linearised at = linearised_[e] = linearise(system, link, tensions[e]);
    const Vec2 pull = at.force * at.d;
    system.force[static_cast<std::size_t>(link.a)] += pull;
    system.force[static_cast<std::size_t>(link.b)] -= pull;
    system.add_between(link.a, link.b, directed(at.d, at.stiffness, at.across));
  }
}

/// The same of links one behind the other: what two of them add to their point is stored when both have.
void Links::load_rope(const NewtonSystem& system, std::span<const double> tensions) {
  const int stride = system.matrix.stride();
  double* upper = system.matrix.row(0);
  Block here{upper[0], upper[1], upper[stride]};
  Vec2 force = system.force[0];
  for (std::size_t e = 0; e < links_.size(); ++e) {
    const Linearised at = linearised_[e] = linearise(system, links_[e], tensions[e]);
    const Block block = directed(at.d, at.stiffness, at.across);
    const Vec2 pull = at.force * at.d;
    double* lower = upper + stride;
    here = here + block;
    upper[0] = here.xx;
    upper[1] = here.xy;
    lower[0] = here.yy;
    upper[2] -= block.xx;
    upper[3] -= block.xy;
    lower[1] -= block.xy;
    lower[2] -= block.yy;
    system.force[e] = force + pull;
    upper = lower + stride;
    here = Block{upper[0], upper[1], upper[stride]} + block;
    force = system.force[e + 1] - pull;
  }
  upper[0] = here.xx;
  upper[1] = here.xy;
  upper[stride] = here.yy;
  system.force[links_.size()] = force;
}

void Links::update(const NewtonSystem& /*system*/, std::span<const double> /*tensions*/,
                   std::span<const Vec2> direction, std::span<double> next) const {
  for (std::size_t e = 0; e < links_.size(); ++e) {
    const Link& link = links_[e];
    const Linearised& at = linearised_[e];
    const Vec2 apart = direction[static_cast<std::size_t>(link.b)] - direction[static_cast<std::size_t>(link.a)];
    next[e] = at.force + at.stiffness * dot(at.d, apart);
  }
}

double Links::misjudged_way(const Shape& shape, std::span<const double> tensions) const {
  double most = 0.0;
  for (std::size_t e = 0; tension_only_ && e < links_.size(); ++e) {
    if (tensions[e] > 0.0) continue;  // taut, and pulls
    const Link& link = links_[e];
    const Vec2 ab = shape.x[static_cast<std::size_t>(link.b)] - shape.x[static_cast<std::size_t>(link.a)];
    const double size = length(ab);
    const MixedBar mixed = bar(shape, link, size > 0.0 ? (1.0 / size) * ab : Vec2{});
    most = std::max(most, ribbon::misjudged_way(mixed, tensions[e], give(shape, link)));
  }
  return most;
}

double Links::potential(const Shape& shape, std::span<const double> most) const {
  double sum = 0.0;
  for (std::size_t e = 0; e < links_.size(); ++e) {
    const Vec2 ab = shape.x[static_cast<std::size_t>(links_[e].b)] - shape.x[static_cast<std::size_t>(links_[e].a)];
    const double size = length(ab);
    const MixedBar mixed = bar(shape, links_[e], size > 0.0 ? (1.0 / size) * ab : Vec2{});
    if (!(tension_only_ && mixed.elongation <= 0.0)) sum += exact_penalty(mixed, most[e]);
  }
  return sum;
}

double Links::energy(const Motion& at, std::span<const double> tensions) const {
  if (inverse_stiffness_ == 0.0) return 0.0;
  double sum = 0.0;
  for (std::size_t e = 0; e < links_.size(); ++e) {
    const Link& link = links_[e];
    double rate = 0.0;
    if (damping_ > 0.0 && tensions[e] != 0.0) {
      rate = extension_rate(at, static_cast<std::size_t>(link.a), static_cast<std::size_t>(link.b));
    }
    sum += elastic_energy(tensions[e], compliance(link), damping_, rate);
  }
  return sum;
}

}  // namespace ribbon
