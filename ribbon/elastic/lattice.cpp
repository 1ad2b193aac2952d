#include "ribbon/elastic/lattice.h"

#include <algorithm>

#include "ribbon/elastic/bends.h"
#include "ribbon/elastic/cells.h"
#include "ribbon/elastic/links.h"
#include "ribbon/elastic/spine.h"
#include "ribbon/linear/index.h"

namespace ribbon {
namespace {

using Terms = std::vector<std::unique_ptr<Term>>;

// Share of EA above which a spine is worth its cost; rounding leaves less.
constexpr double min_spine_share = 1e-9;

/// Adds the cells of a ribbon. One row of cells bends only by its hourglass mode, so E follows from EA, and EI is
/// independent. Several rows of cells also bend by stretching, so E follows from EI, E = 12·EI/width³. In both cases a
/// spine adds the missing EA.
void add_cells(const CordDef& def, Terms& terms) {
  double modulus = (def.cell_stiffness > 0.0 ? def.cell_stiffness : def.stretch_stiffness) / def.width;
  double row_bending = def.bending_stiffness;
  if (def.rows > 2) {
    modulus = 12.0 * def.bending_stiffness / (def.width * def.width * def.width);
    const double height = def.width / (def.rows - 1);
    row_bending = modulus * height * height * height / 12.0;
  }
  terms.push_back(std::make_unique<Cells>(def, modulus, row_bending));
  if (def.rows == 2 && def.cell_stiffness == 0.0) return;
  const double missing = def.stretch_stiffness - modulus * def.width;
  if (missing > min_spine_share * def.stretch_stiffness) terms.push_back(std::make_unique<Spine>(def, missing));
}

Terms declared_terms(const CordDef& def) {
  Terms terms;
  if (def.rows == 1 || def.elements == Elements::bars) {
    terms.push_back(std::make_unique<Links>(def));
    if (def.bending_stiffness > 0.0) terms.push_back(std::make_unique<Bends>(def));
  } else {
    add_cells(def, terms);
  }
  return terms;
}

}  // namespace

Lattice::Lattice(const CordDef& def)
    : damping_(def.damping),
      tension_only_(def.tension_only),
      reach_(def.rows > 1                  ? def.rows + 1
             : def.bending_stiffness > 0.0 ? 2
                                           : 1),
      terms_(declared_terms(def)),
      constant_(2 * def.points * def.rows, def.rows == 1 ? 5 : 2 * def.rows + 3),
      stiffened_(constant_),
      matrix_(constant_),
      damped_(at(def.damping > 0.0 ? def.points * def.rows : 0)),
      right_side_(2 * at(def.points * def.rows)) {
  for (const auto& term : terms_) tension_count_ += term->tension_count();
}

void Lattice::set_rest_lengths(std::span<const double> lengths) {
  constant_.set_zero();
  stiffening_ = 0.0;
  for (const auto& term : terms_) {
    term->set_rest_lengths(lengths);
    term->add_constant(constant_);
  }
}

void Lattice::find_tensions(std::span<const Vec2> x, std::span<double> tensions) const {
  for_each_term([&](const Term& term, std::size_t first, std::size_t count) {
    term.find_tensions(x, tensions.subspan(first, count));
  });
}

void Lattice::add_damping(const Motion& motion, double sign, std::span<double> tensions) const {
  for_each_term([&](const Term& term, std::size_t first, std::size_t count) {
    term.add_damping(motion, sign, tensions.subspan(first, count));
  });
}

void Lattice::add_rotational_damping(const Stage& stage, std::span<const Vec2> x, std::span<double> tensions) const {
  for_each_term([&](const Term& term, std::size_t first, std::size_t count) {
    term.add_rotational_damping(stage, x, tensions.subspan(first, count));
  });
}

Shape Lattice::shape(const Stage& stage, std::span<const Vec2> x) {
  if (damping_ == 0.0) return {stage, x, x, 1.0};
  const double inverse_q = 1.0 / stage.q;
  for (std::size_t p = 0; p < damped_.size(); ++p) {
    damped_[p] = x[p] + damping_ * (stage.velocity[p] + inverse_q * (x[p] - stage.predicted[p]));
  }
  return last_shape(stage, x);
}

Shape Lattice::last_shape(const Stage& stage, std::span<const Vec2> x) const {
  if (damping_ == 0.0) return {stage, x, x, 1.0};
  return {stage, x, damped_, 1.0 + damping_ / stage.q};
}

/// After elimination of the tensions, the system is H·δ = r. H is the sum of the inertia and the positive semidefinite
/// part of the elastic Hessian, with the geometric stiffness of the last iteration's tensions; r is the residual of the
/// stage.
bool Lattice::newton_step(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions,
                          std::span<Vec2> direction, std::span<double> next, std::span<EliminatedLink> /*eliminated*/) {
  assemble(stage, x, tensions, direction);
  hold_constrained(stage, direction);
  if (!solve(direction)) return false;
  update(stage, x, tensions, direction, {}, next);
  return true;
}

void Lattice::assemble(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions,
                       std::span<Vec2> force) {
  const NewtonSystem system{shape(stage, x), matrix_, force};
  if (stiffening_ != system.stiffening) {
    stiffening_ = system.stiffening;
    stiffened_.set_scaled(constant_, stiffening_);
  }
  matrix_ = stiffened_;
  for (std::size_t p = 0; p < x.size(); ++p) {
    force[p] = stage.residual(p, x[p]);
  }
  double* diagonal = matrix_.row(0);
  for (const double inertia : stage.inertia) {
    diagonal[0] += inertia;
    diagonal[matrix_.stride()] += inertia;
    diagonal += 2 * matrix_.stride();
  }
  for (std::size_t p = 0; p < stage.resistance.size(); ++p) {
    system.add(static_cast<int>(p), static_cast<int>(p), stage.resistance[p]);
  }
  for (const CondensedBody& body : stage.condensed_bodies) {
    force[body.point] += body.residual;
    system.add(static_cast<int>(body.point), static_cast<int>(body.point), body.stiffness);
  }
  for_each_term(
      [&](Term& term, std::size_t first, std::size_t count) { term.load(system, tensions.subspan(first, count)); });
}

void Lattice::order(int first, int /*first_dual*/, std::vector<int>& slots, const PointCallback& on_point) const {
  for (int p = 0; p < matrix_.size() / 2; ++p) {
    slots.push_back(first + p);
    on_point(first + p);
  }
}

void Lattice::couple(BlockLdlt& blocks, int first, int /*first_dual*/) const {
  const int n = matrix_.size() / 2;
  for (int p = 0; p < n; ++p) {
    for (int k = 1; k <= reach_ && p + k < n; ++k) blocks.couple(first + p, first + p + k);
  }
}

void Lattice::load(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions, BlockLdlt& blocks,
                   int first, int /*first_dual*/, std::span<Vec2> right_side) {
  assemble(stage, x, tensions, right_side.subspan(at(first), x.size()));
  blocks.add_band(first, matrix_, reach_);
}

void Lattice::update(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions,
                     std::span<const Vec2> direction, std::span<const Vec2> /*duals*/, std::span<double> next) {
  const NewtonSystem system{last_shape(stage, x), matrix_, {}};
  for_each_term([&](const Term& term, std::size_t first, std::size_t count) {
    term.update(system, tensions.subspan(first, count), direction, next.subspan(first, count));
  });
}

/// Replaces the rows and columns of constrained points by those of the identity.
void Lattice::hold_constrained(const Stage& stage, std::span<Vec2> force) {
  for (std::size_t p = 0; p < force.size(); ++p) {
    if (stage.constrained[p] == 0) continue;
    force[p] = {};
    matrix_.hold(static_cast<int>(2 * p));
    matrix_.hold(static_cast<int>(2 * p + 1));
  }
}

/// Overwrites the residual [N] with the direction [m]. Returns false if the matrix is not positive definite.
bool Lattice::solve(std::span<Vec2> residual) {
  for (std::size_t p = 0; p < residual.size(); ++p) {
    right_side_[2 * p] = residual[p].x;
    right_side_[2 * p + 1] = residual[p].y;
  }
  if (!solver_.solve(matrix_, right_side_)) return false;
  for (std::size_t p = 0; p < residual.size(); ++p) residual[p] = {right_side_[2 * p], right_side_[2 * p + 1]};
  return true;
}

double Lattice::potential(const Stage& stage, std::span<const Vec2> x, std::span<const double> max_tensions) {
  const Shape evaluated = shape(stage, x);
  double sum = 0.0;
  for_each_term([&](const Term& term, std::size_t first, std::size_t count) {
    sum += term.potential(evaluated, max_tensions.subspan(first, count));
  });
  return sum;
}

void Lattice::append_bars(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions,
                          std::vector<OneSidedBar>& bars) {
  if (!tension_only_) return;
  const Shape evaluated = shape(stage, x);
  for_each_term([&](const Term& term, std::size_t first, std::size_t count) {
    term.append_bars(evaluated, tensions.subspan(first, count), bars);
  });
}

double Lattice::active_set_error(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions) {
  const auto is_taut = [](double tension) { return tension > 0.0; };
  if (!tension_only_ || std::all_of(tensions.begin(), tensions.end(), is_taut)) return 0.0;
  const Shape evaluated = shape(stage, x);
  double largest = 0.0;
  for_each_term([&](const Term& term, std::size_t first, std::size_t count) {
    largest = std::max(largest, term.active_set_error(evaluated, tensions.subspan(first, count)));
  });
  return largest;
}

double Lattice::energy(const Motion& motion, std::span<const double> tensions) const {
  double sum = 0.0;
  for_each_term([&](const Term& term, std::size_t first, std::size_t count) {
    sum += term.energy(motion, tensions.subspan(first, count));
  });
  return sum;
}

Vec2 Lattice::force_on(std::size_t point, const Motion& motion, std::span<const double> tensions) const {
  Vec2 sum{};
  for_each_term([&](const Term& term, std::size_t first, std::size_t count) {
    sum += term.force_on(point, motion, tensions.subspan(first, count));
  });
  return sum;
}

Vec2 Lattice::section_force(std::size_t link, const Motion& motion, std::span<const double> tensions) const {
  Vec2 sum{};
  for_each_term([&](const Term& term, std::size_t first, std::size_t count) {
    sum += term.section_force(link, motion, tensions.subspan(first, count));
  });
  return sum;
}

bool Lattice::unlock(std::span<const Vec2> x) {
  bool any = false;
  for (const auto& term : terms_) any = term->unlock(x) || any;
  return any;
}

void Lattice::lock() {
  for (const auto& term : terms_) term->lock();
}

bool Lattice::has_deep_inversion(std::span<const Vec2> x) const {
  return std::any_of(terms_.begin(), terms_.end(), [x](const auto& term) { return term->has_deep_inversion(x); });
}

std::span<char> Lattice::unlocked() {
  for (const auto& term : terms_) {
    if (!term->unlocked().empty()) return term->unlocked();
  }
  return {};
}

}  // namespace ribbon
