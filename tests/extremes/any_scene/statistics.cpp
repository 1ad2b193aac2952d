#include "tests/extremes/any_scene/statistics.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <iterator>

namespace any_scene {
namespace {

/// The value below or at which the share lies.
double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
  return values[std::clamp<std::size_t>(rank, 1, values.size()) - 1];
}

int quantile(const std::map<int, int>& counts, double share) {
  long all = 0;
  for (const auto& [work, count] : counts) all += count;
  long below = 0;
  for (const auto& [work, count] : counts) {
    below += count;
    if (static_cast<double>(below) >= share * static_cast<double>(all)) return work;
  }
  return 0;
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

void print_row(const char* family, const char* preset, const std::vector<Summary>& runs) {
  if (runs.empty()) return;
  const auto work = [](const Summary& run) { return run.max_work; };
  const auto stretch = [](const Summary& run) { return 100.0 * run.stretch; };
  const auto rise = [](const Summary& run) { return 100.0 * run.rise; };
  const std::map<int, int> ticks = all_ticks(runs);
  std::printf(
      "%-13s %-9s %6d %6d %6.0f %6.0f %6.0f %6d %6d %8.3g %8.3g %8.3g %8.3g %5d %5d %5d %8.3g %8.3g %9.3g %8.3g\n",
      family, preset, static_cast<int>(runs.size()),
      count(runs, [](const Summary& run) { return run.unconverged > 0; }), quantile_of(runs, 0.5, work),
      quantile_of(runs, 0.9, work), quantile_of(runs, 1.0, work), quantile(ticks, 0.99), quantile(ticks, 0.999),
      quantile_of(runs, 0.9, stretch), quantile_of(runs, 1.0, stretch), quantile_of(runs, 0.9, rise),
      quantile_of(runs, 1.0, rise), count(runs, [](const Summary& run) { return run.crossings > 0; }),
      count(runs, [](const Summary& run) { return run.inverted > 0; }),
      count(runs, [](const Summary& run) { return run.end != End::whole; }),
      quantile_of(runs, 1.0, [](const Summary& run) { return run.penetration; }),
      1e3 * quantile_of(runs, 1.0, [](const Summary& run) { return run.gap; }),
      quantile_of(runs, 1.0, [](const Summary& run) { return run.worst_ms; }),
      quantile_of(runs, 1.0, [](const Summary& run) { return run.speed; }));
}

std::vector<Summary> some(const std::vector<Summary>& runs, const std::function<bool(const Summary&)>& wanted) {
  std::vector<Summary> chosen;
  std::copy_if(runs.begin(), runs.end(), std::back_inserter(chosen), wanted);
  return chosen;
}

}  // namespace

void print_table(const std::vector<Summary>& runs) {
  std::printf("%-13s %-9s %6s %6s %6s %6s %6s %6s %6s %8s %8s %8s %8s %5s %5s %5s %8s %8s %9s %8s\n", "family",
              "preset", "scenes", "unconv", "work50", "work90", "workmx", "p99", "p99.9", "str90%", "strmax%",
              "rise90%", "risemax%", "cross", "inver", "ended", "depth", "gap mm", "tick ms", "m/s");
  for (const Preset preset : {Preset::fast, Preset::balanced, Preset::accurate}) {
    for (const Family family : all_families) {
      print_row(std::string(name(family)).c_str(), std::string(name(preset)).c_str(),
                some(runs, [&](const Summary& run) { return run.which.family == family && run.preset == preset; }));
    }
    print_row("all", std::string(name(preset)).c_str(),
              some(runs, [&](const Summary& run) { return run.preset == preset; }));
  }
  for (const End end : {End::cut, End::broken, End::refused, End::crashed}) {
    for (const Summary& run : runs) {
      if (run.end != end) continue;
      std::printf("%s: %s, seed %u, %s, after %d ticks\n", std::string(name(end)).c_str(),
                  std::string(name(run.which.family)).c_str(), run.which.seed, std::string(name(run.preset)).c_str(),
                  run.ticks);
    }
  }
}

void print_histogram(const std::vector<Summary>& runs) {
  std::map<int, long> bins;  // by the greatest work of the bin
  long most = 1;
  for (const auto& [work, number] : all_ticks(runs)) {
    int end = 1;
    while (end < work) end = end < 8 ? end + 1 : end + end / 4;
    bins[work == 0 ? 0 : end] += number;
    most = std::max(most, bins[work == 0 ? 0 : end]);
  }
  std::printf("\nNewton steps a tick (up to): ticks, bars logarithmic\n");
  for (const auto& [end, number] : bins) {
    const double share = std::log(1.0 + static_cast<double>(number)) / std::log(1.0 + static_cast<double>(most));
    std::printf("%7d %9ld %s\n", end, number, std::string(static_cast<std::size_t>(60.0 * share), '#').c_str());
  }
}

void print_ticks(const Outcome& outcome) {
  std::printf("%5s %6s %6s %8s %9s %9s %9s %12s %9s %9s %9s %7s %5s %5s\n", "tick", "work", "unconv", "ms", "stretch%",
              "strain%", "m/s", "energy J", "gain%", "rise%", "gap mm", "depth", "cross", "inver");
  for (std::size_t k = 0; k < outcome.ticks.size(); ++k) {
    const Sample& tick = outcome.ticks[k];
    std::printf("%5d %6d %6d %8.3f %9.3g %9.3g %9.3g %12.6g %9.3g %9.3g %9.3g %7.3g %5d %5d%s\n", static_cast<int>(k),
                tick.work, tick.unconverged, tick.milliseconds, 100.0 * tick.stretch, 100.0 * tick.strain, tick.speed,
                tick.energy, 100.0 * tick.gain, 100.0 * tick.rise, 1e3 * tick.gap, tick.penetration, tick.crossings,
                tick.inverted, tick.finite ? "" : " not finite");
  }
  std::printf("%s %s\n", std::string(name(outcome.end)).c_str(), outcome.message.c_str());
}

}  // namespace any_scene
