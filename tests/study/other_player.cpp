#include "tests/study/other_player.h"

#include <algorithm>
#include <utility>

#include "ribbon/study/conditions.h"
#include "tests/study/by_cord.h"

namespace study {
namespace {

constexpr std::size_t windows = 3;  // of the two seconds that such a player has

}  // namespace

OtherPlayer::OtherPlayer(const LevelFile& file, Inputs inputs, const StudyOptions& options)
    : file_(&file),
      level_(file.level()),
      inputs_(std::move(inputs)),
      windows_(level_, inputs_, accuracy_of(reference({}, false, options.quick)),
               accuracy_of(reference({}, true, options.quick)), windows) {
  const auto [left, right] = run_probes(file.with(probe({})), inputs_);
  auto [other, converged] =
      run_converged(file.with(reference({}, false, options.quick)), file.with(reference({}, true, options.quick)),
                    inputs_, end_of_reference({}, left, right), GoesOn::second);
  converged_ = std::move(converged);
  about_ = reference_of({}, {converged_, other, left, right});
}

void OtherPlayer::judge(const CordSettings& settings, WithOthers& results) const {
  const Trace trace = study::run(file_->with(settings), inputs_);
  const WindowErrors in_windows = windows_.errors(window_accuracy_of(settings.common), accuracies_of(level_, settings));
  const double resolution =
      ribbon::study::resolution_per_agreement * std::max(about_.agreement_m, windows_.agreement().greatest());
  const double own = difference(trace, converged_, about_.ticks).greatest_length();
  const double error = std::max({own, in_windows.greatest(), resolution});
  if (!(error <= results.error_m)) results.error_m = error;  // the first one, too
  results.spends_budget = results.spends_budget || in_windows.spends_budget || trace.work.posed > 0;
  const WorkFigures work = figures_of(trace.tick_work);
  const auto add = [](double& most, double value) {
    if (!(value <= most)) most = value;
  };
  add(results.work.mean, work.mean);
  add(results.work.p99, work.p99);
  add(results.work.most, work.most);
  if (!results.failure.empty()) return;
  results.failure = failure_of(trace, converged_, about_.ticks);
  if (results.failure.empty()) results.failure = in_windows.failure;
}

}  // namespace study
