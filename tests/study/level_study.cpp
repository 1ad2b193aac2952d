#include "tests/study/level_study.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "engine/replay/replay.h"
#include "game/simulation/run_header.h"
#include "ribbon/study/conditions.h"
#include "tests/study/chain_mover.h"
#include "tests/study/cord_search.h"
#include "tests/study/level_grid.h"
#include "tests/study/other_player.h"
#include "tests/study/results.h"
#include "tests/study/text.h"
#include "tests/tradeoff/measure.h"

namespace study {

using ribbon::study::resolution_per_agreement;

namespace {

constexpr double finer_mesh = 4.0;
constexpr std::size_t many_windows = 20;
constexpr std::size_t few_windows = 8;

/// Work done and remaining, in substeps times points.
class Progress {
 public:
  Progress(const StudyOptions& options, double all) : options_(&options), all_(all) {}
  /// There is more to do than was known.
  void expect(double work) { all_ += work; }
  void add(double work) {
    done_ += work;
    if (!options_->progress) return;
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    const double share = std::min(1.0, done_ / all_);
    options_->progress(share, share > 0.0 ? seconds * (1.0 - share) / share : 0.0);
  }

 private:
  const StudyOptions* options_;
  double all_;
  double done_ = 0.0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

Method method_of(const Setting& setting) { return is_box2d(setting) ? chain_method(setting) : Method{}; }

struct Converged {
  Trace trace;
  Reference about;
};

class LevelStudy {
 public:
  LevelStudy(const LevelFile& file, std::vector<engine::TickInput> inputs, const StudyOptions& options,
             Results& results)
      : file_(&file),
        results_(&results),
        options_(&options),
        inputs_(std::move(inputs)),
        own_(run_of_own_cords()),
        no_chains_reason_(options.grid.empty() ? chains_unsupported_reason(file.level(), inputs_, own_)
                                               : "the grid does not have them"),
        grid_(grid_of(options, file, no_chains_reason_.empty())),
        progress_(options, all_work()) {}

  Study run() {
    Study study = measure_all();
    study.runs = runs_;
    return study;
  }

 private:
  Study measure_all() {
    Study study;
    study.ticks = inputs_.size();
    study.no_chains_reason = no_chains_reason_;
    study.left_out = grid_.left_out;
    for (const Mesh& mesh : meshes_of(grid_.settings)) {
      if (!find_reference(mesh)) return study;
      study.references.push_back(converged_[mesh].about);
    }
    if (stopped()) return study;
    const Trace fine = finest_run();
    const game::Level original = file_->level();
    const Windows windows(original, inputs_, accuracy_of(reference({}, false, options_->quick)),
                          accuracy_of(reference({}, true, options_->quick)), number_of_windows());
    progress_.add(work_of_windows());
    if (!add_others()) return study;
    if (options_->films) {
      study.stage = stage_of(original, converged_[Mesh{}].trace);
      study.converged_film = frames_of(converged_[Mesh{}].trace, study.stage);
    }
    study.windows = windows.count();
    study.others = options_->others.size();
    study.agreement = windows.agreement();
    study.compared_cords = windows.compared_cords();
    study.compared_players = windows.compared_players();
    std::vector<Setting> settings = grid_.settings;
    for (std::size_t k = 0; k < settings.size(); ++k) {
      if (stopped()) return study;
      const Setting setting = settings[k];
      study.settings.push_back(measured_error(setting, fine, windows));
      if (options_->films) study.films.push_back(film_of(setting, study.stage));
      if (needs_ample_work(study.settings.back())) {
        settings.push_back(with_ample_work(setting));
        progress_.expect((1.0 + options_->repeats) * work_of(settings.back()));
      }
      progress_.add(work_of(setting));
    }
    study.complete = time(study.settings);
    if (study.complete && options_->by_cord_error_m) find_by_cord(study, windows);
    study.complete = study.complete && !stopped();
    return study;
  }

  bool needs_ample_work(const Measured& measured) const {
    return options_->ample_budgets && mesh_of(measured.setting) == Mesh{} && spends_budget(measured) &&
           with_ample_work(measured.setting) != measured.setting;
  }

  /// The run of the finest mesh; empty if no setting has another mesh than the level's own.
  Trace finest_run() {
    const Setting finest = reference({finer_mesh}, false, options_->quick);
    const bool has_other_meshes = std::any_of(grid_.settings.begin(), grid_.settings.end(),
                                              [](const Setting& setting) { return mesh_of(setting) != Mesh{}; });
    const bool has_finer = options_->grid.empty() && has_other_meshes && file_->left_out_reason(finest).empty();
    Trace run = has_finer ? whole_run(finest, end_of_comparison()) : Trace{};
    progress_.add(work_of(finest));
    return run;
  }

  /// Returns the stored result, or else measures and stores it.
  Measured measured_error(const Setting& setting, const Trace& fine, const Windows& windows) {
    if (const Measured* known = results_->find(setting)) {
      last_ = {};  // its film is that of the saved run
      return *known;
    }
    Measured measured = measure_error(setting, fine, windows);
    results_->add(measured);
    return measured;
  }

  /// The ticks after which no run is compared with that of the finest mesh.
  AccuracyChange end_of_comparison() const {
    std::size_t ticks = 0;
    for (const auto& [mesh, converged] : converged_) ticks = std::max(ticks, converged.about.ticks);
    return {ticks, accuracy_of(probe({finer_mesh}))};
  }

  double all_work() const {
    double sum = work_of(reference({finer_mesh}, false, options_->quick)) + work_of_windows();
    for (const Mesh& mesh : meshes_of(grid_.settings)) {
      sum += work_of(reference(mesh, false, options_->quick)) + work_of(reference(mesh, true, options_->quick)) +
             2.0 * work_of(probe(mesh));
    }
    for (const Setting& setting : grid_.settings) sum += (1.0 + options_->repeats) * work_of(setting);
    for (const Inputs& inputs : options_->others) sum += work_of_other(inputs);
    return sum;
  }

  std::size_t number_of_windows() const {
    if (options_->windows > 0) return options_->windows;
    return options_->quick ? few_windows : many_windows;
  }

  double work_of_windows() const {
    return work_of(reference({}, false, options_->quick)) + work_of(reference({}, true, options_->quick));
  }

  /// Returns false if it was stopped. Without a setting that is not known yet, none is needed.
  bool add_others() {
    const bool all_known = std::all_of(grid_.settings.begin(), grid_.settings.end(),
                                       [this](const Setting& setting) { return results_->find(setting) != nullptr; });
    for (const Inputs& inputs : options_->others) {
      if (stopped()) return false;
      if (!all_known || options_->by_cord_error_m)
        others_.push_back(std::make_unique<OtherPlayer>(*file_, inputs, *options_));
      progress_.add(work_of_other(inputs));
    }
    return true;
  }

  double work_of_other(const Inputs& inputs) const {
    return 2.0 * work_of_windows() * static_cast<double>(inputs.size()) / static_cast<double>(inputs_.size());
  }

  bool stopped() const { return options_->stopped && options_->stopped(); }

  /// Runs all ticks; returns the saved run if the folder has one.
  Trace whole_run(const Setting& setting, const std::optional<AccuracyChange>& change = {}) {
    if (std::optional<Trace> known = results_->run(name_of(setting))) return *known;
    Trace trace = run_once(file_->with(setting), {}, change);
    results_->add_run(name_of(setting), trace);
    return trace;
  }

  /// Runs both (see run_converged); returns the saved runs if the folder has them.
  std::pair<Trace, Trace> converged_runs(const Setting& first, const Setting& second, const AccuracyChange& change) {
    std::optional<Trace> known_first = results_->run(name_of(first));
    std::optional<Trace> known_second = results_->run(name_of(second));
    if (known_first && known_second) return {std::move(*known_first), std::move(*known_second)};
    runs_ += 2;
    std::pair<Trace, Trace> runs = run_converged(file_->with(first), file_->with(second), inputs_, change);
    results_->add_run(name_of(first), runs.first);
    results_->add_run(name_of(second), runs.second);
    return runs;
  }

  /// The same for probes (see run_probes).
  std::pair<Trace, Trace> probes(const Setting& moderate) {
    const std::string left = name_of(moderate) + " left", right = name_of(moderate) + " right";
    std::optional<Trace> known_left = results_->run(left);
    std::optional<Trace> known_right = results_->run(right);
    if (known_left && known_right) return {std::move(*known_left), std::move(*known_right)};
    runs_ += 2;
    std::pair<Trace, Trace> runs = run_probes(file_->with(moderate), inputs_);
    results_->add_run(left, runs.first);
    results_->add_run(right, runs.second);
    return runs;
  }

  /// Throws engine::MapError if there is nothing to study.
  Trace run_of_own_cords() {
    Trace own = whole_run(present());
    if (own.has_cords()) return own;
    throw engine::MapError(file_->path() +
                           ": there is nothing to study: no cord exists in any tick of the recording, as the map has "
                           "none and no line arrives; accepted is a level with a cord, a ribbon or a thrown line");
  }

  Trace run_once(const game::Level& level, const Method& method = {},
                 const std::optional<AccuracyChange>& change = {}) {
    ++runs_;
    return study::run(level, inputs_, method, change);
  }

  bool find_reference(const Mesh& mesh) {
    const Setting first = reference(mesh, false, options_->quick);
    const Setting second = reference(mesh, true, options_->quick);
    if (stopped()) return false;
    const Setting moderate = probe(mesh);
    const auto [left, right] = probes(moderate);
    progress_.add(2.0 * work_of(moderate));
    if (stopped()) return false;
    const AccuracyChange change = end_of_reference(mesh, left, right);
    Converged converged;
    auto [other, finer] = converged_runs(first, second, change);
    converged.trace = std::move(finer);
    progress_.add(work_of(first) + work_of(second));
    converged.about = reference_of(mesh, {converged.trace, other, left, right});
    converged_[mesh] = std::move(converged);
    return true;
  }

  /// The film of a measured setting.
  Film film_of(const Setting& setting, const Stage& stage) {
    if (mesh_of(setting) != Mesh{}) return {};
    const std::optional<Trace> saved = is_present(setting) ? own_ : results_->run(run_name_of(setting));
    const bool is_last = !last_.places.empty();
    const Trace trace = saved     ? *saved
                        : is_last ? std::exchange(last_, {})
                                  : run_once(file_->with(setting), method_of(setting));  // its file is gone
    const Converged& own = converged_[Mesh{}];
    return {frames_of(trace, stage), greatest_error(trace, own.trace, own.about.ticks)};
  }

  static std::string run_name_of(const Setting& setting) { return setting.solver + " " + name_of(setting); }

  Measured measure_error(const Setting& setting, const Trace& fine, const Windows& windows) {
    const Converged& own = converged_[mesh_of(setting)];
    last_ = is_present(setting) ? own_ : run_once(file_->with(setting), method_of(setting));
    const Trace& trace = last_;
    if (options_->films && !is_present(setting)) results_->add_run(run_name_of(setting), trace);
    Measured measured;
    measured.setting = setting;
    measured.error = difference(trace, own.trace, own.about.ticks);
    measured.mesh = difference(own.trace, fine, own.about.ticks);  // none without a finer mesh
    measured.chaotic = difference(statistics(trace, own.about.ticks), statistics(own.trace, own.about.ticks));
    measured.resolution_m = resolution_per_agreement * own.about.agreement_m;
    if (setting.solver == "direct" && mesh_of(setting) == Mesh{}) {
      for (const auto& other : others_) other->judge(setting, measured.others);
      measured.windows = windows.errors(window_accuracy_of(setting));
      measured.windows_resolution_m = resolution_per_agreement * windows.agreement().greatest();
    }
    measured.work = trace.work;
    if (setting.solver == "direct") measured.tick_work = figures_of(trace.tick_work);
    measured.contacts = trace.contacts;
    measured.unconverged_ticks = trace.unconverged_ticks;
    measured.failure = failure_of(trace, own.trace, own.about.ticks);
    if (measured.failure.empty()) measured.failure = measured.windows.failure;
    return measured;
  }

  /// Returns false if it was stopped; then nothing is timed.
  bool time(std::vector<Measured>& settings) {
    std::vector<game::Level> levels;
    levels.reserve(settings.size());
    std::vector<tradeoff::Timed> timed;
    double round = 0.0;
    for (const Measured& measured : settings) {
      const game::Level& level = levels.emplace_back(file_->with(measured.setting));
      timed.push_back(timed_run(level, inputs_, method_of(measured.setting)));
      round += work_of(measured.setting);
    }
    if (stopped()) return false;
    const auto timings = tradeoff::interleaved_timings(timed, static_cast<int>(inputs_.size()), options_->repeats,
                                                       [&](double) { progress_.add(round); });
    for (std::size_t k = 0; k < settings.size(); ++k) {
      const bool shows = is_box2d(settings[k].setting);
      settings[k].cost_us = shows ? timings[k].share_us : timings[k].median_us;
      settings[k].least_us = timings[k].least_us;
      settings[k].p99_us = shows ? timings[k].share_p99_us : timings[k].p99_us;
      settings[k].most_us = timings[k].worst_us;
    }
    return true;
  }

  /// Without several cords, or where the cheapest setting for all saves little, there is nothing to find.
  void find_by_cord(Study& study, const Windows& windows) {
    const game::Level level = file_->level();
    const double error = usable_error_share * *options_->by_cord_error_m;
    const std::optional<CordSearch> search = search_of(study, error, cord_objects_of(level));
    if (!search) return;
    const std::size_t most = search->cords.size() * (2 * search->cheaper.size() + 1) + 1;
    std::size_t tried = 0;
    const CordSearchResult result = study::find_by_cord(*search, [&](const CordSettings& settings) {
      if (stopped()) return Outcome{0.0, 0.0, "interrupted"};
      Outcome outcome = judge(settings, windows, accuracies_of(level, settings));
      if (options_->by_cord_progress)
        options_->by_cord_progress(static_cast<double>(++tried) / static_cast<double>(most));
      return outcome;
    });
    if (options_->by_cord_progress) options_->by_cord_progress(1.0);
    study.least_work_by_cord = result.least_work;
    if (result.found && result.found->outcome.work < least_work_within(study, error)) study.by_cord = result.found;
  }

  Outcome judge(const CordSettings& settings, const Windows& windows, const Windows::CordAccuracies& by_cord) {
    const Converged& own = converged_[Mesh{}];
    const Trace trace = run_once(file_->with(settings));
    WithOthers others;
    for (const auto& other : others_) other->judge(settings, others);
    const WindowErrors in_windows = windows.errors(window_accuracy_of(settings.common), by_cord);
    Outcome outcome{std::max(difference(trace, own.trace, own.about.ticks).greatest_length(), in_windows.greatest()),
                    figures_of(trace.tick_work).mean, failure_of(trace, own.trace, own.about.ticks)};
    if (others.error_m > outcome.error_m) outcome.error_m = others.error_m;
    for (const std::string& failure : {in_windows.failure, others.failure}) {
      if (outcome.failure.empty()) outcome.failure = failure;
    }
    return outcome;
  }

  const LevelFile* file_;
  Results* results_;
  const StudyOptions* options_;
  std::vector<engine::TickInput> inputs_;
  int runs_ = 0;
  Trace own_;   // of the level as it is
  Trace last_;  // of the last measured setting
  std::string no_chains_reason_;
  LevelGrid grid_;
  Progress progress_;
  std::map<Mesh, Converged> converged_;
  std::vector<std::unique_ptr<OtherPlayer>> others_;
};

}  // namespace

Study measure(const LevelFile& file, const std::string& replay_path, const StudyOptions& options) {
  const engine::Replay replay = engine::load_replay(replay_path);
  const game::Level level = file.level();
  engine::check_header(replay.header, game::replay_header(level));
  if (replay.ticks.empty()) throw engine::ReplayError(replay_path + " has no ticks; a study needs one or more");
  Results results(options.folder, file.hash(), replay_path, options.quick);
  Study study = LevelStudy(file, inputs_of(replay), options, results).run();
  study.level = level.name;
  study.replay = replay_path;
  return study;
}

Study measure(const LevelFile& file, const std::vector<engine::TickInput>& inputs, const StudyOptions& options) {
  Results nowhere("", file.hash(), "", options.quick);
  Study study = LevelStudy(file, inputs, options, nowhere).run();
  study.level = file.level().name;
  return study;
}

}  // namespace study
