#include "ribbon/study/study.h"

#include <algorithm>
#include <chrono>

#include "ribbon/definition.h"
#include "ribbon/study/accuracies.h"
#include "ribbon/study/conditions.h"
#include "ribbon/study/interval.h"

namespace ribbon::study {
namespace {

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The converged motion of a whole run and of its windows.
class Reference {
 public:
  Reference(const MakeScene& make, int ticks, int windows) : make_(&make), whole_(make, 0, ticks) {
    const int room = ticks - window_ticks;
    const int count = room > 0 ? std::min(windows, 1 + room / window_ticks) : 0;
    for (int k = 1; k <= count; ++k) windows_.emplace_back(make, k * room / count, window_ticks);
    agreement_m_ = error_in(whole_, [](const Interval& interval, Differences& cords, Differences& bodies) {
      interval.add_agreement(cords, bodies);
    });
  }

  double agreement_m() const { return agreement_m_; }
  const Interval& whole() const { return whole_; }
  /// The share of the windows' ticks that are compared.
  double share(int (Interval::*compared)() const) const {
    double some = 0.0;
    double all = 0.0;
    for (const Interval& window : windows_) {
      some += (window.*compared)();
      all += window.ticks();
    }
    return all > 0.0 ? some / all : 0.0;
  }

  /// Sets the error of a setting whose whole run is given, and the failure of one that blows up in a window.
  void judge(const Motion& motion, Measured& measured) const {
    const auto add = [&](const Interval& interval, Differences& cords, Differences& bodies) {
      if (&interval == &whole_) {
        interval.add_errors(motion, cords, bodies);
        return;
      }
      const Motion own = interval.run(*make_, measured.setting.accuracy);
      if (measured.failure.empty()) measured.failure = own.failure;
      interval.add_errors(own, cords, bodies);
    };
    measured.error_m = std::max(error_in(whole_, add), resolution_per_agreement * agreement_m_);
  }

 private:
  /// Returns the largest RMS: of cords and bodies, in the whole run and pooled over the windows.
  template <typename Add>
  double error_in(const Interval& whole, Add&& add) const {
    Differences cords, bodies, window_cords, window_bodies;
    add(whole, cords, bodies);
    for (const Interval& window : windows_) add(window, window_cords, window_bodies);
    return std::max({cords.root(), bodies.root(), window_cords.root(), window_bodies.root()});
  }

  const MakeScene* make_;
  Interval whole_;
  std::vector<Interval> windows_;
  double agreement_m_ = 0.0;
};

void check(const MakeScene& make, int ticks, const Options& options) {
  if (!make) throw CallError("there is no function that makes the scene; accepted is one that returns a Scene");
  check_range("ticks", ticks, 1, 1e6);
  check_range("number of windows", options.windows, 0, 1000);
  check_range("repeats", options.repeats, 1, 1000);
  check_range("number of settings", static_cast<double>(options.settings.size()), 1, 1000);
}

/// Throws CallError for a scene that cannot be studied.
void check_runs(const Motion& first, const Motion& second) {
  if (std::all_of(first.frames.begin(), first.frames.end(), [](const Frame& frame) { return frame.cords.empty(); }))
    throw CallError("there is nothing to study: no tick has a cord of the direct solver; accepted is a scene with one");
  const auto differs =
      std::mismatch(first.frames.begin(), first.frames.end(), second.frames.begin(), second.frames.end());
  if (differs.first == first.frames.end() && differs.second == second.frames.end()) return;
  throw CallError("two runs of the scene differ from tick " + std::to_string(differs.first - first.frames.begin()) +
                  " on; accepted is a scene that is the same in every run: without a clock, and with seeded random "
                  "numbers");
}

Measured count(const Setting& setting, const Motion& motion) {
  Measured measured{setting};
  int unconverged = 0;
  for (const Frame& frame : motion.frames) {
    const auto work = static_cast<double>(frame.work);
    measured.work += work / static_cast<double>(motion.frames.size());
    measured.most_work = std::max(measured.most_work, work);
    unconverged += frame.is_converged ? 0 : 1;
  }
  measured.failure = motion.failure;
  if (measured.failure.empty() && unconverged > 0)
    measured.failure = std::to_string(unconverged) + " ticks not converged";
  return measured;
}

/// Returns the time of each tick, µs.
std::vector<double> times_of(const MakeScene& make, const Setting& setting, int ticks) {
  using Clock = std::chrono::steady_clock;
  const Scene scene = make();
  Accuracies accuracies;
  std::vector<double> times;
  for (int tick = 0; tick < ticks; ++tick) {
    accuracies.set(scene.coupling, setting.accuracy);
    const Clock::time_point start = Clock::now();
    scene.tick(tick);
    times.push_back(std::chrono::duration<double, std::micro>(Clock::now() - start).count());
  }
  return times;
}

/// Times the settings in turn, so that a slow moment of the machine affects all of them alike.
void time(const MakeScene& make, int ticks, int repeats, std::vector<Measured>& settings) {
  std::vector<std::vector<std::vector<double>>> times(settings.size());  // by setting, tick and repeat
  for (auto& by_tick : times) by_tick.resize(static_cast<std::size_t>(ticks));
  for (int repeat = 0; repeat < repeats; ++repeat) {
    for (std::size_t s = 0; s < settings.size(); ++s) {
      const std::vector<double> own = times_of(make, settings[s].setting, ticks);
      for (std::size_t k = 0; k < own.size(); ++k) times[s][k].push_back(own[k]);
    }
  }
  for (std::size_t s = 0; s < settings.size(); ++s) {
    std::vector<double> medians;
    for (const std::vector<double>& tick : times[s]) medians.push_back(median_of(tick));
    settings[s].median_us = median_of(medians);
    settings[s].most_us = *std::max_element(medians.begin(), medians.end());
  }
}

}  // namespace

std::vector<Setting> settings() {
  const auto euler = [](int substeps) { return Accuracy{Integrator::implicit_euler, substeps, 8, 5e-4, 600, true}; };
  Accuracy four = Accuracy::balanced();
  four.substeps = 4;
  return {{"own", std::nullopt},
          {"fast", Accuracy::fast()},
          {"balanced", Accuracy::balanced()},
          {"accurate", Accuracy::accurate()},
          {"implicit_euler, tolerance 0.5 mm", euler(1)},
          {"implicit_euler, 4 substeps, tolerance 0.5 mm", euler(4)},
          {"tr_bdf2, 4 substeps, tolerance 0.5 mm", four}};
}

Study measure(const MakeScene& make, int ticks, const Options& options) {
  check(make, ticks, options);
  const Motion own = play(make, {0, ticks});
  check_runs(own, play(make, {0, ticks}));
  const Reference reference(make, ticks, options.windows);
  Study study;
  study.ticks = ticks;
  study.compared_ticks = std::min(reference.whole().cord_ticks(), reference.whole().body_ticks());
  study.compared_cords = reference.share(&Interval::cord_ticks);
  study.compared_bodies = reference.share(&Interval::body_ticks);
  study.agreement_m = reference.agreement_m();
  for (const Setting& setting : options.settings) {
    const Motion motion = setting.accuracy ? play(make, {0, ticks, setting.accuracy}) : own;
    Measured measured = count(setting, motion);
    reference.judge(motion, measured);
    study.settings.push_back(measured);
  }
  time(make, ticks, options.repeats, study.settings);
  return study;
}

}  // namespace ribbon::study
