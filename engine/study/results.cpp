#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "ribbon/definition.h"
#include "ribbon/study/conditions.h"
#include "ribbon/study/study.h"

namespace ribbon::study {
namespace {

bool counts(const Measured& measured) { return measured.failure.empty() && std::isfinite(measured.error_m); }

std::string line_of(const Measured& m, bool is_on_front) {
  std::array<char, 128> numbers{};
  std::snprintf(numbers.data(), numbers.size(), "%10.0f %10.0f %10.1f %10.1f  ", m.work, m.most_work, m.median_us,
                m.most_us);
  std::array<char, 32> error{};
  std::snprintf(error.data(), error.size(), "%.2g m", m.error_m);
  return numbers.data() + m.setting.name + ": " + (m.failure.empty() ? error.data() : m.failure) +
         (is_on_front ? ", front" : "") + '\n';
}

void add_worse(Measured& worst, const Measured& other) {
  if (!(other.error_m <= worst.error_m)) worst.error_m = other.error_m;  // NaN is worse
  worst.work = std::max(worst.work, other.work);
  worst.most_work = std::max(worst.most_work, other.most_work);
  worst.median_us = std::max(worst.median_us, other.median_us);
  worst.most_us = std::max(worst.most_us, other.most_us);
  if (worst.failure.empty()) worst.failure = other.failure;
}

}  // namespace

std::vector<std::size_t> Study::front() const {
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < settings.size(); ++k) {
    if (counts(settings[k])) order.push_back(k);
  }
  std::stable_sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
    if (settings[a].work != settings[b].work) return settings[a].work < settings[b].work;
    return settings[a].error_m < settings[b].error_m;
  });
  std::vector<std::size_t> best;
  for (const std::size_t k : order) {
    if (best.empty() || settings[k].error_m < settings[best.back()].error_m) best.push_back(k);
  }
  return best;
}

std::optional<std::size_t> Study::cheapest_within(double max_error_m) const {
  for (const std::size_t k : front()) {
    if (settings[k].error_m <= usable_error_share * max_error_m) return k;
  }
  return std::nullopt;
}

std::string Study::table() const {
  const std::vector<std::size_t> best = front();
  std::string lines = "      work  most_work  median_us    most_us  setting: error\n";
  for (std::size_t k = 0; k < settings.size(); ++k) {
    lines += line_of(settings[k], std::find(best.begin(), best.end(), k) != best.end());
  }
  return lines;
}

Study worst_of(const std::vector<Study>& studies) {
  check_range("number of studies", static_cast<double>(studies.size()), 1, 1e6);
  Study worst = studies.front();
  for (std::size_t n = 1; n < studies.size(); ++n) {
    const Study& other = studies[n];
    const bool same = std::equal(worst.settings.begin(), worst.settings.end(), other.settings.begin(),
                                 other.settings.end(), [](const Measured& a, const Measured& b) {
                                   return a.setting.name == b.setting.name && a.setting.accuracy == b.setting.accuracy;
                                 });
    if (!same) throw DefinitionError("the studies have different settings; accepted are studies of the same ones");
    for (std::size_t k = 0; k < worst.settings.size(); ++k) add_worse(worst.settings[k], other.settings[k]);
    worst.agreement_m = std::max(worst.agreement_m, other.agreement_m);
    worst.compared_ticks += other.compared_ticks;
    worst.ticks += other.ticks;
    worst.compared_cords += other.compared_cords;
    worst.compared_bodies += other.compared_bodies;
  }
  const auto count = static_cast<double>(studies.size());
  worst.compared_cords /= count;
  worst.compared_bodies /= count;
  return worst;
}

}  // namespace ribbon::study
