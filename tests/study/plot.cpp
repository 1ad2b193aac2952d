#include "tests/study/plot.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <vector>

#include "tests/study/words.h"

namespace study {
namespace {

constexpr double least = 1e-12;  // drawn, for a logarithm has no 0

std::string number(double value) { return significant(value, 4); }

bool is_drawn(const Point& point) { return point.failure.empty() && std::isfinite(point.error_m); }

std::vector<std::string> methods_of(std::span<const Point> points) {
  std::vector<std::string> methods;
  for (const Point& point : points) {
    if (std::find(methods.begin(), methods.end(), point.method) == methods.end()) methods.push_back(point.method);
  }
  return methods;
}

/// Above all errors: where failures are drawn.
double top_of(std::span<const Point> points) {
  double most = 0.0;
  for (const Point& point : points) {
    if (is_drawn(point)) most = std::max(most, point.error_m);
  }
  return most > 0.0 ? 4.0 * most : 1.0;
}

/// A block of data by name; gnuplot does without one that is empty only if it has a line that is no number.
template <typename Take>
void add_data(std::ostringstream& out, const std::string& name, std::span<const Point> points, Take&& take) {
  out << '$' << name << " << END\n";
  bool any = false;
  for (const Point& p : points) {
    if (!take(p)) continue;
    out << number(p.cost_us) << ' ' << number(std::max(p.error_m, least)) << '\n';
    any = true;
  }
  out << (any ? "END\n" : "NaN NaN\nEND\n");
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

}  // namespace

std::string plot_of(std::span<const Point> points, const std::string& axis, const std::string& name) {
  std::ostringstream out;
  const std::vector<std::string> methods = methods_of(points);
  const double top = top_of(points);
  for (std::size_t m = 0; m < methods.size(); ++m) {
    add_data(out, "method" + std::to_string(m), points,
             [&](const Point& p) { return p.method == methods[m] && is_drawn(p); });
  }
  std::vector<Point> best;
  for (const std::size_t k : front(points)) best.push_back(points[k]);
  add_data(out, "front", best, [](const Point&) { return true; });
  std::vector<Point> failed(points.begin(), points.end());
  for (Point& point : failed) point.error_m = top;
  add_data(out, "failed", failed, [](const Point& p) { return !p.failure.empty(); });

  out << "set terminal svg size 960,640 font 'DejaVu Sans,13' background rgb 'white'\n"
      << "set output '" << name << ".svg'\n"
      << "set logscale xy\nset format x '10^{%L}'\nset format y '10^{%L}'\nset grid\n"
      << "set xlabel 'cost [µs a tick]'\nset ylabel '" << axis << "' noenhanced\n"
      << "set key outside right center\nset offsets graph 0.02, graph 0.02, 0, 0\n"
      << "set xrange [*:20000<*]\nset yrange [*:" << number(1.5 * top) << "]\n";
  for (const auto& [us, label] : {std::pair{1000, "1 ms"}, {16700, "16.7 ms"}}) {
    out << "set arrow from " << us << ", graph 0 to " << us << ", graph 1 nohead dashtype 2 linecolor 'gray'\n"
        << "set label '" << label << "' at " << us << ", graph 0.97 right offset -0.5,0\n";
  }
  out << "plot $front using 1:2 with lines linewidth 2 linecolor 'black' title 'front'";
  for (std::size_t m = 0; m < methods.size(); ++m) {
    out << ", $method" << m << " using 1:2 with points pointtype " << m + 4 << " pointsize 0.9 title '" << methods[m]
        << "' noenhanced";
  }
  out << ", $failed using 1:2 with points pointtype 2 pointsize 1.2 linecolor 'red' title 'failed'\n";
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
