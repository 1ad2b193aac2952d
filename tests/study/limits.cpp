#include "tests/study/limits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "tests/study/text.h"

namespace study {
namespace {

/// Returns the ranks of values, equal ones with their mean rank.
std::vector<double> ranks_of(const std::vector<double>& values) {
  std::vector<double> ranks;
  for (const double value : values) {
    double below = 0.0;
    double equal = 0.0;
    for (const double other : values) {
      below += other < value ? 1.0 : 0.0;
      equal += other == value ? 1.0 : 0.0;
    }
    ranks.push_back(below + 0.5 * (equal - 1.0));
  }
  return ranks;
}

/// Returns 1 if one of the two does not vary.
double correlation_of(const std::vector<double>& a, const std::vector<double>& b) {
  const auto n = static_cast<double>(a.size());
  const double mean_a = std::accumulate(a.begin(), a.end(), 0.0) / n;
  const double mean_b = std::accumulate(b.begin(), b.end(), 0.0) / n;
  double ab = 0.0;
  double aa = 0.0;
  double bb = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    ab += (a[k] - mean_a) * (b[k] - mean_b);
    aa += (a[k] - mean_a) * (a[k] - mean_a);
    bb += (b[k] - mean_b) * (b[k] - mean_b);
  }
  return aa > 0.0 && bb > 0.0 ? ab / std::sqrt(aa * bb) : 1.0;
}

/// Returns the means of samples whose work differs by at most 1 %: such settings take the same steps, or nearly so, and
/// only the noise of the clock orders them.
std::vector<Sample> without_ties(std::span<const Sample> samples) {
  constexpr double equal = 1.01;
  std::vector<Sample> sorted(samples.begin(), samples.end());
  std::sort(sorted.begin(), sorted.end(), [](const Sample& a, const Sample& b) { return a.work < b.work; });
  auto end = sorted.begin();  // of the means
  for (auto first = sorted.begin(), last = first; first != sorted.end(); first = last) {
    last = std::find_if(first, sorted.end(), [least = first->work](const Sample& s) { return s.work > equal * least; });
    const auto count = static_cast<double>(last - first);
    Sample mean;
    for (auto s = first; s != last; ++s) mean = {mean.work + s->work / count, mean.us + s->us / count};
    *end++ = mean;
  }
  sorted.erase(end, sorted.end());
  return sorted;
}

/// Weighted sums of a line's normal equations.
struct Sums {
  double w = 0.0, wx = 0.0, wy = 0.0, wxx = 0.0, wxy = 0.0;
  void add(const Sample& s) {
    const double weight = 1.0 / (s.us * s.us);
    w += weight;
    wx += weight * s.work;
    wy += weight * s.us;
    wxx += weight * s.work * s.work;
    wxy += weight * s.work * s.us;
  }
};

void fit_line(Calibration& fit, const Sums& sums) {
  const double determinant = sums.w * sums.wxx - sums.wx * sums.wx;
  if (determinant > 1e-12 * sums.w * sums.wxx) {
    fit.us_per_work = (sums.w * sums.wxy - sums.wx * sums.wy) / determinant;
    fit.base_us = (sums.wy - fit.us_per_work * sums.wx) / sums.w;
    if (fit.us_per_work >= 0.0 && fit.base_us >= 0.0) return;
  }
  fit.base_us = 0.0;  // one sample, or the line is not one of costs
  fit.us_per_work = sums.wxx > 0.0 ? sums.wxy / sums.wxx : 0.0;
}

/// Returns the greatest of a setting's values relative to the usable parts of the limits.
double usage_of(const Measured& m, const Point& point, const Limits& limits, const Calibration& calibration) {
  double most = 0.0;
  const auto add = [&most](const std::optional<double>& limit, double value, double share) {
    if (limit) most = std::max(most, value / (share * *limit));
  };
  const WorkFigures work = largest_work(m);
  add(limits.max_error_m, point.error_m, usable_error_share);
  add(limits.median_us, m.cost_us, usable_budget_share);
  if (work.mean > m.tick_work.mean) add(limits.median_us, calibration.us(work.mean), usable_budget_share);
  add(limits.p99_us, calibration.us(work.p99), usable_budget_share);
  add(limits.most_us, calibration.us(work.most), usable_budget_share);
  add(limits.most_work, work.most, usable_budget_share);
  return most;
}

/// Returns of what the error is; empty if it is that of the references.
std::string source_in_words(const Measured& m) {
  struct Source {
    double error;
    const char* words;
  };
  const std::array sources = {Source{m.error.position_m, " (of the cords, from the start on)"},
                              Source{m.error.player_m, " (of the player, from the start on)"},
                              Source{m.error.body_m, " (of a body, from the start on)"},
                              Source{m.windows.position_m, " (of the cords, in a quarter of a second)"},
                              Source{m.windows.player_m, " (of the player, in a quarter of a second)"},
                              Source{m.windows.body_m, " (of a body, in a quarter of a second)"},
                              Source{m.others.error_m, " (with another player)"}};
  const Source* greatest = nullptr;
  for (const Source& source : sources) {
    if (source.error > (greatest == nullptr ? std::max(m.resolution_m, m.windows_resolution_m) : greatest->error))
      greatest = &source;
  }
  return greatest == nullptr ? "" : greatest->words;
}

/// What a setting has spent in a study, from the best on: what spends the usual budget of work with these players
/// may leave ticks unconverged with others.
enum class Spending { none, ample_budget, usual_budget };

Spending spending_of(const Measured& m) {
  if (!spends_budget(m)) return Spending::none;
  return m.setting.max_work >= ample_work ? Spending::ample_budget : Spending::usual_budget;
}

std::string time_in_words(double us) {
  return us < 1000.0 ? significant(us, 3) + " us" : significant(1e-3 * us, 3) + " ms";
}

}  // namespace

Calibration calibrate(std::span<const Sample> samples) {
  Calibration fit;
  if (samples.empty()) return fit;
  Sums sums;
  for (const Sample& sample : samples) sums.add(sample);
  fit_line(fit, sums);
  std::vector<double> work;
  std::vector<double> us;
  for (const Sample& sample : without_ties(samples)) {
    work.push_back(sample.work);
    us.push_back(sample.us);
  }
  fit.rank_correlation = correlation_of(ranks_of(work), ranks_of(us));
  return fit;
}

Calibration calibrate(const Study& study) {
  std::vector<Sample> samples;
  for (const Measured& m : study.settings) {
    if (m.least_us > 0.0 && std::isfinite(m.tick_work.mean)) samples.push_back({m.tick_work.mean, m.least_us});
  }
  return calibrate(samples);
}

Choice choose(const Study& study, const Limits& limits, const Calibration& calibration) {
  const std::vector<Point> points = applicable(study);
  Choice choice;
  const auto is_better = [&](std::size_t a, std::size_t b) {
    if (!limits.max_error_m) return points[a].error_m < points[b].error_m;
    const Spending a_spends = spending_of(study.settings[a]);
    const Spending b_spends = spending_of(study.settings[b]);
    return a_spends != b_spends ? a_spends < b_spends : points[a].cost_us < points[b].cost_us;
  };
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (!points[k].failure.empty() || points[k].not_compared || !std::isfinite(points[k].error_m)) continue;
    const double usage = usage_of(study.settings[k], points[k], limits, calibration);
    if (usage <= 1.0) {
      if (!choice.setting || is_better(k, *choice.setting)) choice.setting = k;
    } else if (!choice.nearest || usage < choice.excess) {
      choice.nearest = k;
      choice.excess = usage;
    }
  }
  if (choice.setting) choice.nearest.reset();
  return choice;
}

Setting recommended_for(const Limits& limits, const Measured& chosen) {
  return limits.max_error_m && !spends_budget(chosen) ? with_ample_work(chosen.setting) : chosen.setting;
}

std::string in_words(const Limits& limits) {
  std::string words;
  const auto add = [&words](const std::string& what, const std::optional<double>& limit, const std::string& unit) {
    if (limit) words += (words.empty() ? "" : " and ") + what + significant(*limit, 4) + unit;
  };
  add("an error of ", limits.max_error_m, " m");
  add("a cost of ", limits.median_us, " us");
  add("a 99th percentile of ", limits.p99_us, " us");
  add("a greatest tick of ", limits.most_us, " us");
  add("a greatest tick of ", limits.most_work, " units of work");
  return words;
}

std::string in_words(const Study& study, std::size_t chosen, const Calibration& calibration, const Limits& limits) {
  const Measured& m = study.settings[chosen];
  const WorkFigures work = largest_work(m);
  std::string words = name_of(recommended_for(limits, m)) + ": " + fixed(m.cost_us, 2) + " us per tick";
  if (std::isfinite(work.most)) {
    words += ", 99 % of the ticks within " + time_in_words(calibration.us(work.p99)) + ", the greatest tick " +
             time_in_words(calibration.us(work.most)) + " (" + significant(work.most, 6) + " units of work)";
  }
  return words + ", error " + significant(applicable(study)[chosen].error_m, 3) + " m" + source_in_words(m);
}

}  // namespace study
