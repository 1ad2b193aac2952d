#include "tests/study/windows.h"

#include <algorithm>
#include <cmath>

#include "ribbon/study/conditions.h"
#include "tests/study/run_in_copy.h"
#include "tests/study/setting.h"

namespace study {

using ribbon::study::max_probe_difference;
using ribbon::study::max_reference_difference;
using ribbon::study::probe_kick;

namespace {

/// Evenly spaced along a run; each window is complete if the run is long enough.
std::vector<std::size_t> begins_of(std::size_t ticks, std::size_t most) {
  if (ticks <= Windows::ticks) return {0};
  const std::size_t room = ticks - Windows::ticks;
  const std::size_t count = std::min(most, 1 + room / Windows::ticks);
  std::vector<std::size_t> begins;
  for (std::size_t k = 0; k < count; ++k) begins.push_back(count == 1 ? 0 : k * room / (count - 1));
  return begins;
}

}  // namespace

double WindowErrors::greatest() const {
  double most = 0.0;
  for (const double error : {position_m, player_m, body_m}) {
    if (error > most) most = error;
  }
  return most;
}

std::size_t agreeing_cord_ticks(const Trace& a, const Trace& b, double most) {
  const std::size_t ticks = std::min(a.places.size(), b.places.size());
  for (std::size_t k = 0; k < ticks; ++k) {
    double sum = 0.0;
    double count = 0.0;
    for_each_common_cord(a, b, k, [&](std::size_t i, std::size_t j, std::size_t) {
      for (std::size_t s = 0; s < Trace::stations; ++s) {
        const ribbon::Vec2 off = a.places[k][i * Trace::stations + s] - b.places[k][j * Trace::stations + s];
        sum += dot(off, off);
        ++count;
      }
    });
    if (!(sum <= most * most * count)) return k;
  }
  return ticks;
}

std::size_t agreeing_player_ticks(const Trace& a, const Trace& b, double most) {
  const std::size_t ticks = std::min(a.player.size(), b.player.size());
  for (std::size_t k = 0; k < ticks; ++k) {
    if (!(length(a.player[k] - b.player[k]) <= most)) return k;
  }
  return ticks;
}

std::size_t agreeing_body_ticks(const Trace& a, const Trace& b, double most) {
  const std::size_t ticks = std::min(a.bodies.size(), b.bodies.size());
  for (std::size_t k = 0; k < ticks; ++k) {
    for (std::size_t n = 0; n < std::min(a.bodies[k].size(), b.bodies[k].size()); ++n) {
      if (!(length(a.bodies[k][n] - b.bodies[k][n]) <= most)) return k;
    }
  }
  return ticks;
}

Windows::Windows(const game::Level& level, std::span<const engine::TickInput> inputs, const ribbon::Accuracy& fine,
                 const ribbon::Accuracy& finer, std::size_t most) {
  std::vector<Trace> others;
  for (const std::size_t begin : begins_of(inputs.size(), most)) {
    const std::size_t size = std::min(ticks, inputs.size() - begin);
    Window& window =
        windows_.emplace_back(Window{begin, size, std::make_unique<StartedRun>(level, inputs, begin, lead_in)});
    others.push_back(set_reference(window, fine, finer));
  }
  agreement_ =
      pooled([&](const Window& window) { return others[static_cast<std::size_t>(&window - windows_.data())]; });
}

/// Where probes or references differ nothing is compared, so that the second of them ends there: the references are
/// expensive.
Trace Windows::set_reference(Window& window, const ribbon::Accuracy& fine, const ribbon::Accuracy& finer) {
  const auto ends = [&window](const Trace& first, double most) {
    return [&window, &first, most](const Trace& second) {
      const std::size_t ticks = second.places.size();
      const auto is_decided = [ticks](std::size_t compared, std::size_t agreeing) {
        return compared <= ticks || agreeing < ticks;
      };
      return is_decided(window.cords, agreeing_cord_ticks(first, second, most)) &&
             is_decided(window.player, agreeing_player_ticks(first, second, most)) &&
             is_decided(window.bodies, agreeing_body_ticks(first, second, most));
    };
  };
  window.cords = window.player = window.bodies = window.size;
  const ribbon::Accuracy moderate = accuracy_of(probe({}));
  const Trace left = window.run(window.size, {moderate, -probe_kick});
  window.limit(left, window.run(window.size, {moderate, probe_kick}, ends(left, max_probe_difference)),
               max_probe_difference);
  if (window.longest() == 0) return {};
  Trace other = window.run(window.longest(), {fine});
  window.reference = window.run(window.longest(), {finer}, ends(other, max_reference_difference));
  window.limit(other, window.reference, max_reference_difference);
  return other;
}

Trace Windows::Window::run(std::size_t count, const PartSetting& setting, const StartedRun::Ends& ends) const {
  return run_in_copy([&] { return start->finish(count, setting, ends); });
}

void Windows::Window::limit(const Trace& a, const Trace& b, double most) {
  cords = std::min(cords, agreeing_cord_ticks(a, b, most));
  player = std::min(player, agreeing_player_ticks(a, b, most));
  bodies = std::min(bodies, agreeing_body_ticks(a, b, most));
}

WindowErrors Windows::errors(const std::optional<ribbon::Accuracy>& accuracy, const CordAccuracies& by_cord) const {
  return pooled([&](const Window& window) { return window.run(window.longest(), {accuracy, 0.0, by_cord}); });
}

/// RMS over the compared ticks of all windows.
template <typename Run>
WindowErrors Windows::pooled(Run&& run_in) const {
  struct Sum {
    double squares = 0.0;
    double ticks = 0.0;
    void add(double error, std::size_t count) {
      if (count == 0 || std::isnan(error)) return;
      squares += static_cast<double>(count) * error * error;
      ticks += static_cast<double>(count);
    }
    double root() const { return ticks > 0.0 ? std::sqrt(squares / ticks) : unavailable; }
  };
  Sum cords, players, bodies;
  std::string failure;
  bool spends_budget = false;
  for (const Window& window : windows_) {
    if (window.longest() == 0) continue;
    const Trace trace = run_in(window);
    if (failure.empty() && !trace.failure.empty()) {
      failure = trace.failure + " of a run that continues from tick " + std::to_string(window.begin);
    }
    spends_budget = spends_budget || trace.work.posed > 0;
    cords.add(difference(trace, window.reference, window.cords).position_m, window.cords);
    players.add(difference(trace, window.reference, window.player).player_m, window.player);
    bodies.add(difference(trace, window.reference, window.bodies).body_m, window.bodies);
  }
  return {cords.root(), players.root(), bodies.root(), failure, spends_budget};
}

double Windows::share(std::size_t Window::*compared) const {
  double some = 0.0;
  double all = 0.0;
  for (const Window& window : windows_) {
    some += static_cast<double>(window.*compared);
    all += static_cast<double>(window.size);
  }
  return some / all;
}

}  // namespace study
