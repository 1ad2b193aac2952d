#include "tests/study/trace.h"

#include <algorithm>
#include <cmath>

namespace study {
namespace {

using ribbon::Vec2;

constexpr double max_coordinate = 1e3;  // m, from the origin

double length_of(const std::vector<Vec2>& line) {
  double sum = 0.0;
  for (std::size_t k = 1; k < line.size(); ++k) sum += length(line[k] - line[k - 1]);
  return sum;
}

/// Adds evenly spaced places. The columns are evenly spaced on the cord at rest.
void add_stations(const std::vector<Vec2>& line, std::vector<Vec2>& places) {
  for (int s = 0; s < Trace::stations; ++s) {
    const double along = static_cast<double>(line.size() - 1) * s / (Trace::stations - 1);
    const std::size_t k = std::min(static_cast<std::size_t>(along), line.size() - 2);
    const double share = along - static_cast<double>(k);
    places.push_back(line[k] + share * (line[k + 1] - line[k]));
  }
}

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

void add_places(Errors& errors, const Trace& run, const Trace& reference, std::size_t ticks) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < ticks; ++k) {
    const std::size_t places = std::min(run.places[k].size(), reference.places[k].size());  // fewer after a cut
    for (std::size_t s = 0; s < places; ++s) {
      const Vec2 off = run.places[k][s] - reference.places[k][s];
      const double own_length = run.lengths[s / Trace::stations];
      errors.position_m += dot(off, off);
      errors.position_relative += dot(off, off) / (own_length * own_length);
      ++count;
    }
    const Vec2 off = run.player[k] - reference.player[k];
    errors.player_m += dot(off, off);
  }
  errors.position_m = std::sqrt(errors.position_m / static_cast<double>(count));
  errors.position_relative = std::sqrt(errors.position_relative / static_cast<double>(count));
  errors.player_m = std::sqrt(errors.player_m / static_cast<double>(ticks));
}

void add_figures(Errors& errors, std::span<const Figures> run, const Trace& reference) {
  const std::vector<Figures>& others = reference.figures;
  const double tension = greatest(run.size(), [&](std::size_t k) { return run[k].tension; });
  const double own = greatest(run.size(), [&](std::size_t k) { return others[k].tension; });
  if (own > 0.0) errors.tension = std::abs(tension - own) / own;
  errors.penetration = greatest(run.size(), [&](std::size_t k) { return run[k].penetration; });

  const double longest = *std::max_element(reference.lengths.begin(), reference.lengths.end());
  const double speed = std::sqrt(reference.gravity * longest);
  if (!(reference.mass * speed > 0.0)) return;
  errors.energy = greatest(run.size(), [&](std::size_t k) { return std::abs(run[k].energy - others[k].energy); }) /
                  (reference.mass * speed * speed);
  errors.momentum = greatest(run.size(), [&](std::size_t k) { return length(run[k].momentum - others[k].momentum); }) /
                    (reference.mass * speed);
}

/// The filter of game::Level's cords, which do not collide with players, nor with a substitute for the cords.
b2Filter cord_filter(const Method& method) {
  b2Filter filter;
  filter.maskBits = static_cast<std::uint16_t>(~(game::player_category | method.categories));
  return filter;
}

/// Removes the figures that need more than positions, for cords that a substitute moves.
Figures figures_of(const engine::Scene& scene, const Method& method) {
  Figures figures = study::figures_of(scene.world(), scene.coupling(), cord_filter(method));
  if (!method.make_mover) return figures;
  figures.tension = figures.energy = figures.kinetic = unavailable;
  figures.momentum = {unavailable, unavailable};
  return figures;
}

void add_tick(Trace& trace, const game::Simulation& simulation, const Method& method) {
  const ribbon::box2d::Coupling& coupling = simulation.scene().coupling();
  std::vector<Vec2>& places = trace.places.emplace_back();
  Figures& figures = trace.figures.emplace_back(figures_of(simulation.scene(), method));
  double& max_stretch = trace.stretch.emplace_back(0.0);
  bool unconverged = false;
  for (const ribbon::box2d::CordId c : coupling.cords()) {
    if (static_cast<std::size_t>(c) >= trace.lengths.size()) continue;  // a piece of one that was cut
    const std::vector<Vec2> line = middle_line(coupling, c);
    add_stations(line, places);
    const double stretch = length_of(line) / trace.lengths[static_cast<std::size_t>(c)] - 1.0;
    max_stretch = std::max(max_stretch, stretch);
    figures.stretch += stretch / coupling.size();
    if (coupling.cord(c).solver() != ribbon::box2d::Solver::direct) continue;
    trace.work += coupling.cord(c).island_report();
    trace.contacts += static_cast<int>(coupling.cord(c).direct().touches().size());
    unconverged = unconverged || coupling.cord(c).island_report().unconverged > 0;
  }
  trace.unconverged_ticks += unconverged ? 1 : 0;
  trace.player.push_back(simulation.player().position());
}

/// A run at its start.
Trace trace_of(const engine::Scene& start) {
  Trace trace;
  for (int c = 0; c < start.coupling().size(); ++c) {
    trace.lengths.push_back(length_of(middle_line(start.coupling(), c)));
  }
  trace.declared = declared_contacts(start.coupling());
  trace.mass = mass_of(start.world(), start.coupling());
  trace.gravity = static_cast<double>(start.world().GetGravity().Length());
  return trace;
}

bool is_in_bounds(Vec2 place) { return std::abs(place.x) <= max_coordinate && std::abs(place.y) <= max_coordinate; }

}  // namespace

std::vector<Vec2> middle_line(const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord) {
  const auto shape = coupling.cord(cord).shape();
  const auto x = coupling.cord(cord).positions();
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

Trace run(const game::Level& level, std::span<const engine::TickInput> inputs, const Method& method) {
  LevelRun run(level, inputs, method);
  run.reset();
  Trace trace = trace_of(run.simulation().scene());
  TunnellingDetector watch;
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    run.tick();
    run.show();
    add_tick(trace, run.simulation(), method);
    if (run.simulation().run_ticks() == 1) watch.reset();  // after a restart
    const engine::Scene& now = run.simulation().scene();
    trace.crossings.push_back(watch.detect(now.world(), now.coupling(), cord_filter(method)));
    if (!std::all_of(trace.places.back().begin(), trace.places.back().end(), is_in_bounds)) {
      trace.failure = "blew up in tick " + std::to_string(k + 1);
      break;
    }
  }
  return trace;
}

Trace run_from(const game::Level& level, std::span<const engine::TickInput> inputs, std::size_t begin,
               std::size_t ticks, const ribbon::Accuracy& accuracy) {
  LevelRun run(level, inputs);
  run.reset();
  Trace trace = trace_of(run.simulation().scene());
  for (std::size_t k = 0; k < begin; ++k) run.tick();
  for (std::size_t k = begin; k < std::min(begin + ticks, inputs.size()); ++k) {
    ribbon::box2d::Coupling& coupling = run.simulation().scene().coupling();
    for (const ribbon::box2d::CordId c : coupling.cords()) {
      if (coupling.cord(c).solver() == ribbon::box2d::Solver::direct) coupling.cord(c).direct().set_accuracy(accuracy);
    }
    run.tick();
    add_tick(trace, run.simulation(), {});
  }
  return trace;
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

std::size_t agreeing_ticks(const Trace& a, const Trace& b, double most) {
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
