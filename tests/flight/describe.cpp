#include "tests/flight/describe.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "tests/flight/figures.h"
#include "tests/study/progress_bar.h"

namespace flight {
namespace {

constexpr double bar_after = 1.0;  // s; shorter work shows no progress bar

/// Prints the work and all other counts that are not 0.
void print_report(const std::string& what, const ribbon::IslandReport& report) {
  std::printf("%s: work %lld", what.c_str(), static_cast<long long>(report.work));
  const std::pair<const char*, int> counts[] = {{"stages", report.stages},
                                                {"iterations", report.iterations},
                                                {"searches", report.searches},
                                                {"fallbacks", report.fallbacks},
                                                {"energy gains", report.energy_gains},
                                                {"halvings", report.halvings},
                                                {"impacts", report.impacts},
                                                {"posed", report.posed},
                                                {"cuts", report.cuts},
                                                {"unlocked", report.unlocked},
                                                {"unconverged", report.unconverged}};
  for (const auto& [name, count] : counts) {
    if (count != 0) std::printf(", %s %d", name, count);
  }
  if (report.unconverged > 0) {
    std::printf(", position error %.3g m, force error %.3g N", report.position_error, report.force_error);
  }
  std::printf("\n");
}

void print_figures(const Figures& before, const Figures& after) {
  std::printf("%-28s %12s %12s\n", "seen from outside", "before", "after");
  std::printf("%-28s %12s %12s\n", "all numbers finite", before.finite ? "yes" : "no", after.finite ? "yes" : "no");
  const auto row = [](const char* what, double first, double second) {
    std::printf("%-28s %12.6g %12.6g\n", what, first, second);
  };
  row("largest link stretch, %", 1e2 * before.stretch, 1e2 * after.stretch);
  row("  of cord", before.stretched_cord, after.stretched_cord);
  row("deepest in a body, mm", 1e3 * before.penetration, 1e3 * after.penetration);
  row("  of cord", before.deep_cord, after.deep_cord);
  row("  of body", before.deep_body, after.deep_body);
  row("deepest in a cord, mm", 1e3 * before.cord_penetration, 1e3 * after.cord_penetration);
  row("widest gap of a grip, mm", 1e3 * before.grip_gap, 1e3 * after.grip_gap);
  row("fastest point, m/s", before.speed, after.speed);
  row("energy, J", before.energy, after.energy);
}

double seconds_of(Replay& replay) {
  replay.reset();
  const auto begun = std::chrono::steady_clock::now();
  replay.run();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
}

}  // namespace

void print_step(const engine::SolverStep& step) {
  std::size_t points = 0, circles = 0, segments = 0, grips = 0;
  for (const engine::SolverStep::Cord& cord : step.cords) {
    points += cord.state.positions.size();
    circles += cord.circles.size();
    segments += cord.segments.size();
    grips += cord.grips.size();
  }
  if (!step.outcome.why.empty()) std::printf("recorded for: %s\n", step.outcome.why.c_str());
  std::printf("%zu cords of %zu points, %zu bodies; near them %zu circles, %zu segments, %zu grips; dt %.6g s\n",
              step.cords.size(), points, step.bodies.size(), circles, segments, grips, step.dt);
}

void print_replay(const engine::SolverStep& step, Replay& replay) {
  const Figures before = figures_of(step, replay.cords(), replay.bodies(), false);
  replay.run();
  const Figures after = figures_of(step, replay.cords(), replay.bodies(), true);
  std::printf("to the bit as recorded: %s\n", replay.is_as_recorded() ? "yes" : "no");
  if (!replay.is_as_recorded()) {
    std::printf("  recorded: work %lld, unconverged %d\n", static_cast<long long>(step.outcome.work),
                step.outcome.unconverged);
  }
  print_figures(before, after);
  print_report("all", replay.total());
  std::printf("%d islands\n", replay.islands());
  for (std::size_t k = 0; k < replay.island_reports().size(); ++k) {
    print_report("island " + std::to_string(k), replay.island_reports()[k]);
  }
  for (std::size_t k = 0; k < replay.reports().size(); ++k) {
    const ribbon::Cord& cord = replay.cords()[k];
    const ribbon::CordReport& report = replay.reports()[k];
    std::printf("cord %zu%s, of %d x %d, island %d: contacts %d, normal force %g N, cuts %d, position error %g m\n", k,
                cord.is_asleep() ? ", asleep" : "", cord.def().points, cord.def().rows, report.island, report.contacts,
                report.max_normal_force, report.cuts, report.position_error);
  }
}

void print_profile(Replay& replay, int repeats) {
  std::vector<double> seconds;
  double spent = 0.0;
  bool shows_bar = false;
  for (int k = 0; k < repeats; ++k) {
    seconds.push_back(seconds_of(replay));
    spent += seconds.back();
    shows_bar = shows_bar || spent > bar_after;
    const double share = (k + 1.0) / repeats;
    if (shows_bar) study::show_progress("profile", share, spent / share - spent);
  }
  std::sort(seconds.begin(), seconds.end());
  const double median = seconds[seconds.size() / 2];
  const ribbon::IslandReport& total = replay.total();
  std::printf("%d times: median %.4f ms, least %.4f ms", repeats, 1e3 * median, 1e3 * seconds.front());
  if (total.work > 0) std::printf("; %.1f ns a unit of work", 1e9 * median / static_cast<double>(total.work));
  if (total.iterations > 0) std::printf(", %.4f ms a Newton step", 1e3 * median / total.iterations);
  std::printf("\n");
}

}  // namespace flight
