#include "tests/study/reference.h"

#include <algorithm>

#include "ribbon/study/conditions.h"
#include "tests/study/errors.h"
#include "tests/study/text.h"
#include "tests/study/tunnelling.h"

namespace study {

Reference reference_of(const Mesh& mesh, const ReferenceRuns& runs) {
  Reference about;
  about.mesh = mesh;
  about.ticks = std::min(agreeing_ticks(runs.left, runs.right, ribbon::study::max_probe_difference),
                         agreeing_ticks(runs.other, runs.finer, ribbon::study::max_reference_difference));
  about.chaotic = difference(statistics(runs.finer, about.ticks), statistics(runs.other, about.ticks));
  about.unconverged_ticks = runs.finer.unconverged_ticks;
  about.posed = runs.finer.work.posed;
  about.agreement_m = difference(runs.finer, runs.other, about.ticks).greatest_length();
  return about;
}

namespace {

/// Returns false if one of the runs ended before.
bool agree_in(const Trace& a, const Trace& b, std::size_t tick, double most) {
  return tick < std::min(a.places.size(), b.places.size()) && agree(a, b, tick, most);
}

}  // namespace

std::pair<Trace, Trace> run_probes(const game::Level& moderate, std::span<const engine::TickInput> inputs) {
  const Method own;
  RecordedRun left(moderate, inputs, own);
  RecordedRun right(moderate, inputs, own);
  left.kick(-ribbon::study::probe_kick);
  right.kick(ribbon::study::probe_kick);
  for (std::size_t k = 0; !left.has_ended() && !right.has_ended(); ++k) {
    left.tick(nullptr);
    right.tick(nullptr);
    if (!agree_in(left.trace(), right.trace(), k, ribbon::study::max_probe_difference)) break;
  }
  return {left.take_trace(), right.take_trace()};
}

std::pair<Trace, Trace> run_converged(const game::Level& first, const game::Level& second, const Inputs& inputs,
                                      const AccuracyChange& change, GoesOn goes_on) {
  const Method own;
  RecordedRun a(first, inputs, own);
  RecordedRun b(second, inputs, own);
  bool compared = true;
  bool has_first = true;
  for (std::size_t k = 0; (has_first && !a.has_ended()) || !b.has_ended(); ++k) {
    compared = compared && k < change.tick &&
               (k == 0 || agree_in(a.trace(), b.trace(), k - 1, ribbon::study::max_reference_difference));
    has_first = compared || goes_on == GoesOn::both;
    const ribbon::Accuracy* accuracy = compared ? nullptr : &change.accuracy;
    if (has_first) a.tick(accuracy);
    b.tick(accuracy);
  }
  return {a.take_trace(), b.take_trace()};
}

AccuracyChange end_of_reference(const Mesh& mesh, const Trace& left, const Trace& right) {
  return {agreeing_ticks(left, right, ribbon::study::max_probe_difference), accuracy_of(probe(mesh))};
}

std::string failure_of(const Trace& run, const Trace& reference, std::size_t ticks) {
  if (!run.failure.empty()) return run.failure;
  std::string tunnelling = tunnelling_failure(run.crossings, reference.crossings, reference.declared, ticks);
  if (!tunnelling.empty()) return tunnelling;
  return run.unconverged_ticks == 0 ? "" : count_of(run.unconverged_ticks, "tick") + " not converged";
}

}  // namespace study
