#include "tests/study/trace.h"

#include <algorithm>
#include <cmath>

#include "ribbon/box2d/convert.h"
#include "ribbon/study/conditions.h"
#include "ribbon/study/motion.h"

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

double rest_length_of(const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId id,
                      const std::vector<Vec2>& line) {
  if (coupling.cord(id).solver() != ribbon::box2d::Solver::direct) return length_of(line);
  const ribbon::Cord& cord = coupling.cord(id).direct();
  double sum = 0.0;
  for (int link = 0; link + 1 < cord.def().points; ++link) sum += cord.rest_length(link);
  return sum;
}

/// Writes down a run tick by tick.
class Recorder {
 public:
  /// `start` is the run before its first tick.
  Recorder(const engine::Scene& start, const Method& method) : method_(&method) {
    add_new_cords(start.coupling());
    trace_.mass = mass_of(start.world(), start.coupling());
    trace_.gravity = static_cast<double>(start.world().GetGravity().Length());
  }

  void add(const game::Simulation& simulation) {
    const ribbon::box2d::Coupling& coupling = simulation.scene().coupling();
    add_new_cords(coupling);
    trace_.cords.emplace_back();
    trace_.places.emplace_back();
    trace_.stretch.push_back(0.0);
    trace_.figures.push_back(figures_of(simulation.scene(), *method_));
    bool unconverged = false;
    for (const ribbon::box2d::CordId c : coupling.cords()) unconverged = add_cord(coupling, c) || unconverged;
    trace_.unconverged_ticks += unconverged ? 1 : 0;
    trace_.work += coupling.last_step().report();  // an island counts once, however many cords it has
    trace_.tick_work.push_back(coupling.last_step().report().work);
    add_bodies(simulation);
  }

  Trace& trace() { return trace_; }

 private:
  void add_new_cords(const ribbon::box2d::Coupling& coupling) {
    for (const ribbon::box2d::CordId c : coupling.cords()) {
      const auto k = static_cast<std::size_t>(c);
      if (k < trace_.lengths.size() && trace_.lengths[k] > 0.0) continue;
      if (k >= trace_.lengths.size()) {
        trace_.lengths.resize(k + 1, 0.0);
        trace_.declared.resize(k + 1, 0);
        versions_.resize(k + 1, 0);
        columns_.resize(k + 1, 0);
      }
      const std::vector<Vec2> line = middle_line(coupling, c);
      const double rest = rest_length_of(coupling, c, line);
      trace_.lengths[k] = rest > 0.0 ? rest : length_of(line);
      trace_.declared[k] = declared_contacts(coupling, c);
      columns_[k] = coupling.cord(c).shape().columns;
    }
  }

  /// Returns whether its solve did not converge.
  bool add_cord(const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId c) {
    const auto k = static_cast<std::size_t>(c);
    if (columns_[k] != coupling.cord(c).shape().columns) {
      columns_[k] = coupling.cord(c).shape().columns;
      ++versions_[k];
    }
    trace_.cords.back().push_back({c, versions_[k]});
    const std::vector<Vec2> line = middle_line(coupling, c);
    add_stations(line, trace_.places.back());
    const bool is_direct = coupling.cord(c).solver() == ribbon::box2d::Solver::direct;
    const double rest = is_direct ? rest_length_of(coupling, c, line) : trace_.lengths[k];
    const double stretch = length_of(line) / rest - 1.0;
    trace_.stretch.back() = std::max(trace_.stretch.back(), stretch);
    trace_.figures.back().stretch += stretch / coupling.size();
    if (!is_direct) return false;
    trace_.contacts += static_cast<int>(coupling.cord(c).direct().touches().size());
    return coupling.cord(c).island_report().unconverged > 0;
  }

  void add_bodies(const game::Simulation& simulation) {
    trace_.player.push_back(simulation.player().position());
    std::vector<Vec2>& bodies = trace_.bodies.emplace_back();
    if (simulation.players() > 1) bodies.push_back(simulation.player(1).position());
    for (const engine::SceneBody& made : simulation.scene().bodies()) {
      if (made.body->GetType() == b2_dynamicBody) bodies.push_back(ribbon::box2d::to_double(made.body->GetPosition()));
    }
  }

  const Method* method_;
  Trace trace_;
  std::vector<int> versions_;  // by cord
  std::vector<int> columns_;   // by cord, in the last tick
};

bool is_in_bounds(Vec2 place) { return std::abs(place.x) <= max_coordinate && std::abs(place.y) <= max_coordinate; }

/// Returns what is wrong in the last tick, the `number`-th of the input; empty if nothing is.
std::string blow_up_of(const Trace& trace, std::size_t number) {
  const std::vector<Vec2>& places = trace.places.back();
  if (std::all_of(places.begin(), places.end(), is_in_bounds) && is_in_bounds(trace.player.back())) return {};
  return "blew up in tick " + std::to_string(number);
}

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

bool Trace::has_cords() const {
  return std::any_of(cords.begin(), cords.end(), [](const auto& present) { return !present.empty(); });
}

struct RecordedRun::Parts {
  Parts(const game::Level& level, std::span<const engine::TickInput> inputs, const Method& how)
      : run(level, inputs, how), ticks(inputs.size()), method(&how) {
    run.reset();
  }

  LevelRun run;
  std::size_t ticks;
  const Method* method;
  std::optional<Recorder> recorder{};
  TunnellingDetector watch{};
  ribbon::study::Accuracies accuracies{};
};

RecordedRun::RecordedRun(const game::Level& level, std::span<const engine::TickInput> inputs, const Method& method)
    : parts_(std::make_unique<Parts>(level, inputs, method)) {
  parts_->recorder.emplace(parts_->run.simulation().scene(), method);
}

RecordedRun::~RecordedRun() = default;

bool RecordedRun::has_ended() const { return trace().places.size() == parts_->ticks || !trace().failure.empty(); }

const Trace& RecordedRun::trace() const { return parts_->recorder->trace(); }

Trace RecordedRun::take_trace() { return std::move(parts_->recorder->trace()); }

void RecordedRun::kick(double speed) {
  engine::Scene& now = parts_->run.simulation().scene();
  ribbon::study::kick(now.world(), now.coupling(), speed);
}

void RecordedRun::tick(const ribbon::Accuracy* accuracy) {
  if (has_ended()) return;
  LevelRun& run = parts_->run;
  if (accuracy != nullptr) parts_->accuracies.set(run.simulation().scene().coupling(), *accuracy);
  run.tick();
  run.show();
  parts_->recorder->add(run.simulation());
  Trace& trace = parts_->recorder->trace();
  if (run.simulation().run_ticks() == 1) parts_->watch.reset();  // after a restart
  const engine::Scene& now = run.simulation().scene();
  trace.crossings.push_back(parts_->watch.detect(now.world(), now.coupling(), cord_filter(*parts_->method)));
  trace.failure = blow_up_of(trace, trace.places.size());
}

Trace run(const game::Level& level, std::span<const engine::TickInput> inputs, const Method& method,
          const std::optional<AccuracyChange>& change) {
  RecordedRun run(level, inputs, method);
  for (std::size_t k = 0; !run.has_ended(); ++k) run.tick(change && k >= change->tick ? &change->accuracy : nullptr);
  return run.take_trace();
}

StartedRun::StartedRun(const game::Level& level, std::span<const engine::TickInput> inputs, std::size_t begin,
                       std::size_t lead_in)
    : run_(level, inputs), inputs_(inputs), begin_(begin) {
  run_.reset();
  for (std::size_t k = 0; k < begin; ++k) {
    if (k + lead_in >= begin) accuracies_.set(run_.simulation().scene().coupling(), ribbon::study::lead_in_accuracy);
    run_.tick();
  }
}

Trace StartedRun::finish(std::size_t ticks, const PartSetting& setting, const Ends& ends) {
  const Method own;
  engine::Scene& scene = run_.simulation().scene();
  Recorder recorder(scene, own);
  if (setting.kick != 0.0) ribbon::study::kick(scene.world(), scene.coupling(), setting.kick);
  for (std::size_t k = begin_; k < std::min(begin_ + ticks, inputs_.size()); ++k) {
    accuracies_.set(run_.simulation().scene().coupling(), setting.accuracy, setting.by_cord);
    run_.tick();
    recorder.add(run_.simulation());
    recorder.trace().failure = blow_up_of(recorder.trace(), k + 1);
    if (!recorder.trace().failure.empty() || (ends && ends(recorder.trace()))) break;
  }
  return std::move(recorder.trace());
}

Trace run_part(const game::Level& level, std::span<const engine::TickInput> inputs, const Part& part) {
  return StartedRun(level, inputs, part.begin, part.lead_in).finish(part.ticks, part.setting);
}

}  // namespace study
