#include "tests/study/errors.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace study {
namespace {

using ribbon::Vec2;

double peak(std::span<const double> values) { return *std::max_element(values.begin(), values.end()); }

/// Returns NaN if any value is NaN.
template <typename Value>
double greatest(std::size_t count, Value&& value) {
  double most = value(0);
  for (std::size_t k = 1; k < count; ++k) {
    const double next = value(k);
    if (next > most || std::isnan(next)) most = next;
  }
  return most;
}

/// A mean of squares.
struct MeanSquare {
  double sum = 0.0;
  std::size_t count = 0;

  void add(double square) {
    sum += square;
    ++count;
  }
  double root() const { return count == 0 ? unavailable : std::sqrt(sum / static_cast<double>(count)); }
};

double square_of(Vec2 off) { return dot(off, off); }

void add_places(Errors& errors, const Trace& run, const Trace& reference, std::size_t ticks) {
  MeanSquare position, relative, player, bodies;
  for (std::size_t k = 0; k < ticks; ++k) {
    for_each_common_cord(run, reference, k, [&](std::size_t i, std::size_t j, std::size_t cord) {
      const double own_length = run.lengths[cord];
      for (std::size_t s = 0; s < Trace::stations; ++s) {
        const Vec2 off = run.places[k][i * Trace::stations + s] - reference.places[k][j * Trace::stations + s];
        position.add(square_of(off));
        relative.add(square_of(off) / (own_length * own_length));
      }
    });
    player.add(square_of(run.player[k] - reference.player[k]));
    for (std::size_t b = 0; b < std::min(run.bodies[k].size(), reference.bodies[k].size()); ++b) {
      bodies.add(square_of(run.bodies[k][b] - reference.bodies[k][b]));
    }
  }
  errors.position_m = position.root();
  errors.position_relative = relative.root();
  errors.player_m = player.root();
  errors.body_m = bodies.root();
}

void add_figures(Errors& errors, std::span<const Figures> run, const Trace& reference) {
  const std::vector<Figures>& others = reference.figures;
  const double tension = greatest(run.size(), [&](std::size_t k) { return run[k].tension; });
  const double own = greatest(run.size(), [&](std::size_t k) { return others[k].tension; });
  if (own > 0.0) errors.tension = std::abs(tension - own) / own;
  errors.penetration = greatest(run.size(), [&](std::size_t k) { return run[k].penetration; });

  if (reference.lengths.empty()) return;
  const double longest = peak(reference.lengths);
  const double speed = std::sqrt(reference.gravity * longest);
  if (!(reference.mass * speed > 0.0)) return;
  errors.energy = greatest(run.size(), [&](std::size_t k) { return std::abs(run[k].energy - others[k].energy); }) /
                  (reference.mass * speed * speed);
  errors.momentum = greatest(run.size(), [&](std::size_t k) { return length(run[k].momentum - others[k].momentum); }) /
                    (reference.mass * speed);
}

}  // namespace

double Errors::greatest_length() const {
  double most = 0.0;
  for (const double error : {position_m, player_m, body_m}) {
    if (error > most) most = error;
  }
  return most;
}

Errors difference(const Trace& run, const Trace& reference, std::size_t ticks) {
  ticks = std::min({ticks, run.places.size(), reference.places.size()});
  Errors errors;
  if (ticks == 0) return errors;
  add_places(errors, run, reference, ticks);
  errors.stretch =
      std::abs(peak(std::span(run.stretch).first(ticks)) - peak(std::span(reference.stretch).first(ticks)));
  const std::size_t known = std::min({ticks, run.figures.size(), reference.figures.size()});
  if (known > 0) add_figures(errors, std::span(run.figures).first(known), reference);
  return errors;
}

bool agree(const Trace& a, const Trace& b, std::size_t tick, double most) {
  if (!(length(a.player[tick] - b.player[tick]) <= most)) return false;
  for (std::size_t k = 0; k < std::min(a.bodies[tick].size(), b.bodies[tick].size()); ++k) {
    if (!(length(a.bodies[tick][k] - b.bodies[tick][k]) <= most)) return false;
  }
  bool all = true;
  for_each_common_cord(a, b, tick, [&](std::size_t i, std::size_t j, std::size_t) {
    for (std::size_t s = 0; s < Trace::stations; ++s) {
      const Vec2 off = a.places[tick][i * Trace::stations + s] - b.places[tick][j * Trace::stations + s];
      all = all && length(off) <= most;
    }
  });
  return all;
}

std::size_t agreeing_ticks(const Trace& a, const Trace& b, double most) {
  const std::size_t ticks = std::min(a.places.size(), b.places.size());
  for (std::size_t k = 0; k < ticks; ++k) {
    if (!agree(a, b, k, most)) return k;
  }
  return ticks;
}

}  // namespace study
