#include "tests/extremes/any_scene/plot.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "tests/extremes/any_scene/statistics.h"

namespace any_scene {
namespace {

using Runs = std::vector<Summary>;

constexpr const char* before_color = "'#b0b0b0'";
constexpr const char* before_text_color = "'#606060'";
constexpr const char* now_color = "'#0072b2'";

struct Bar {
  double from;
  double to;
  long count;
};

struct Histogram {
  std::vector<Bar> bars;
  long all = 0;         // the denominator of a bar's share
  std::string figures;  // as text
};

/// Bins by powers of ten.
std::vector<Bar> bars_of(const std::map<int, long>& counts) {
  std::vector<Bar> bars;
  for (const auto& [bin, count] : counts) bars.push_back({end_of_bin(bin - 1), end_of_bin(bin), count});
  return bars;
}

std::string percent(long count, long all) {
  std::ostringstream out;
  out << std::setprecision(2) << 100.0 * static_cast<double>(count) / static_cast<double>(all) << " %";
  return out.str();
}

/// Returns the histogram of ticks by linear systems. A bar extends from n − ½ to n + ½, so that 0 has a place on the
/// logarithmic axis.
Histogram work_of(const Runs& runs) {
  std::map<int, int> ticks;
  std::map<int, long> bins;
  Histogram all;
  for (const Summary& run : runs) {
    for (const auto& [work, count] : run.work) {
      ticks[work] += count;
      bins[end_of_work_bin(work)] += count;
      all.all += count;
    }
  }
  for (const auto& [end, count] : bins) {
    int begin = end;
    while (begin > 0 && end_of_work_bin(begin - 1) == end) --begin;
    all.bars.push_back({end == 0 ? 0.25 : begin - 0.5, end + 0.5, count});
  }
  if (all.all == 0) return all;
  all.figures = "99.9 % of ticks up to " + std::to_string(quantile_of_ticks(ticks, 0.999)) + ", most " +
                std::to_string(ticks.rbegin()->first);
  return all;
}

/// Returns the histogram of ticks by their residual, m.
Histogram left_of(const Runs& runs) {
  std::map<int, long> bins;
  Histogram all;
  long unsolved = 0;
  long substeps = 0;
  bool is_reported = false;
  for (const Summary& run : runs) {
    all.all += run.ticks;
    substeps += run.unconverged;
    if (!run.left) continue;
    is_reported = true;
    for (const auto& [bin, count] : *run.left) {
      bins[bin] += count;
      unsolved += count;
    }
  }
  all.bars = bars_of(bins);
  if (all.all == 0) return all;
  all.figures = is_reported ? percent(unsolved, all.all) + " of ticks unsolved"
                            : std::to_string(substeps) + " substeps unsolved, residual not reported";
  return all;
}

/// Returns the histogram of scenes by the greatest relative length error of their inextensible ropes.
Histogram stretch_of(const Runs& runs) {
  std::map<int, long> bins;
  Histogram all;
  long above = 0;
  for (const Summary& run : runs) {
    if (run.stretch == 0.0) continue;
    ++bins[bin_of(run.stretch)];
    ++all.all;
    above += run.stretch > 0.01 ? 1 : 0;
  }
  all.bars = bars_of(bins);
  if (all.all > 0) all.figures = std::to_string(above) + " of " + std::to_string(all.all) + " scenes above 1 %";
  return all;
}

/// A row of panels, one for each preset.
struct Kind {
  const char* name;
  const char* axis;
  const char* share_of;
  bool log_share;
  const char* range;
  Histogram (*of)(const Runs&);
};

constexpr std::array kinds = {
    Kind{"work", "linear systems solved in a tick", "share of ticks", true, "[0.25:3e5]", work_of},
    Kind{"left", "left unsolved in a tick [m]", "share of ticks", true, "[1e-7:1e2]", left_of},
    Kind{"stretch", "the greatest stretch in a scene", "share of scenes", false, "[1e-9:1e2]", stretch_of},
};

/// Quotes a string for gnuplot.
std::string quoted(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("''") : std::string(1, c);
  return word + "'";
}

double share(const Bar& bar, const Histogram& histogram) {
  return static_cast<double>(bar.count) / static_cast<double>(histogram.all);
}

/// Returns the closed outline of the bars as a gnuplot data block.
std::string block(const std::string& name, const Histogram& histogram, double least_share) {
  std::ostringstream out;
  out << name << " << END\n";
  for (const Bar& bar : histogram.bars) {
    const double top = share(bar, histogram);
    out << bar.from << ' ' << least_share << '\n' << bar.from << ' ' << top << '\n';
    out << bar.to << ' ' << top << '\n' << bar.to << ' ' << least_share << '\n';
  }
  out << "END\n";
  return out.str();
}

std::string label(const char* when, const Histogram& histogram, double height, const char* color) {
  if (histogram.figures.empty()) return {};
  std::ostringstream out;
  out << "set label " << quoted(std::string(when) + ": " + histogram.figures) << " at graph 0.98, " << height
      << " right textcolor rgb " << color << " noenhanced\n";
  return out.str();
}

/// Sets the axis of shares, with space for labels above 1, or above the highest bar. Returns the bars' base.
double set_shares(std::ostream& out, const Kind& kind, const Histogram& before, const Histogram& now) {
  if (kind.log_share) {
    const double least = 0.5 / static_cast<double>(std::max({before.all, now.all, 1L}));
    out << "set logscale y\nset format y '10^{%L}'\nset ytics 1e-9, 10, 1\nset yrange [" << least << ":30]\n";
    return least;
  }
  double most = 0.0;
  for (const Histogram* histogram : {&before, &now}) {
    for (const Bar& bar : histogram->bars) most = std::max(most, share(bar, *histogram));
  }
  out << "unset logscale y\nset format y '%g'\nset ytics autofreq\nset yrange [0:" << (most > 0.0 ? 1.4 * most : 1.0)
      << "]\n";
  return 0.0;
}

/// Draws the earlier solver in grey, behind the current one.
std::string panel(const Kind& kind, const std::string& name, const Histogram& before, const Histogram& now) {
  std::ostringstream out;
  out << "unset label\n" << label("before", before, 0.93, before_text_color) << label("now", now, 0.84, now_color);
  out << "set xlabel " << quoted(kind.axis) << "\nset xrange " << kind.range << '\n';
  const double least_share = set_shares(out, kind, before, now);
  std::string layers = "NaN notitle";
  const auto add = [&](const std::string& when, const Histogram& histogram, const std::string& style) {
    if (histogram.bars.empty()) return;
    const std::string data = "$" + name + when;
    out << block(data, histogram, least_share);
    layers += ", " + data + " using 1:2 with filledcurves closed notitle fillstyle " + style;
  };
  add("_before", before, std::string("solid 1.0 noborder fillcolor ") + before_color);
  add("_now", now, std::string("transparent solid 0.6 noborder fillcolor ") + now_color);
  out << "plot " << layers << '\n';
  return out.str();
}

Runs with_preset(const Runs& runs, Preset preset) {
  Runs some;
  std::copy_if(runs.begin(), runs.end(), std::back_inserter(some),
               [&](const Summary& run) { return run.preset == preset; });
  return some;
}

}  // namespace

std::string plot_of(const std::vector<Summary>& runs, const std::vector<Summary>& before, const std::string& path) {
  std::ostringstream out;
  out << "set terminal svg size 1200,960 font 'DejaVu Sans,12' background rgb 'white'\nset output " << quoted(path)
      << "\nset multiplot layout " << kinds.size() << ',' << usual_presets.size()
      << " margins 0.07, 0.985, 0.07, 0.96 spacing 0.045, 0.09\n"
      << "set logscale x\nset format x '10^{%L}'\nset mxtics 1\nset mytics 1\nset grid\n";
  for (const Kind& kind : kinds) {
    for (const Preset preset : usual_presets) {
      const std::string title(name(preset));
      out << "set title '" << (&kind == kinds.data() ? title : "") << "'\nset ylabel '"
          << (preset == usual_presets.front() ? kind.share_of : "") << "'\n"
          << panel(kind, kind.name + std::string("_").append(title), kind.of(with_preset(before, preset)),
                   kind.of(with_preset(runs, preset)));
    }
  }
  out << "unset multiplot\n";
  return out.str();
}

void draw(const std::vector<Summary>& runs, const std::vector<Summary>& before, const std::string& path) {
  const std::filesystem::path script =
      std::filesystem::temp_directory_path() / ("any_scene_" + std::to_string(::getpid()) + ".gp");
  std::ofstream(script, std::ios::binary) << plot_of(runs, before, path);
  const bool is_drawn = std::system(("gnuplot '" + script.string() + "'").c_str()) == 0;
  std::error_code ignored;
  std::filesystem::remove(script, ignored);
  if (is_drawn) return;
  throw std::runtime_error("cannot draw " + path +
                           "; accepted is a file that can be written, and gnuplot (game/setup tests installs it)");
}

}  // namespace any_scene
