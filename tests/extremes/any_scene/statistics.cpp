#include "tests/extremes/any_scene/statistics.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <iterator>

namespace any_scene {
namespace {

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
  return values[std::clamp<std::size_t>(rank, 1, values.size()) - 1];
}

template <typename Value>
double quantile_of(const std::vector<Summary>& runs, double share, Value&& value) {
  std::vector<double> values;
  for (const Summary& run : runs) values.push_back(static_cast<double>(value(run)));
  return quantile(std::move(values), share);
}

template <typename Condition>
int count(const std::vector<Summary>& runs, Condition&& condition) {
  return static_cast<int>(std::count_if(runs.begin(), runs.end(), condition));
}

std::map<int, int> all_ticks(const std::vector<Summary>& runs) {
  std::map<int, int> ticks;
  for (const Summary& run : runs) {
    for (const auto& [work, number] : run.work) ticks[work] += number;
  }
  return ticks;
}

using Runs = std::vector<Summary>;

struct Column {
  const char* title;
  int width;
  std::function<double(const Runs&)> value;
};

/// Returns the number of runs that meet the condition.
template <typename Condition>
std::function<double(const Runs&)> how_many(Condition condition) {
  return [condition](const Runs& runs) { return count(runs, condition); };
}

/// Returns the quantile over runs of a figure.
template <typename Value>
std::function<double(const Runs&)> over_runs(double share, Value value) {
  return [share, value](const Runs& runs) { return quantile_of(runs, share, value); };
}

/// Returns whether the scene is as it should be a second after all that drives it has ended.
bool is_whole(const Summary& run) {
  return run.late_unconverged == 0 && run.late_stretch <= 0.01 && run.late_gap <= 0.01 && run.late_gain <= 1e-3;
}

const std::vector<Column>& columns() {
  const auto work = [](const Summary& run) { return run.max_work; };
  const auto stretch = [](const Summary& run) { return 100.0 * run.stretch; };
  const auto rise = [](const Summary& run) { return 100.0 * run.rise; };
  static const std::vector<Column> all = {
      {"scenes", 6, [](const Runs& runs) { return static_cast<double>(runs.size()); }},
      {"unconv", 6, how_many([](const Summary& run) { return run.unconverged > 0; })},
      {"work50", 6, over_runs(0.5, work)},
      {"work90", 6, over_runs(0.9, work)},
      {"workmx", 6, over_runs(1.0, work)},
      {"p99", 6, [](const Runs& runs) { return quantile_of_ticks(all_ticks(runs), 0.99); }},
      {"p99.9", 6, [](const Runs& runs) { return quantile_of_ticks(all_ticks(runs), 0.999); }},
      {"str90%", 8, over_runs(0.9, stretch)},
      {"strmax%", 8, over_runs(1.0, stretch)},
      {"rise90%", 8, over_runs(0.9, rise)},
      {"risemx%", 8, over_runs(1.0, rise)},
      {"x crd", 5, how_many([](const Summary& run) { return run.crossings > 0; })},
      {"x fix", 5, how_many([](const Summary& run) { return run.crossings_fixed > 0; })},
      {"x mov", 5, how_many([](const Summary& run) { return run.crossings_moving > 0; })},
      {"x prs", 5, how_many([](const Summary& run) { return run.crossings_pressed > 0; })},
      {"inver", 5, how_many([](const Summary& run) { return run.inverted > 0; })},
      {"ended", 5, how_many([](const Summary& run) { return run.end != End::completed; })},
      {"depth90", 8, over_runs(0.9, [](const Summary& run) { return run.penetration; })},
      {"depthmx", 8, over_runs(1.0, [](const Summary& run) { return run.penetration; })},
      {"gap mm", 8, over_runs(1.0, [](const Summary& run) { return 1e3 * run.gap; })},
      {"prs mm", 8, over_runs(1.0, [](const Summary& run) { return 1e3 * run.gap_pressed; })},
      {"hang", 5, over_runs(1.0, [](const Summary& run) { return run.hanging; })},
      {"unwhole", 7, how_many([](const Summary& run) { return !is_whole(run); })},
      {"tick ms", 8, over_runs(1.0, [](const Summary& run) { return run.worst_ms; })},
      {"m/s", 6, over_runs(1.0, [](const Summary& run) { return run.speed; })},
  };
  return all;
}

void print_row(std::string_view family, std::string_view preset, const Runs& runs) {
  if (runs.empty()) return;
  std::printf("%-13s %-8s", std::string(family).c_str(), std::string(preset).c_str());
  for (const Column& column : columns()) {
    const double value = column.value(runs);
    const bool whole = std::abs(value) < 1e9 && value == std::floor(value);
    std::printf(" %*.*g", column.width, whole ? 9 : 3, value);
  }
  std::printf("\n");
}

std::vector<Summary> some(const std::vector<Summary>& runs, const std::function<bool(const Summary&)>& wanted) {
  std::vector<Summary> chosen;
  std::copy_if(runs.begin(), runs.end(), std::back_inserter(chosen), wanted);
  return chosen;
}

}  // namespace

void print_table(const std::vector<Summary>& runs) {
  std::printf("%-13s %-8s", "family", "preset");
  for (const Column& column : columns()) std::printf(" %*s", column.width, column.title);
  std::printf("\n");
  for (const Preset preset : all_presets) {
    const auto of_preset = [&](const Summary& run) { return run.preset == preset; };
    for (const Family family : all_families) {
      print_row(name(family), name(preset),
                some(runs, [&](const Summary& run) { return run.which.family == family && of_preset(run); }));
    }
    print_row("all", name(preset), some(runs, of_preset));
  }
  for (const End end : {End::timed_out, End::broken, End::refused, End::crashed}) {
    for (const Summary& run : runs) {
      if (run.end != end) continue;
      std::printf("%s: %s, seed %u, %s, after %d ticks\n", std::string(name(end)).c_str(),
                  std::string(name(run.which.family)).c_str(), run.which.seed, std::string(name(run.preset)).c_str(),
                  run.ticks);
    }
  }
}

int quantile_of_ticks(const std::map<int, int>& ticks, double share) {
  long all = 0;
  for (const auto& [work, count] : ticks) all += count;
  long below = 0;
  for (const auto& [work, count] : ticks) {
    below += count;
    if (static_cast<double>(below) >= share * static_cast<double>(all)) return work;
  }
  return 0;
}

int end_of_work_bin(int work) {
  int end = std::min(work, 1);
  while (end < work) end = end < 8 ? end + 1 : end + end / 4;
  return end;
}

void print_histogram(const std::vector<Summary>& runs) {
  std::map<int, long> bins;  // key: the greatest work of the bin
  long most = 1;
  for (const auto& [work, number] : all_ticks(runs)) {
    long& ticks = bins[end_of_work_bin(work)];
    ticks += number;
    most = std::max(most, ticks);
  }
  std::printf("\nNewton steps a tick (up to): ticks, bars logarithmic\n");
  for (const auto& [end, number] : bins) {
    const double share = std::log(1.0 + static_cast<double>(number)) / std::log(1.0 + static_cast<double>(most));
    std::printf("%7d %9ld %s\n", end, number, std::string(static_cast<std::size_t>(60.0 * share), '#').c_str());
  }
}

namespace {

std::string text(const CrossedPair& where) {
  return std::to_string(where.cord) + (where.solid ? "/s" : "/c") + std::to_string(where.other) +
         (where.pressed ? "p" : "");
}

}  // namespace

void print_ticks(const Outcome& outcome) {
  std::printf("%5s %6s %6s %8s %9s %9s %9s %12s %9s %9s %9s %7s %-6s %5s %s\n", "tick", "work", "unconv", "ms",
              "stretch%", "strain%", "m/s", "energy J", "gain%", "rise%", "gap mm", "depth", "where", "inver",
              "crossings: cord/c another, /s a solid, p that Box2D pushes");
  for (std::size_t k = 0; k < outcome.ticks.size(); ++k) {
    const Sample& tick = outcome.ticks[k];
    std::string crossings;
    for (const CrossedPair& where : tick.crossings) crossings += text(where) + " ";
    std::printf("%5d %6d %6d %8.3f %9.3g %9.3g %9.3g %12.6g %9.3g %9.3g %9.3g %7.3g %-6s %5d %s%s\n",
                static_cast<int>(k), tick.work, tick.unconverged, tick.milliseconds, 100.0 * tick.stretch,
                100.0 * tick.strain, tick.speed, tick.energy, 100.0 * tick.gain, 100.0 * tick.rise,
                1e3 * std::max(tick.gaps.free, tick.gaps.pressed), tick.penetration.share,
                text(tick.penetration.where).c_str(), tick.inverted, crossings.c_str(),
                tick.finite ? "" : "not finite");
  }
  std::printf("%s %s\n", std::string(name(outcome.end)).c_str(), outcome.message.c_str());
}

}  // namespace any_scene
