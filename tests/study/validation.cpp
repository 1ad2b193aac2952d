#include "tests/study/validation.h"

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include "game/simulation/buttons.h"
#include "ribbon/box2d/state_hash.h"
#include "tests/study/text.h"

namespace study {
namespace {

constexpr int promise_repeats = 3;
constexpr std::size_t promise_windows = 3;

StudyOptions options_of(std::vector<Setting> settings, std::vector<Inputs> others = {}) {
  StudyOptions options;
  options.others = std::move(others);
  options.quick = true;
  options.repeats = promise_repeats;
  options.windows = promise_windows;
  options.grid = std::move(settings);
  return options;
}

/// The study with counted work in place of time: its cheapest setting is the same on every machine.
Study by_work(Study study) {
  for (Measured& m : study.settings) m.cost_us = largest_work(m).mean;
  return study;
}

/// Returns the value that the promise limits, and its limit.
std::pair<double, double> value_of(const Limits& limits, const Measured& m, double error_m, const Calibration& fit) {
  if (limits.max_error_m) return {error_m, *limits.max_error_m};
  if (limits.median_us) return {m.cost_us, *limits.median_us};
  if (limits.p99_us) return {fit.us(m.tick_work.p99), *limits.p99_us};
  if (limits.most_us) return {fit.us(m.tick_work.most), *limits.most_us};
  return {m.tick_work.most, *limits.most_work};
}

}  // namespace

std::vector<Promise> promises_of(const Limits& limits) {
  std::vector<Promise> promises;
  const auto add = [&promises](const std::optional<double>& limit, std::optional<double> Limits::*member,
                               const std::string& before, const std::string& unit) {
    if (!limit) return;
    promises.push_back({before + "_" + significant(*limit, 6) + "_" + unit, {}});
    promises.back().limits.*member = limit;
  };
  const bool any = limits.any();
  add(any ? limits.max_error_m : 1e-2, &Limits::max_error_m, "error", "m");
  if (!any) add(1e-3, &Limits::max_error_m, "error", "m");
  add(any ? limits.median_us : 100.0, &Limits::median_us, "median", "us");
  add(any ? limits.p99_us : 300.0, &Limits::p99_us, "p99", "us");
  add(limits.most_us, &Limits::most_us, "greatest", "us");
  add(limits.most_work, &Limits::most_work, "greatest", "work");
  return promises;
}

namespace {

/// Returns the index of a setting in a list, to which it is added if it is new.
std::size_t index_in(std::vector<Setting>& settings, const Setting& setting) {
  const auto index = static_cast<std::size_t>(std::find(settings.begin(), settings.end(), setting) - settings.begin());
  if (index == settings.size()) settings.push_back(setting);
  return index;
}

/// The runs of a variation; only their promises, failures and numbers are set if its level cannot be varied.
class PromiseTrial {
 public:
  PromiseTrial(std::size_t variation, std::size_t variations, std::span<const LevelFile> levels,
               const ValidationOptions& options, const Measure& measure_level)
      : seed_(static_cast<unsigned>(2 * variation)),
        number_(variation % levels.size()),
        level_(&levels[number_]),
        options_(&options),
        measure_(&measure_level) {
    for (std::size_t player = 0; player < static_cast<std::size_t>(options.players); ++player) {
      const std::size_t run = player * variations + variation;
      runs_.push_back({static_cast<unsigned>(2 * run + 1), {}});
      for (const Promise& promise : options.promises) {
        PromiseRow& row = runs_.back().rows.emplace_back();
        row.run = run + 1;
        row.level = level_->level().name;
        row.promise = promise.name;
        row.level_hash = ribbon::box2d::to_hex(level_->hash());
      }
    }
  }

  std::vector<PromiseRow> rows() {
    try {
      const LevelFile varied = level_->varied(seed_);
      const Chosen chosen = choose_in(varied);
      for (Run& run : runs_) try_or_refuse(varied, chosen, run);
    } catch (const engine::MapError& error) {
      for (Run& run : runs_) refuse(run, error);
    }
    std::vector<PromiseRow> all;
    for (const Run& run : runs_) all.insert(all.end(), run.rows.begin(), run.rows.end());
    return all;
  }

 private:
  /// A run has a player, and a row for each promise.
  struct Run {
    unsigned seed;
    std::vector<PromiseRow> rows;
  };

  struct Chosen {
    std::vector<Setting> settings;
    std::vector<std::optional<std::size_t>> by_promise;  // index in settings
    Calibration fit;
  };

  Chosen choose_in(const LevelFile& varied) const {
    const Study chosen_on = (*measure_)(varied, random_inputs_with_cords(varied.level(), seed_, options_->ticks),
                                        options_of(own_settings(), others_in(varied)));
    const Study counted = by_work(chosen_on);
    Chosen chosen;
    chosen.fit = calibrate(chosen_on);
    for (const Promise& promise : options_->promises) {
      const Choice choice = choose(promise.limits.max_error_m ? counted : chosen_on, promise.limits, chosen.fit);
      if (!choice.setting) {
        chosen.by_promise.emplace_back();
        continue;
      }
      const Measured& setting = chosen_on.settings[*choice.setting];
      chosen.by_promise.emplace_back(index_in(chosen.settings, recommended_for(promise.limits, setting)));
    }
    return chosen;
  }

  static void refuse(Run& run, const engine::MapError& error) {
    for (PromiseRow& row : run.rows) row.failure = std::string("no such variation: ") + error.what();
  }

  /// With one player no cord may exist, with another one some.
  void try_or_refuse(const LevelFile& varied, const Chosen& chosen, Run& run) const {
    try {
      try_in(varied, chosen, run);
    } catch (const engine::MapError& error) {
      refuse(run, error);
    }
  }

  void try_in(const LevelFile& varied, const Chosen& chosen, Run& run) const {
    const Inputs input = random_inputs_with_cords(varied.level(), run.seed, options_->ticks);
    const bool holds = !meetings_of(varied.level(), input).held.empty();
    StudyOptions as_recommended = options_of(chosen.settings);
    as_recommended.ample_budgets = false;
    const Study again = chosen.settings.empty() ? Study{} : (*measure_)(varied, input, as_recommended);
    const std::vector<Point> points = applicable(again);
    for (std::size_t k = 0; k < run.rows.size(); ++k) {
      run.rows[k].holds_cord = holds;
      if (const auto& index = chosen.by_promise[k])
        judge(run.rows[k], options_->promises[k].limits, again.settings[*index], points[*index], chosen.fit);
    }
  }

  std::vector<Inputs> others_in(const LevelFile& varied) const {
    std::vector<Inputs> others = players_that_meet_cords(varied.level(), seed_, options_->others);
    if (number_ >= options_->recorded.size()) return others;
    const Inputs& recorded = options_->recorded[number_];
    if (!recorded.empty() && meetings_of(varied.level(), recorded).any_cord) others.push_back(recorded);
    return others;
  }

  static void judge(PromiseRow& row, const Limits& limits, const Measured& m, const Point& point,
                    const Calibration& fit) {
    const auto [value, limit] = value_of(limits, m, point.error_m, fit);
    row.setting = name_of(m.setting);
    row.value = value;
    row.failure = point.failure;
    row.is_met = point.failure.empty() && value <= limit;
  }

  unsigned seed_;
  std::size_t number_;  // of the level
  const LevelFile* level_;
  const ValidationOptions* options_;
  const Measure* measure_;
  std::vector<Run> runs_;
};

void count(Tally& tally, const PromiseRow& row) {
  tally.recommended += row.setting.empty() ? 0 : 1;
  tally.met += row.is_met ? 1 : 0;
  tally.not_found += row.setting.empty() ? 1 : 0;
}

/// Returns the value of a name, which is added at the end if it is new.
template <typename Value>
Value& value_at(std::vector<std::pair<std::string, Value>>& list, const std::string& name) {
  for (auto& [known, value] : list) {
    if (known == name) return value;
  }
  return list.emplace_back(name, Value{}).second;
}

PromiseRow promise_row_of(const std::vector<std::string>& cells) {
  if (cells.size() != 9 || (cells[5] != "0" && cells[5] != "1")) throw std::invalid_argument("cells");
  return {std::stoul(cells[0]), cells[1], cells[2],        cells[3], std::stod(cells[4]),
          cells[5] == "1",      cells[6], cells[7] == "1", cells[8]};
}

}  // namespace

void validate_recommendations(std::span<const LevelFile> levels, const ValidationOptions& options,
                              const std::function<void(const std::vector<PromiseRow>&, double share)>& add,
                              const Measure& measure_level) {
  if (options.players < 1 || options.runs % options.players != 0) {
    throw std::invalid_argument(std::to_string(options.players) + " players do not divide " +
                                std::to_string(options.runs) + " runs; accepted is a divisor of their number");
  }
  const std::size_t all = static_cast<std::size_t>(options.runs / options.players) * levels.size();
  std::vector<std::size_t> own;
  for (std::size_t variation = 0; variation < all; ++variation) {
    if (options.shard.has(variation, all)) own.push_back(variation);
  }
  for (std::size_t k = 0; k < own.size(); ++k) {
    PromiseTrial trial(own[k], all, levels, options, measure_level);
    add(trial.rows(), static_cast<double>(k + 1) / static_cast<double>(own.size()));
  }
}

void validate_recommendations(std::span<const LevelFile> levels, const ValidationOptions& options,
                              const std::function<void(const std::vector<PromiseRow>&, double share)>& add) {
  validate_recommendations(levels, options, add,
                           [](const LevelFile& file, const std::vector<engine::TickInput>& inputs,
                              const StudyOptions& how) { return measure(file, inputs, how); });
}

std::vector<std::pair<std::string, std::vector<std::pair<std::string, Tally>>>> tallies_of(
    std::span<const PromiseRow> rows) {
  std::vector<std::pair<std::string, std::vector<std::pair<std::string, Tally>>>> tallies;
  for (const PromiseRow& row : rows) {
    auto& by_level = value_at(tallies, row.promise);
    count(value_at(by_level, ""), row);
    count(value_at(by_level, row.level), row);
  }
  return tallies;
}

std::string promises_header() { return "run,level,promise,setting,value,met,failure,holds_cord,level_hash"; }

std::string csv_of(const PromiseRow& row) {
  return std::to_string(row.run) + ',' + csv_cell(row.level) + ',' + row.promise + ',' + csv_cell(row.setting) + ',' +
         significant(row.value, 6) + ',' + (row.is_met ? '1' : '0') + ',' + csv_cell(row.failure) + ',' +
         (row.holds_cord ? '1' : '0') + ',' + row.level_hash;
}

std::vector<PromiseRow> read_promises(const std::string& path) {
  std::ifstream in(path);
  const std::string wanted = "; accepted is the output of --validate, or those of its shards one behind the other";
  std::string line;
  if (!in || !std::getline(in, line) || line != promises_header()) {
    throw std::runtime_error(path + ": cannot be read, or has another first line than " + promises_header() + wanted);
  }
  std::vector<PromiseRow> rows;
  for (int number = 2; std::getline(in, line); ++number) {
    try {
      rows.push_back(promise_row_of(csv_cells(line)));
    } catch (const std::logic_error&) {
      std::string what = path;
      what.append(", line ").append(std::to_string(number)).append(" is not a row").append(wanted);
      throw std::runtime_error(what);
    }
  }
  return rows;
}

}  // namespace study
