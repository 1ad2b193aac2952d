#include "tests/study/trace.h"

#include <algorithm>
#include <cmath>

namespace study {
namespace {

using ribbon::Vec2;

constexpr double furthest = 1e3;  // m, from the origin

double length_of(const std::vector<Vec2>& line) {
  double sum = 0.0;
  for (std::size_t k = 1; k < line.size(); ++k) sum += length(line[k] - line[k - 1]);
  return sum;
}

/// Evenly by the columns, which are evenly along the cord at rest.
void add_stations(const std::vector<Vec2>& line, std::vector<Vec2>& places) {
  for (int s = 0; s < Trace::stations; ++s) {
    const double along = static_cast<double>(line.size() - 1) * s / (Trace::stations - 1);
    const std::size_t k = std::min(static_cast<std::size_t>(along), line.size() - 2);
    const double share = along - static_cast<double>(k);
    places.push_back(line[k] + share * (line[k + 1] - line[k]));
  }
}

bool is_somewhere(Vec2 place) { return std::abs(place.x) <= furthest && std::abs(place.y) <= furthest; }

}  // namespace

std::vector<Vec2> middle_line(const engine::Coupling& coupling, engine::CordIndex cord) {
  const auto shape = coupling.shape(cord);
  const auto x = coupling.positions(cord);
  const auto rows = static_cast<std::size_t>(shape.rows);
  std::vector<Vec2> line;
  for (std::size_t p = 0; p + rows <= x.size(); p += rows) line.push_back(0.5 * (x[p] + x[p + rows - 1]));
  return line;
}

std::vector<engine::TickInput> inputs_of(const engine::Replay& replay) {
  std::vector<engine::TickInput> inputs;
  for (const engine::RecordedTick& tick : replay.ticks) inputs.push_back(tick.input);
  return inputs;
}

tradeoff::Timed timed_run(const game::Level& level, std::span<const engine::TickInput> inputs, Method method) {
  const bool shows = static_cast<bool>(method.show);
  const auto run = std::make_shared<LevelRun>(level, inputs, std::move(method));
  tradeoff::Timed timed{[run] { run->reset(); }, [run] { run->tick(); }};
  if (shows) timed.rest = [run] { run->show(); };
  return timed;
}

void LevelRun::reset() {
  simulation_ = std::make_unique<game::Simulation>(*level_, method_.make_mover);
  next_ = 0;
}

void LevelRun::tick() { simulation_->tick(inputs_[next_++]); }

void LevelRun::show() const {
  if (method_.show) method_.show();
}

Trace run(const game::Level& level, std::span<const engine::TickInput> inputs, Method method) {
  Trace trace;
  LevelRun run(level, inputs, std::move(method));
  run.reset();
  const engine::Coupling* coupling = &run.simulation().scene().coupling();
  for (int c = 0; c < coupling->size(); ++c) trace.lengths.push_back(length_of(middle_line(*coupling, c)));
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    run.tick();
    run.show();
    coupling = &run.simulation().scene().coupling();
    std::vector<Vec2>& places = trace.places.emplace_back();
    double stretch = 0.0;
    bool unconverged = false;
    for (int c = 0; c < coupling->size(); ++c) {
      const std::vector<Vec2> line = middle_line(*coupling, c);
      add_stations(line, places);
      stretch = std::max(stretch, length_of(line) / trace.lengths[static_cast<std::size_t>(c)] - 1.0);
      if (coupling->solver(c) != engine::Solver::direct) continue;
      trace.work += coupling->direct_report(c);
      unconverged = unconverged || coupling->direct_report(c).unconverged > 0;
    }
    trace.unconverged_ticks += unconverged ? 1 : 0;
    trace.player.push_back(run.simulation().player().position());
    trace.stretch.push_back(stretch);
    if (!std::all_of(places.begin(), places.end(), is_somewhere)) {
      trace.failure = "blew up in tick " + std::to_string(k + 1);
      break;
    }
  }
  return trace;
}

Errors difference(const Trace& a, const Trace& b, std::size_t ticks) {
  ticks = std::min({ticks, a.places.size(), b.places.size()});
  Errors errors;
  if (ticks == 0) return errors;
  double peak_a = 0.0;
  double peak_b = 0.0;
  std::size_t count = 0;
  for (std::size_t k = 0; k < ticks; ++k) {
    for (std::size_t s = 0; s < a.places[k].size(); ++s) {
      const Vec2 off = a.places[k][s] - b.places[k][s];
      const double own_length = a.lengths[s / Trace::stations];
      errors.position_m += dot(off, off);
      errors.position_share += dot(off, off) / (own_length * own_length);
      ++count;
    }
    const Vec2 off = a.player[k] - b.player[k];
    errors.player_m += dot(off, off);
    peak_a = std::max(peak_a, a.stretch[k]);
    peak_b = std::max(peak_b, b.stretch[k]);
  }
  errors.position_m = std::sqrt(errors.position_m / static_cast<double>(count));
  errors.position_share = std::sqrt(errors.position_share / static_cast<double>(count));
  errors.player_m = std::sqrt(errors.player_m / static_cast<double>(ticks));
  errors.stretch = std::abs(peak_a - peak_b);
  return errors;
}

std::size_t ticks_together(const Trace& a, const Trace& b, double most) {
  const std::size_t ticks = std::min(a.places.size(), b.places.size());
  for (std::size_t k = 0; k < ticks; ++k) {
    if (!(length(a.player[k] - b.player[k]) <= most)) return k;
    for (std::size_t s = 0; s < a.places[k].size(); ++s) {
      if (!(length(a.places[k][s] - b.places[k][s]) <= most)) return k;
    }
  }
  return ticks;
}

}  // namespace study
