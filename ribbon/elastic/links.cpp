#include "ribbon/elastic/links.h"

#include <algorithm>

namespace ribbon {

Links::Links(const CordDef& def)
    : inverse_stiffness_(def.rows / def.stretch_stiffness),
      damping_(def.damping),
      tension_only_(def.tension_only),
      column_links_(4 * at(def.rows) - 3) {
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
    const double along = link.along ? lengths[at(link.column)] : 0.0;
    link.rest_length = length({along, link.across});
  }
}

void Links::find_tensions(std::span<const Vec2> x, std::span<double> tensions) const {
  for (std::size_t e = 0; e < links_.size(); ++e) {
    const Vec2 ab = vector(x, links_[e]);
    tensions[e] = static_tension({length(ab) - links_[e].rest_length, compliance(links_[e])}, tension_only_);
  }
}

void Links::add_damping(const Motion& motion, double sign, std::span<double> tensions) const {
  if (inverse_stiffness_ == 0.0) return;
  for (std::size_t e = 0; e < links_.size(); ++e) {
    if (tension_only_ && tensions[e] == 0.0) continue;
    const double rate = extension_rate(motion, at(links_[e].a), at(links_[e].b));
    tensions[e] += sign * damping_ * rate / compliance(links_[e]);
  }
}

void Links::add_rotational_damping(const Stage& stage, std::span<const Vec2> x, std::span<double> tensions) const {
  if (inverse_stiffness_ == 0.0 || damping_ == 0.0) return;
  for (std::size_t e = 0; e < links_.size(); ++e) {
    const Vec2 ab = vector(x, links_[e]);
    const double size = length(ab);
    if (size == 0.0 || (tension_only_ && tensions[e] == 0.0)) continue;
    tensions[e] += damping_ * rotation_rate(stage, links_[e], (1.0 / size) * ab) / compliance(links_[e]);
  }
}

inline double Links::rotation_rate(const Stage& stage, const Link& link, Vec2 d) const {
  return rotational_extension_rate(stage, stage.start(at(link.b)) - stage.start(at(link.a)), d);
}

inline MixedBar Links::bar(const Shape& shape, const Link& link, Vec2 d) const {
  if (inverse_stiffness_ == 0.0) return {dot(d, vector(shape.x, link)) - link.rest_length, 0.0};
  const double rotation = damping_ > 0.0 ? damping_ * rotation_rate(shape.stage, link, d) : 0.0;
  return {(dot(d, vector(shape.damped, link)) - rotation - link.rest_length) / shape.stiffening,
          compliance(link) / shape.stiffening};
}

inline Links::Linearised Links::linearise(const Shape& shape, const Link& link, double tension) const {
  const Vec2 ab = vector(shape.x, link);
  const double size = length(ab);
  const Vec2 d = unit_or(ab, size, {0.0, -1.0});
  const double q2_over_m = point_compliance(shape, link);
  const MixedBar exact = bar(shape, link, d);
  const double across = size > 0.0 ? std::max(0.0, tension) / size : 0.0;
  if (tension_only_ && shape.stage.bars_are_rows) return {d, 0.0, 0.0, across};
  if (tension_only_ && is_slack(exact, tension, q2_over_m, size)) return {d, 0.0, 0.0, 0.0};
  const MixedBar mixed = proximal(exact, min_proximal_compliance * q2_over_m, tension);
  const double stiffness = 1.0 / mixed.compliance;
  return {d, stiffness * mixed.elongation, stiffness, across};
}

void Links::load(const NewtonSystem& system, std::span<const double> tensions) {
  if (links_.size() + 1 == system.x.size()) {
    load_rope(system, tensions);
    return;
  }
  for (std::size_t e = 0; e < links_.size(); ++e) {
    const Link& link = links_[e];
    const Linearised linearised = linearised_[e] = linearise(system, link, tensions[e]);
    const Vec2 pull = linearised.force * linearised.d;
    system.force[at(link.a)] += pull;
    system.force[at(link.b)] -= pull;
    system.add_between(link.a, link.b, directed(linearised.d, linearised.stiffness, linearised.across));
  }
}

/// Loads a rope. A point belongs to two consecutive links: its sums stay in registers until both have been added.
void Links::load_rope(const NewtonSystem& system, std::span<const double> tensions) {
  const int stride = system.matrix.stride();
  double* upper = system.matrix.row(0);
  Block diagonal{upper[0], upper[1], upper[stride]};
  Vec2 force = system.force[0];
  for (std::size_t e = 0; e < links_.size(); ++e) {
    const Linearised linearised = linearised_[e] = linearise(system, links_[e], tensions[e]);
    const Block block = directed(linearised.d, linearised.stiffness, linearised.across);
    const Vec2 pull = linearised.force * linearised.d;
    double* lower = upper + stride;
    diagonal = diagonal + block;
    upper[0] = diagonal.xx;
    upper[1] = diagonal.xy;
    lower[0] = diagonal.yy;
    upper[2] -= block.xx;
    upper[3] -= block.xy;
    lower[1] -= block.xy;
    lower[2] -= block.yy;
    system.force[e] = force + pull;
    upper = lower + stride;
    diagonal = Block{upper[0], upper[1], upper[stride]} + block;
    force = system.force[e + 1] - pull;
  }
  upper[0] = diagonal.xx;
  upper[1] = diagonal.xy;
  upper[stride] = diagonal.yy;
  system.force[links_.size()] = force;
}

void Links::update(const NewtonSystem& /*system*/, std::span<const double> /*tensions*/,
                   std::span<const Vec2> direction, std::span<double> next) const {
  for (std::size_t e = 0; e < links_.size(); ++e) {
    const Link& link = links_[e];
    const Linearised& linearised = linearised_[e];
    const Vec2 relative = vector(direction, link);
    next[e] = linearised.force + linearised.stiffness * dot(linearised.d, relative);
  }
}

/// Only a rope has bars that cannot push: its bar e is its link e.
void Links::append_bars(const Shape& shape, std::span<const double> tensions, std::vector<OneSidedBar>& bars) const {
  for (std::size_t e = 0; tension_only_ && e < links_.size(); ++e) {
    const Vec2 ab = vector(shape.x, links_[e]);
    const double size = length(ab);
    const Vec2 d = unit_or(ab, size, {0.0, -1.0});
    bars.push_back(one_sided(e, d, bar(shape, links_[e], d), tensions[e], point_compliance(shape, links_[e]), size));
  }
}

double Links::active_set_error(const Shape& shape, std::span<const double> tensions) const {
  double largest = 0.0;
  for (std::size_t e = 0; tension_only_ && e < links_.size(); ++e) {
    if (tensions[e] > 0.0) continue;  // under tension, as assumed
    const Link& link = links_[e];
    const Vec2 ab = vector(shape.x, link);
    const double size = length(ab);
    const MixedBar mixed = bar(shape, link, unit_or(ab, size, {}));
    largest = std::max(largest, ribbon::active_set_error(mixed, tensions[e], point_compliance(shape, link)));
  }
  return largest;
}

double Links::potential(const Shape& shape, std::span<const double> max_tensions) const {
  double sum = 0.0;
  for (std::size_t e = 0; e < links_.size(); ++e) {
    const Vec2 ab = vector(shape.x, links_[e]);
    const double size = length(ab);
    const MixedBar mixed = bar(shape, links_[e], unit_or(ab, size, {}));
    if (!(tension_only_ && mixed.elongation <= 0.0)) sum += exact_penalty(mixed, max_tensions[e]);
  }
  return sum;
}

double Links::energy(const Motion& motion, std::span<const double> tensions) const {
  if (inverse_stiffness_ == 0.0) return 0.0;
  double sum = 0.0;
  for (std::size_t e = 0; e < links_.size(); ++e) {
    const Link& link = links_[e];
    const auto rate = [&] { return extension_rate(motion, at(link.a), at(link.b)); };
    const auto elongation = [&] { return length(vector(motion.x, link)) - link.rest_length; };
    sum += damped_elastic_energy(tensions[e], compliance(link), damping_, tension_only_, rate, elongation);
  }
  return sum;
}

Vec2 Links::section_force(std::size_t link, const Motion& motion, std::span<const double> tensions) const {
  Vec2 force{};
  for (std::size_t e = link * column_links_; e < (link + 1) * column_links_; ++e) {
    if (!links_[e].along) continue;
    const Vec2 ab = vector(motion.x, links_[e]);
    force += tensions[e] * unit_or(ab, length(ab), {});
  }
  return force;
}

Vec2 Links::force_on(std::size_t point, const Motion& motion, std::span<const double> tensions) const {
  Vec2 force{};
  for (std::size_t e = 0; e < links_.size(); ++e) {
    if (at(links_[e].a) != point && at(links_[e].b) != point) continue;
    const Vec2 ab = vector(motion.x, links_[e]);
    const Vec2 pull = tensions[e] * unit_or(ab, length(ab), {});
    force += at(links_[e].a) == point ? pull : -pull;
  }
  return force;
}

}  // namespace ribbon
