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

#include "tests/study/words.h"

namespace study {
namespace {

/// Told apart by who does not see red and green alike too.
constexpr std::array<const char*, 8> colors = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                               "#e69f00", "#56b4e9", "#7f3c8d", "#666666"};

std::string number(double value) { return significant(value, 4); }

bool is_drawn(const Point& point) { return point.failure.empty() && std::isfinite(point.error_m); }

std::vector<std::string> methods_of(std::span<const Point> points) {
  std::vector<std::string> methods;
  for (const Point& point : points) {
    if (std::find(methods.begin(), methods.end(), point.method) == methods.end()) methods.push_back(point.method);
  }
  return methods;
}

/// The least and the greatest error above 0 that is drawn; 1 if there is none.
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

/// The least and the greatest cost that is drawn, the same for all groups, µs.
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

/// As one word for a shell, whatever is in it.
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

/// One group's plot: blocks of data under names of its own, and what draws them.
class Panel {
 public:
  Panel(std::span<const Point> points, const std::string& group, std::size_t index)
      : group_(group), suffix_(std::string("_").append(std::to_string(index))) {
    for (const Point& point : points) {
      if (point.group == group) points_.push_back(point);
    }
    const auto [least, most] = range_of(points_);
    bottom_ = 0.3 * least;
    top_ = 4.0 * most;
  }

  /// `methods` are those of all groups, so that each looks the same in all of them.
  std::string text(const std::vector<std::string>& methods) {
    std::vector<Point> best;
    for (const std::size_t k : front(points_)) best.push_back(points_[k]);
    add("front", best, "lines linewidth 2 linecolor 'black' title 'front'");
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const std::string color = std::string(" linecolor '") + colors.at(m % colors.size()) + "'";
      const std::string mark = "points pointtype " + std::to_string(m + 4) + color;
      const auto title = [&](const char* more) { return " title '" + methods[m] + more + "' noenhanced"; };
      const auto those = [&](auto&& take) {
        std::vector<Point> some;
        std::copy_if(points_.begin(), points_.end(), std::back_inserter(some),
                     [&](const Point& p) { return p.method == methods[m] && take(p); });
        return some;
      };
      const std::string index = std::to_string(m);
      add("method" + index, those([](const Point& p) { return is_drawn(p) && !p.apart; }),
          mark + " pointsize 0.9" + title(""));
      add("apart" + index, those([](const Point& p) { return is_drawn(p) && p.apart; }),
          mark + " pointsize 0.4" + title(", not compared"));
      add("failed" + index, those([](const Point& p) { return !p.failure.empty(); }),
          "points pointtype 2 linewidth 2 pointsize 0.9" + color + title(", failed"));
    }
    std::ostringstream out;
    out << data_.str() << "set title '" << group_ << "' noenhanced\nset yrange [" << number(0.5 * bottom_) << ':'
        << number(1.5 * top_) << "]\nplot " << (layers_.empty() ? "NaN notitle" : layers_) << '\n';
    return out.str();
  }

 private:
  /// A logarithm has no 0: that is drawn below the least.
  void add(const std::string& name, const std::vector<Point>& points, const std::string& style) {
    if (points.empty()) return;
    data_ << '$' << name << suffix_ << " << END\n";
    for (const Point& p : points) {
      data_ << number(p.cost_us) << ' ' << number(p.failure.empty() ? std::max(p.error_m, bottom_) : top_) << '\n';
    }
    data_ << "END\n";
    layers_ += (layers_.empty() ? "$" : ", $") + name + suffix_ + " using 1:2 with " + style;
  }

  std::string group_;
  std::string suffix_;
  std::vector<Point> points_;
  double bottom_ = 0.0;
  double top_ = 0.0;
  std::ostringstream data_;
  std::string layers_;
};

}  // namespace

std::string plot_of(std::span<const Point> points, const std::string& axis, const std::string& name) {
  const std::vector<std::string> groups = groups_of(points);
  const std::vector<std::string> methods = methods_of(points);
  const std::size_t columns = groups.size() > 1 ? 2 : 1;
  const std::size_t rows = (groups.size() + columns - 1) / columns;
  const auto [least, most] = costs_of(points);
  const double right = std::max(1.4 * most, 1500.0);
  std::ostringstream out;
  out << "set terminal svg size " << (columns > 1 ? 1200 : 960) << ',' << (columns > 1 ? 440 * rows : 640)
      << " font 'DejaVu Sans,13' background rgb 'white'\n"
      << "set output '" << name << ".svg'\n"
      << "set logscale xy\nset format x '10^{%L}'\nset format y '10^{%L}'\nset grid\n"
      << "set xlabel 'cost [µs a tick]'\nset ylabel '" << axis << "' noenhanced\n"
      << "set key outside right center\nset xrange [" << number(0.7 * least) << ':' << number(right) << "]\n";
  for (const auto& [us, label] : {std::pair{1000, "1 ms"}, {16700, "16.7 ms"}}) {
    if (us > right) continue;
    out << "set arrow from " << us << ", graph 0 to " << us << ", graph 1 nohead dashtype 2 linecolor 'gray'\n"
        << "set label '" << label << "' at " << us << ", graph 0.03 right offset -0.5,0\n";
  }
  if (columns > 1) out << "set multiplot layout " << rows << ',' << columns << '\n';
  for (std::size_t g = 0; g < groups.size(); ++g) out << Panel(points, groups[g], g).text(methods);
  if (columns > 1) out << "unset multiplot\n";
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
