#include "tests/study/report.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "tests/study/words.h"

namespace study {
namespace {

std::string number(double value) { return significant(value, 4); }

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '<') {
      safe += "&lt;";
    } else if (c == '>') {
      safe += "&gt;";
    } else if (c == '&') {
      safe += "&amp;";
    } else {
      safe += c;
    }
  }
  return safe;
}

void write(const std::string& path, const std::string& content) {
  std::ofstream out(path, std::ios::binary);
  out << content;
  out.flush();
  if (!out) throw std::runtime_error("cannot write " + path + "; accepted is a folder that can be written (--out)");
}

std::vector<std::string> methods_of(const Report& report) {
  std::vector<std::string> methods;
  for (const Point& point : report.points) {
    if (std::find(methods.begin(), methods.end(), point.method) == methods.end()) methods.push_back(point.method);
  }
  return methods;
}

/// Above all errors: where failures are drawn.
double top_of(const Report& report) {
  double most = 1e-3;
  for (const Point& point : report.points) {
    if (point.failure.empty() && std::isfinite(point.error_m)) most = std::max(most, point.error_m);
  }
  return 4.0 * most;
}

bool is_shown(const Point& point) { return point.failure.empty() && std::isfinite(point.error_m); }

std::string csv_of(const Report& report) {
  std::ostringstream out;
  out << "method,setting,cost_us,p99_us,error_m,failure";
  for (const std::string& column : report.columns) out << ',' << column;
  out << '\n';
  for (std::size_t k = 0; k < report.points.size(); ++k) {
    const Point& p = report.points[k];
    out << p.method << ',' << p.setting << ',' << number(p.cost_us) << ',' << number(p.p99_us) << ','
        << (is_shown(p) ? number(p.error_m) : "") << ',' << p.failure;
    if (k < report.cells.size()) {
      for (const std::string& cell : report.cells[k]) out << ',' << cell;
    }
    out << '\n';
  }
  return out.str();
}

std::string json_of(const Report& report) {
  nlohmann::ordered_json json{{"title", report.title}, {"notes", report.notes}};
  const std::vector<std::size_t> on_front = front(report.points);
  for (std::size_t k = 0; k < report.points.size(); ++k) {
    const Point& p = report.points[k];
    nlohmann::ordered_json entry{
        {"method", p.method}, {"setting", p.setting}, {"cost_us", p.cost_us}, {"p99_us", p.p99_us}};
    entry["error_m"] = is_shown(p) ? nlohmann::ordered_json(p.error_m) : nlohmann::ordered_json();
    entry["failure"] = p.failure;
    entry["front"] = std::find(on_front.begin(), on_front.end(), k) != on_front.end();
    for (std::size_t c = 0; c < report.columns.size() && k < report.cells.size(); ++c) {
      entry[report.columns[c]] = report.cells[k][c];
    }
    json["points"].push_back(entry);
  }
  return json.dump(1) + "\n";
}

std::string html_of(const Report& report) {
  std::ostringstream out;
  out << "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<title>" << escaped(report.title)
      << "</title>\n<style>\nbody{font:16px/1.5 sans-serif;max-width:70em;margin:2em auto;padding:0 1em}\n"
         "table{border-collapse:collapse}\ntd,th{padding:.2em .8em;text-align:right;border-bottom:1px solid #ddd}\n"
         "td:nth-child(-n+2),th:nth-child(-n+2){text-align:left}\ntr.front{font-weight:bold}\ntr.failed{color:#a00}\n"
         "img{max-width:100%}\n</style>\n<h1>"
      << escaped(report.title) << ": what accuracy costs</h1>\n";
  for (const std::string& note : report.notes) out << "<p>" << escaped(note) << "</p>\n";
  out << "<p><img src=\"front.svg\" alt=\"Error against cost, both logarithmic\"></p>\n"
         "<p>Bold: no other setting is both cheaper and more exact.</p>\n<table>\n<tr><th>method<th>setting<th>µs a "
         "tick<th>99 of 100 below<th>error [m]";
  for (const std::string& column : report.columns) out << "<th>" << escaped(column);
  out << "\n";
  const std::vector<std::size_t> on_front = front(report.points);
  for (std::size_t k = 0; k < report.points.size(); ++k) {
    const Point& p = report.points[k];
    const bool best = std::find(on_front.begin(), on_front.end(), k) != on_front.end();
    out << (best          ? "<tr class=\"front\">"
            : is_shown(p) ? "<tr>"
                          : "<tr class=\"failed\">")
        << "<td>" << escaped(p.method) << "<td>" << escaped(p.setting) << "<td>" << number(p.cost_us) << "<td>"
        << number(p.p99_us) << "<td>"
        << (is_shown(p) ? number(p.error_m) : escaped(p.failure.empty() ? "no number" : p.failure));
    if (k < report.cells.size()) {
      for (const std::string& cell : report.cells[k]) out << "<td>" << escaped(cell);
    }
    out << "\n";
  }
  out << "</table>\n</html>\n";
  return out.str();
}

}  // namespace

std::string plot_of(const Report& report) {
  std::ostringstream out;
  const std::vector<std::string> methods = methods_of(report);
  const double top = top_of(report);
  for (std::size_t m = 0; m < methods.size(); ++m) {
    out << "$method" << m << " << END\n";
    bool any = false;
    for (const Point& p : report.points) {
      if (p.method != methods[m] || !is_shown(p)) continue;
      out << number(p.cost_us) << ' ' << number(std::max(p.error_m, 1e-12)) << '\n';
      any = true;
    }
    if (!any) out << "NaN NaN\n";
    out << "END\n";
  }
  out << "$front << END\n";
  for (const std::size_t k : front(report.points)) {
    out << number(report.points[k].cost_us) << ' ' << number(std::max(report.points[k].error_m, 1e-12)) << '\n';
  }
  out << "END\n$failed << END\nNaN NaN\n";
  for (const Point& p : report.points) {
    if (!is_shown(p)) out << number(p.cost_us) << ' ' << number(top) << '\n';
  }
  out << "END\n"
         "set terminal svg size 960,640 font 'DejaVu Sans,13' background rgb 'white'\n"
         "set output 'front.svg'\n"
         "set logscale xy\nset format x '10^{%L}'\nset format y '10^{%L}'\nset grid\n"
         "set xlabel 'cost [µs a tick]'\nset ylabel 'error [m]'\nset key outside right center\nset offsets graph 0.02, "
         "graph "
         "0.02, 0, 0\n"
      << "set xrange [*:20000<*]\nset yrange [*:" << number(1.5 * top) << "]\n"
      << "set arrow from 16700, graph 0 to 16700, graph 1 nohead dashtype 2 linecolor 'gray'\n"
         "set arrow from 1000, graph 0 to 1000, graph 1 nohead dashtype 2 linecolor 'gray'\n"
         "set label '1 ms' at 1000, graph 0.97 right offset -0.5,0\n"
         "set label '16.7 ms' at 16700, graph 0.97 right offset -0.5,0\n"
         "plot $front using 1:2 with lines linewidth 2 linecolor 'black' title 'front'";
  for (std::size_t m = 0; m < methods.size(); ++m) {
    std::string title = methods[m];
    std::replace(title.begin(), title.end(), '_', ' ');
    out << ", $method" << m << " using 1:2 with points pointtype " << m + 4 << " pointsize 0.9 title '" << title << "'";
  }
  out << ", $failed using 1:2 with points pointtype 2 pointsize 1.2 linecolor 'red' title 'failed'\n";
  return out.str();
}

void write_report(const Report& report, const std::string& folder) {
  std::error_code ignored;
  std::filesystem::create_directories(folder, ignored);
  write(folder + "/points.csv", csv_of(report));
  write(folder + "/points.json", json_of(report));
  write(folder + "/front.gp", plot_of(report));
  write(folder + "/index.html", html_of(report));
  const std::string command = "cd '" + folder + "' && gnuplot front.gp > gnuplot.log 2>&1";
  if (std::system(command.c_str()) != 0) {
    throw std::runtime_error("gnuplot did not draw " + folder + "/front.svg (see gnuplot.log there); the package is " +
                             "gnuplot-nox, game/setup tests installs it. All numbers are written");
  }
  std::filesystem::remove(folder + "/gnuplot.log", ignored);
}

}  // namespace study
