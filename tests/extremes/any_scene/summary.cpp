#include "tests/extremes/any_scene/summary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <stdexcept>

namespace any_scene {
namespace {

/// Returns the value that has this name.
template <typename Value, std::size_t Size>
Value named(const std::string& word, const std::array<Value, Size>& values) {
  const auto found = std::find_if(values.begin(), values.end(), [&](Value value) { return name(value) == word; });
  if (found == values.end()) throw std::invalid_argument("'" + word + "' is not accepted in a line of results");
  return *found;
}

constexpr std::array all_difficulties = {Difficulty::gentle, Difficulty::wild};
constexpr std::array all_ends = {End::completed, End::timed_out, End::broken, End::refused, End::crashed};

constexpr double bins_a_decade = 4.0;

std::string text(const std::map<int, int>& counts) {
  std::ostringstream out;
  for (const auto& [bin, count] : counts) out << (out.tellp() > 0 ? " " : "") << bin << ':' << count;
  return out.str();
}

std::map<int, int> counts_in(const std::string& text) {
  std::istringstream in(text);
  std::map<int, int> counts;
  int bin = 0;
  int count = 0;
  char colon = ':';
  while (in >> bin >> colon >> count) counts[bin] += count;
  return counts;
}

/// Removes the last cell of a line of CSV, and returns it.
std::string take_last_cell(std::string& line) {
  const std::size_t comma = line.rfind(',');
  std::string cell = comma == std::string::npos ? std::string() : line.substr(comma + 1);
  line.resize(std::min(comma, line.size()));
  return cell;
}

void add_late(Summary& sum, const Sample& tick) {
  sum.late_unconverged += tick.unconverged;
  sum.late_left = std::max(sum.late_left, tick.left);
  sum.late_stretch = std::max(sum.late_stretch, tick.stretch);
  sum.late_gap = std::max(sum.late_gap, tick.gaps.free);
  sum.late_gain = std::max(sum.late_gain, tick.gain);
}

/// Returns the most ticks one behind the other that hang.
int longest_hang(const std::vector<Sample>& ticks) {
  int most = 0;
  int now = 0;
  for (const Sample& tick : ticks) {
    now = tick.hangs ? now + 1 : 0;
    most = std::max(most, now);
  }
  return most;
}

void add(Summary& sum, const Scene& scene, const Sample& tick, int number) {
  ++sum.work[tick.work];
  sum.total_work += tick.work;
  if (tick.work > sum.max_work) sum.worst_tick = number;
  sum.max_work = std::max(sum.max_work, tick.work);
  sum.unconverged += tick.unconverged;
  if (tick.left > 0.0) ++(*sum.left)[bin_of(tick.left)];
  sum.stretch = std::max(sum.stretch, tick.stretch);
  sum.strain = std::max(sum.strain, tick.strain);
  sum.speed = std::max(sum.speed, tick.speed);
  sum.gain = std::max(sum.gain, tick.gain);
  sum.rise = std::max(sum.rise, tick.rise);
  sum.gap = std::max(sum.gap, tick.gaps.free);
  sum.gap_pressed = std::max(sum.gap_pressed, tick.gaps.pressed);
  sum.penetration = std::max(sum.penetration, tick.penetration.share);
  for (const CrossedPair& where : tick.crossings) {
    const auto solid = static_cast<std::size_t>(where.other);
    const bool fixed = where.solid && scene.solids[solid].motion == Motion::fixed;
    int& moving = where.pressed ? sum.crossings_pressed : sum.crossings_moving;
    ++(!where.solid ? sum.crossings : fixed ? sum.crossings_fixed : moving);
  }
  if (tick.late) add_late(sum, tick);
  sum.inverted += tick.inverted;
  sum.worst_ms = std::max(sum.worst_ms, tick.milliseconds);
  sum.seconds += 1e-3 * tick.milliseconds;
  const bool bad = tick.unconverged > 0 || !tick.crossings.empty() || tick.inverted > 0 || !tick.finite;
  if (bad && sum.first_bad < 0) sum.first_bad = number;
}

}  // namespace

Summary sum_up(const SceneId& which, const Scene& scene, const Outcome& outcome) {
  Summary sum;
  sum.which = which;
  sum.preset = scene.preset;
  sum.end = outcome.end;
  sum.ticks = static_cast<int>(outcome.ticks.size());
  sum.points = points(scene);
  for (int k = 0; k < sum.ticks; ++k) add(sum, scene, outcome.ticks[static_cast<std::size_t>(k)], k);
  sum.hanging = longest_hang(outcome.ticks);
  return sum;
}

int bin_of(double value) {
  return static_cast<int>(std::ceil(bins_a_decade * std::log10(std::clamp(value, 1e-30, 1e30))));
}

double end_of_bin(int bin) { return std::pow(10.0, bin / bins_a_decade); }

int all_crossings(const Summary& summary) {
  return summary.crossings + summary.crossings_fixed + summary.crossings_moving + summary.crossings_pressed;
}

std::string csv_header() {
  return "family,difficulty,preset,seed,end,ticks,points,unconverged,max_work,total_work,stretch,strain,speed,gain,"
         "rise,gap,"
         "gap_pressed,"
         "penetration,crossings,crossings_fixed,crossings_moving,crossings_pressed,inverted,worst_ms,seconds,worst_"
         "tick,first_bad,hanging,late_unconverged,late_left,late_stretch,late_gap,late_gain,work,left";
}

std::string to_csv(const Summary& sum) {
  std::ostringstream line;
  line << std::setprecision(6) << name(sum.which.family) << ',' << name(sum.which.difficulty) << ',' << name(sum.preset)
       << ',' << sum.which.seed << ',' << name(sum.end) << ',' << sum.ticks << ',' << sum.points << ','
       << sum.unconverged << ',' << sum.max_work << ',' << sum.total_work << ',' << sum.stretch << ',' << sum.strain
       << ',' << sum.speed << ',' << sum.gain << ',' << sum.rise << ',' << sum.gap << ',' << sum.gap_pressed << ','
       << sum.penetration << ',' << sum.crossings << ',' << sum.crossings_fixed << ',' << sum.crossings_moving << ','
       << sum.crossings_pressed << ',' << sum.inverted << ',' << sum.worst_ms << ',' << sum.seconds << ','
       << sum.worst_tick << ',' << sum.first_bad << ',' << sum.hanging << ',' << sum.late_unconverged << ','
       << sum.late_left << ',' << sum.late_stretch << ',' << sum.late_gap << ',' << sum.late_gain << ','
       << text(sum.work);
  if (sum.left) line << ',' << text(*sum.left);
  return line.str();
}

Summary from_csv(std::string_view text) {
  std::string line(text);
  const std::string header = csv_header();
  Summary sum;
  sum.left.reset();
  if (std::count(line.begin(), line.end(), ',') == std::count(header.begin(), header.end(), ',')) {
    sum.left = counts_in(take_last_cell(line));
  }
  sum.work = counts_in(take_last_cell(line));
  std::replace(line.begin(), line.end(), ',', ' ');
  std::istringstream in(line);
  std::string family;
  std::string difficulty;
  std::string preset;
  std::string end;
  in >> family >> difficulty >> preset >> sum.which.seed >> end >> sum.ticks >> sum.points >> sum.unconverged >>
      sum.max_work >> sum.total_work >> sum.stretch >> sum.strain >> sum.speed >> sum.gain >> sum.rise >> sum.gap >>
      sum.gap_pressed >> sum.penetration >> sum.crossings >> sum.crossings_fixed >> sum.crossings_moving >>
      sum.crossings_pressed >> sum.inverted >> sum.worst_ms >> sum.seconds >> sum.worst_tick >> sum.first_bad >>
      sum.hanging >> sum.late_unconverged >> sum.late_left >> sum.late_stretch >> sum.late_gap >> sum.late_gain;
  if (!in) throw std::invalid_argument("a line of results is not as they are written: " + line);
  sum.which.family = named(family, all_families);
  sum.which.difficulty = named(difficulty, all_difficulties);
  sum.preset = named(preset, all_presets);
  sum.which.preset = sum.preset;
  sum.end = named(end, all_ends);
  return sum;
}

}  // namespace any_scene
