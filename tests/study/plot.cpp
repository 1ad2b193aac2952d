#include "tests/study/plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <limits>
#include <sstream>
#include <vector>

#include "tests/study/text.h"

namespace study {
namespace {

/// Colours that can be distinguished with red-green colour blindness.
constexpr std::array<const char*, 8> colors = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                               "#e69f00", "#56b4e9", "#7f3c8d", "#666666"};

bool is_drawn(const Point& point) { return point.failure.empty() && std::isfinite(point.error_m); }

std::vector<std::string> methods_of(std::span<const Point> points) {
  std::vector<std::string> methods;
  for (const Point& point : points) {
    if (std::find(methods.begin(), methods.end(), point.method) == methods.end()) methods.push_back(point.method);
  }
  return methods;
}

/// The smallest and largest drawn error above 0; 1 if there is none.
std::pair<double, double> range_of(std::span<const Point> points) {
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
  for (const Point& point : points) {
    if (!is_drawn(point) || point.error_m <= 0.0) continue;
    least = std::min(least, point.error_m);
    most = std::max(most, point.error_m);
  }
  return most > 0.0 ? std::pair{least, most} : std::pair{1.0, 1.0};
}

/// The smallest and largest drawn cost of all groups, µs.
std::pair<double, double> costs_of(std::span<const Point> points) {
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
  for (const Point& point : points) {
    if ((!is_drawn(point) && point.failure.empty()) || !(point.cost_us > 0.0)) continue;
    least = std::min(least, point.cost_us);
    most = std::max(most, point.cost_us);
  }
  return most > 0.0 ? std::pair{least, most} : std::pair{1.0, 1.0};
}

/// Quotes any text as one word for a shell.
std::string in_shell_quotes(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'') {
      quoted += "'\\''";
    } else {
      quoted += c;
    }
  }
  return quoted + "'";
}

std::string color_of(std::size_t method) {
  return std::string(" linecolor '") + colors.at(method % colors.size()) + "'";
}

std::string mark_of(std::size_t method) { return "points pointtype " + std::to_string(method + 4) + color_of(method); }

/// The definitions of the marks, once for all groups.
std::string legend_of(std::span<const Point> points, const std::vector<std::string>& methods) {
  std::string legend = ", keyentry with lines linewidth 2 linecolor 'black' title 'front'";
  for (std::size_t m = 0; m < methods.size(); ++m) {
    legend += ", keyentry with " + mark_of(m) + " title '" + methods[m] + "' noenhanced";
  }
  if (std::any_of(points.begin(), points.end(), [](const Point& p) { return !p.failure.empty(); })) {
    legend += ", keyentry with points pointtype 2 linewidth 2 linecolor 'black' title 'failed'";
  }
  if (std::any_of(points.begin(), points.end(), [](const Point& p) { return p.not_compared; })) {
    legend += ", keyentry with points pointtype 7 pointsize 0.3 linecolor 'black' title 'not compared'";
  }
  return legend;
}

/// The plot of a group: blocks of data with their names, and the commands that draw them.
class Panel {
 public:
  Panel(std::span<const Point> points, const std::string& group, std::size_t index)
      : group_(group), suffix_(std::string("_").append(std::to_string(index))) {
    std::copy_if(points.begin(), points.end(), std::back_inserter(points_),
                 [&](const Point& p) { return p.group == group; });
    const auto [least, most] = range_of(points_);
    bottom_ = 0.3 * least;
    top_ = 4.0 * most;
  }

  /// `methods` are those of all groups, so that each has the same mark in all of them.
  std::string text(const std::vector<std::string>& methods, const std::string& legend) {
    std::vector<Point> best;
    for (const std::size_t k : front(points_)) best.push_back(points_[k]);
    add("front", best, "lines linewidth 2 linecolor 'black'");
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const auto those = [&](auto&& take) {
        std::vector<Point> some;
        std::copy_if(points_.begin(), points_.end(), std::back_inserter(some),
                     [&](const Point& p) { return p.method == methods[m] && take(p); });
        return some;
      };
      const std::string index = std::to_string(m);
      add("method" + index, those([](const Point& p) { return is_drawn(p) && !p.not_compared; }), mark_of(m));
      add("not_compared" + index, those([](const Point& p) { return is_drawn(p) && p.not_compared; }),
          mark_of(m) + " pointsize 0.4");
      add("failed" + index, those([](const Point& p) { return !p.failure.empty(); }),
          "points pointtype 2 linewidth 2" + color_of(m));
    }
    std::ostringstream out;
    out << data_.str() << "set title '" << group_ << "' noenhanced\nset yrange [" << four_digits(0.5 * bottom_) << ':'
        << four_digits(1.5 * top_) << "]\nplot NaN notitle" << layers_ << legend << '\n';
    return out.str();
  }

 private:
  /// On a logarithmic axis 0 is drawn below the smallest value.
  void add(const std::string& name, const std::vector<Point>& points, const std::string& style) {
    if (points.empty()) return;
    data_ << '$' << name << suffix_ << " << END\n";
    for (const Point& p : points) {
      data_ << four_digits(p.cost_us) << ' ' << four_digits(p.failure.empty() ? std::max(p.error_m, bottom_) : top_)
            << '\n';
    }
    data_ << "END\n";
    layers_ += ", $" + name + suffix_ + " using 1:2 with " + style + " notitle";
  }

  std::string group_;
  std::string suffix_;
  std::vector<Point> points_;
  double bottom_ = 0.0;
  double top_ = 0.0;
  std::ostringstream data_;
  std::string layers_;
};

/// Returns the width of the legend without its marks, px.
double width_of(const std::vector<std::string>& names) {
  std::size_t longest = 12;  // not compared
  for (const std::string& name : names) longest = std::max(longest, name.size());
  return 95.0 + 8.5 * static_cast<double>(longest);
}

/// The layout of panels of equal size, two per row, and of the legend to their right.
std::string layout_of(std::size_t panels, double legend, const std::string& name) {
  const std::size_t columns = panels > 1 ? 2 : 1;
  const std::size_t rows = (panels + columns - 1) / columns;
  const double width = (columns > 1 ? 1000.0 : 760.0) + legend;
  const double height = columns > 1 ? 400.0 * static_cast<double>(rows) : 640.0;
  std::ostringstream out;
  out << "set terminal svg size " << four_digits(width) << ',' << four_digits(height)
      << " font 'DejaVu Sans,13' background rgb 'white'\n"
      << "set output '" << name << ".svg'\n"
      << "set multiplot layout " << rows << ',' << columns << " margins " << four_digits(90.0 / width) << ','
      << four_digits(1.0 - legend / width) << ',' << four_digits(60.0 / height) << ','
      << four_digits(1.0 - 40.0 / height) << " spacing " << four_digits(100.0 / width) << ','
      << four_digits(100.0 / height) << '\n';
  return out.str();
}

}  // namespace

std::string plot_of(std::span<const Point> points, const std::string& axis, const std::string& name) {
  const std::vector<std::string> groups = groups_of(points);
  const std::vector<std::string> methods = methods_of(points);
  const auto [least, most] = costs_of(points);
  const double left = 0.7 * least;
  const double right = std::max(1.4 * most, 1500.0);
  std::ostringstream out;
  out << layout_of(groups.size(), width_of(methods), name);
  out << "set logscale xy\nset format x '10^{%L}'\nset format y '10^{%L}'\nset grid\n"
      << "set xlabel 'cost [µs a tick]'\nset ylabel '" << axis << "' noenhanced\n"
      << "set xrange [" << four_digits(left) << ':' << four_digits(right) << "]\n";
  for (const auto& [us, label] : {std::pair{1000, "1 ms"}, {16700, "16.7 ms"}}) {
    if (us < 3.0 * left || us > right) continue;
    out << "set arrow from " << us << ", graph 0 to " << us << ", graph 1 nohead dashtype 2 linecolor 'gray'\n"
        << "set label '" << label << "' at " << us << ", graph 0.03 right offset -0.5,0\n";
  }
  const std::size_t upper_right = groups.size() > 1 ? 1 : 0;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const bool has_legend = g == upper_right;
    out << (has_legend ? "set key outside right top Left reverse samplen 2\n" : "unset key\n")
        << Panel(points, groups[g], g).text(methods, has_legend ? legend_of(points, methods) : "");
  }
  out << "unset multiplot\n";
  return out.str();
}

bool draw(const std::string& folder, const std::string& name) {
  const std::string command =
      "cd " + in_shell_quotes(folder) + " && gnuplot " + in_shell_quotes(name + ".gp") + " > gnuplot.log 2>&1";
  if (std::system(command.c_str()) != 0) return false;
  std::error_code ignored;
  std::filesystem::remove(folder + "/gnuplot.log", ignored);
  return true;
}

}  // namespace study
